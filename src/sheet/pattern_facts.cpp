#include <planish/base/text.hpp>
#include <planish/base/tolerance.hpp>
#include <planish/geometry/region.hpp>
#include <planish/sheet/pattern_facts.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace planish {
std::string_view kind_name(BendKind kind) {
  return word_of(kind, {"cylinder", "cone", "general", "sharp"});
}

std::string_view direction_name(BendDirection direction) {
  return direction == BendDirection::up ? "up" : "down";
}

double outer_cutting_length(const FlatPattern& flat) { return length(flat.outer.loop); }

double inner_cutting_length(const FlatPattern& flat) {
  return sum_of(flat.openings, [&](const Contour& opening) { return length(opening.loop); }) +
         length(flat.slits);
}

int slit_count(const FlatPattern& flat) {
  constexpr double kSame = tolerance::kWrittenDigits;  // mm
  int count = 0;
  for (std::size_t i = 0; i < flat.slits.size(); ++i)
    if (i == 0 || (end_of(flat.slits[i - 1]) - start_of(flat.slits[i])).norm() > kSame) ++count;
  return count;
}

std::optional<Segment> longest_line(const FlatBend& bend) {
  const auto longest = std::ranges::max_element(bend.lines, {},
                                                [](const Segment& line) { return length(line); });
  if (longest == bend.lines.end()) return std::nullopt;
  return *longest;
}

std::string forms_text(const FlatPattern& flat) {
  std::map<std::pair<std::string, FormSide>, int> count;
  for (const FlatFeature& feature : flat.features)
    if (feature.kind != "contact") ++count[{feature.kind, feature.side}];
  std::vector<std::string> words;
  for (const auto& [form, n] : count) {
    const auto& [kind, side] = form;
    words.push_back(counted(n, kind == "formed" ? "formed feature" : kind));
    if (side != FormSide::both) words.back() += fmt::format(" {}", side_name(side));
  }
  return fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace planish
