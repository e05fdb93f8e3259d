#include "identical.hpp"

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

Result<std::optional<std::size_t>> IdenticalParts::number_of(
    const std::string& input, std::size_t part, const std::vector<std::string>& shapes) {
  if (shapes.empty()) return std::nullopt;
  std::vector<std::size_t> groups;
  for (std::size_t piece = 0; piece < shapes.size(); ++piece) {
    const auto pattern = read_flat_json(shapes[piece]);
    if (!pattern) return fail(ErrorCode::cannot_read, pattern.error().message, input);
    const std::size_t group = pieces_.add(*pattern);
    if (group == firsts_.size()) firsts_.push_back({input, part, piece});
    groups.push_back(group);
  }
  std::ranges::sort(groups);
  return parts_.try_emplace(groups, parts_.size()).first->second;
}

}  // namespace planish::batch
