#pragma once

#include <planish/base/assert.hpp>

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <ranges>
#include <type_traits>
#include <utility>
#include <vector>

namespace planish {

/// A vector indexed by a strong id: `enum class FaceId : int {}`, from 0 on. A subscript takes only
/// that id, so a bend's id never finds a face; an id out of range fails an assertion. Iterators run
/// over the elements, `ids()` over their ids.
template <typename Id, typename T>
class IdVector {
 public:
  using Rows = std::vector<T>;

  IdVector() = default;
  IdVector(std::initializer_list<T> rows) : rows_(rows) {}
  explicit IdVector(std::size_t count, const T& value = T()) : rows_(count, value) {}

  bool has(Id id) const {
    return static_cast<int>(id) >= 0 && static_cast<std::size_t>(id) < rows_.size();
  }
  typename Rows::reference operator[](Id id) {
    PLANISH_ASSERT(has(id));
    return rows_[static_cast<std::size_t>(id)];
  }
  typename Rows::const_reference operator[](Id id) const {
    PLANISH_ASSERT(has(id));
    return rows_[static_cast<std::size_t>(id)];
  }

  /// Returns the id of the added element.
  Id push_back(T row) {
    rows_.push_back(std::move(row));
    return static_cast<Id>(rows_.size() - 1);
  }
  template <typename... Arguments>
  T& emplace_back(Arguments&&... arguments) {
    return rows_.emplace_back(std::forward<Arguments>(arguments)...);
  }
  void assign(std::size_t count, const T& value) { rows_.assign(count, value); }
  void resize(std::size_t count) { rows_.resize(count); }
  void reserve(std::size_t count) { rows_.reserve(count); }
  void clear() { rows_.clear(); }

  auto ids() const {
    return std::views::iota(0, static_cast<int>(rows_.size())) |
           std::views::transform([](int i) { return static_cast<Id>(i); });
  }
  std::size_t size() const { return rows_.size(); }
  bool empty() const { return rows_.empty(); }

  auto begin() { return rows_.begin(); }
  auto end() { return rows_.end(); }
  auto begin() const { return rows_.begin(); }
  auto end() const { return rows_.end(); }
  typename Rows::reference front() { return rows_.front(); }
  typename Rows::const_reference front() const { return rows_.front(); }
  typename Rows::reference back() { return rows_.back(); }
  typename Rows::const_reference back() const { return rows_.back(); }

 private:
  Rows rows_;
};

/// A vector of what `function`, which may be a member, makes of each element of a range.
template <typename Range, typename Function>
auto mapped(Range&& range, const Function& function) {
  using Made = std::invoke_result_t<const Function&, std::ranges::range_reference_t<Range>>;
  std::vector<std::remove_cvref_t<Made>> made;
  if constexpr (std::ranges::sized_range<Range>) made.reserve(std::ranges::size(range));
  for (auto&& one : range)
    made.push_back(std::invoke(function, one));
  return made;
}

/// The sum of what `function` makes of each, in their order; 0 of none.
template <typename Range, typename Function>
auto sum_of(Range&& range, const Function& function) {
  std::remove_cvref_t<std::invoke_result_t<const Function&, std::ranges::range_reference_t<Range>>>
      sum{};
  for (auto&& one : range)
    sum += std::invoke(function, one);
  return sum;
}

}  // namespace planish
