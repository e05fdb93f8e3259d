#include "identical.hpp"

#include "refusals.hpp"
#include "state.hpp"

#include <planish/io/flat_json.hpp>

#include <algorithm>

namespace planish::batch {

IdenticalParts::IdenticalParts(Journal& journal)
    : journal_(journal),
      pieces_([this](std::size_t group) { return pattern_of(firsts_[group]); }) {}

FlatPattern IdenticalParts::pattern_of(const Place& place) {
  const auto parts = journal_.parts_of(place.input);
  if (!parts || place.part >= parts->size()) return {};
  const auto pattern = read_flat_json((*parts)[place.part].shapes[place.piece]);
  return pattern ? *pattern : FlatPattern{};
}

// Most identical parts are the same to the last bit, which needs no geometry to be seen.
Result<std::size_t> IdenticalParts::group_of(const std::string& shape, const Place& place) {
  const std::string hash = hash_of(shape);
  if (const auto known = texts_.find(hash); known != texts_.end()) return known->second;
  const auto pattern = read_flat_json(shape);
  if (!pattern)
    return fail(refuse::shape_unread, {{"reason", pattern.error().message}}, place.input);
  const std::size_t group = pieces_.add(*pattern);
  if (group == firsts_.size()) firsts_.push_back(place);
  texts_.emplace(hash, group);
  return group;
}

Result<std::optional<std::size_t>> IdenticalParts::number_of(
    const std::string& input, std::size_t part, const std::vector<std::string>& shapes) {
  if (shapes.empty()) return std::nullopt;
  std::vector<std::size_t> groups;
  for (std::size_t piece = 0; piece < shapes.size(); ++piece) {
    const auto group = group_of(shapes[piece], {input, part, piece});
    if (!group) return pass_on(group);
    groups.push_back(*group);
  }
  std::ranges::sort(groups);
  return parts_.try_emplace(groups, parts_.size()).first->second;
}

}  // namespace planish::batch
