// Every field of an error is one text, lists are led by their length, and numbers are written as
// hexadecimal floating point, so that they come back to the last bit.

#include <planish/base/packed_error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <mutex>
#include <set>

namespace planish {
namespace {

constexpr std::string_view kMark = "error";
constexpr long long kMostWhole = 2147483647, kMostStatus = 4;

/// The string of a set that never loses one.
std::string_view kept(std::string_view text) {
  static std::mutex mutex;
  static std::set<std::string, std::less<>> texts;
  const std::lock_guard lock(mutex);
  return *texts.emplace(text).first;
}

/// Writes fields as texts.
class Packing {
 public:
  void text(std::string_view value) { texts_.emplace_back(value); }
  void unit(std::string_view value) { text(value); }
  template <typename Whole>
  void whole(Whole value, long long, long long) {
    texts_.push_back(std::to_string(static_cast<long long>(value)));
  }
  void number(double value) { texts_.push_back(fmt::format("{:a}", value)); }
  template <typename List, typename Each>
  void list(List& list, const Each& each) {
    whole(list.size(), 0, kMostWhole);
    for (auto& one : list)
      each(one);
  }
  template <typename Value, typename Each>
  void maybe(std::optional<Value>& value, const Each& each) {
    whole(value ? 1 : 0, 0, 1);
    if (value) each(*value);
  }
  void id(Place::Id& id) {
    whole(id.index(), 0, 2);
    if (const int* number = std::get_if<int>(&id)) whole(*number, -kMostWhole, kMostWhole);
    if (const std::string* name = std::get_if<std::string>(&id)) text(*name);
  }
  std::vector<std::string> take() { return std::move(texts_); }

 private:
  std::vector<std::string> texts_;
};

/// Reads what `Packing` wrote. After a fault everything read is empty, and `fine` says so.
class Unpacking {
 public:
  explicit Unpacking(std::span<const std::string> texts) : texts_(texts) {}

  void text(std::string& value) { value = next(); }
  void unit(std::string_view& value) { value = kept(next()); }
  template <typename Whole>
  void whole(Whole& value, long long least, long long most) {
    const std::string word = next();
    char* end = nullptr;
    const long long read = std::strtoll(word.c_str(), &end, 10);
    fine_ = fine_ && !word.empty() && *end == '\0' && read >= least && read <= most;
    value = static_cast<Whole>(fine_ ? read : least);
  }
  void number(double& value) {
    const std::string word = next();
    char* end = nullptr;
    value = std::strtod(word.c_str(), &end);
    fine_ = fine_ && !word.empty() && *end == '\0';
  }
  template <typename List, typename Each>
  void list(List& list, const Each& each) {
    long long left = 0;
    for (whole(left, 0, std::ssize(texts_)); left > 0 && fine_; --left)
      each(list.emplace_back());
  }
  template <typename Value, typename Each>
  void maybe(std::optional<Value>& value, const Each& each) {
    int known = 0;
    whole(known, 0, 1);
    if (known == 1) each(value.emplace());
  }
  void id(Place::Id& id) {
    int kind = 0;
    whole(kind, 0, 2);
    if (kind == 1) whole(id.emplace<int>(), -kMostWhole, kMostWhole);
    if (kind == 2) text(id.emplace<std::string>());
  }
  bool fine() const { return fine_; }
  bool at_end() const { return at_ == texts_.size(); }

 private:
  std::string next() {
    if (at_ < texts_.size()) return texts_[at_++];
    fine_ = false;
    return {};
  }

  std::span<const std::string> texts_;
  std::size_t at_ = 0;
  bool fine_ = true;
};

// What a place and an error consist of, for both ways.

template <typename Way>
void pass(Way& way, Place& place) {
  way.whole(place.kind, 0, static_cast<int>(PlaceKind::line));
  way.id(place.id);
  way.list(place.at, [&](double& x) { way.number(x); });
  way.list(place.faces, [&](int& face) { way.whole(face, 0, kMostWhole); });
}

template <typename Way>
void pass(Way& way, Quantity& quantity) {
  way.number(quantity.value);
  way.unit(quantity.unit);
}

template <typename Way>
void pass(Way& way, std::vector<Named>& all) {
  way.list(all, [&](Named& named) {
    way.whole(named.at, 0, kMostWhole);
    way.text(named.text);
    way.text(named.option);
    pass(way, named.place);
    way.maybe(named.quantity, [&](Quantity& quantity) { pass(way, quantity); });
    way.whole(named.digits, 0, kMostWhole);
    way.whole(named.shows_unit, 0, 1);
  });
}

template <typename Way>
void pass(Way& way, Error& error) {
  way.text(error.message);
  way.text(error.where);
  way.list(error.places, [&](Place& place) { pass(way, place); });
  way.list(error.numbers, [&](NamedQuantity& number) {
    way.text(number.name);
    pass(way, number.quantity);
  });
  way.list(error.remedies, [&](Remedy& remedy) {
    for (std::string* text : {&remedy.option, &remedy.value, &remedy.change})
      way.text(*text);
    pass(way, remedy.named);
  });
  pass(way, error.named);
}

}  // namespace

ErrorCode received_code(std::string_view name, ExitStatus status) { return {kept(name), status}; }

std::vector<std::string> packed(const Error& error) {
  Packing out;
  out.text(kMark);
  out.text(error.code.name);
  out.whole(error.code.status, 0, kMostStatus);
  Error copy = error;
  pass(out, copy);
  return out.take();
}

std::optional<Error> unpacked(std::span<const std::string> texts) {
  if (texts.empty() || texts.front() != kMark) return std::nullopt;
  Unpacking in(texts.subspan(1));
  std::string name;
  ExitStatus status{};
  in.text(name);
  in.whole(status, 0, kMostStatus);
  Error error;
  error.code = received_code(name, status);
  pass(in, error);
  if (!in.fine() || !in.at_end()) return std::nullopt;
  return error;
}

}  // namespace planish
