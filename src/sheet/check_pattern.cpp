#include <planish/base/assert.hpp>
#include <planish/sheet/codes.hpp>
#include <planish/sheet/flat_pattern.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

// The first rule that a flat pattern breaks: loops of finite curves, sizes that are numbers, an
// angle for each line. Writers and rules rely on it, so their loops need no checks. A rule is a
// full sentence, its place a JSON pointer or a bend.

namespace planish {
namespace {

using PatternFault = std::optional<Error>;

/// The row that breaks a rule: in words, and as a place.
struct PatternRow {
  std::string where;
  Place place;
};

PatternFault pattern_fault(std::string_view rule, const PatternRow& row) {
  return error_of({code::invalid_sheet, rule}, {{"row", row.place}}, row.where);
}

bool are_regular(const std::vector<Segment>& lines) {
  return std::ranges::all_of(lines, [](const Segment& line) { return is_regular(Curve2(line)); });
}

PatternFault fault_of_loop(const Loop& loop, const PatternRow& where) {
  if (loop.empty()) return pattern_fault("A contour has curves.", where);
  if (!is_regular(loop))
    return pattern_fault("A contour is made of lines, arcs and splines of finite size.", where);
  return {};
}

PatternFault fault_of_bend(const FlatBend& bend) {
  const PatternRow where{"bend " + bend.id, place::bend(bend.id)};
  if (!are_regular(bend.lines) || !are_regular(bend.tangent_lines))
    return pattern_fault("The lines of a bend have ends of finite size.", where);
  if (!bend.line_angles.empty() && bend.line_angles.size() != bend.lines.size())
    return pattern_fault("Each line of a bend has its angle.", where);
  const double sizes[] = {bend.angle.radians(), bend.inside_radius, bend.length};
  if (!std::ranges::all_of(sizes, [](double x) { return std::isfinite(x) && x >= 0.0; }))
    return pattern_fault("Angle, inside radius and length of a bend are numbers of at least 0.",
                         where);
  return {};
}

PatternFault fault_of(const FlatPattern& pattern) {
  const auto row = [](std::string where, std::string pointer) {
    return PatternRow{std::move(where), place::pointer(std::move(pointer))};
  };
  const auto numbered = [&](const char* kind, std::size_t index, const char* list) {
    return row(fmt::format("{} {}", kind, index), fmt::format("{}/{}", list, index));
  };
  if (!(pattern.thickness >= 0.0 && pattern.thickness <= kFarthest))
    return pattern_fault("The thickness of a pattern is a number of at least 0.",
                         row("pattern", ""));
  if (!std::isfinite(pattern.area) || !std::isfinite(pattern.perimeter) ||
      !(pattern.closure >= 0.0 && std::isfinite(pattern.closure)))
    return pattern_fault("Area, perimeter and closure of a pattern are numbers.",
                         row("pattern", ""));
  if (!pattern.outer.loop.empty())
    if (auto found = fault_of_loop(pattern.outer.loop, row("outer contour", "/outer")))
      return found;
  for (std::size_t i = 0; i < pattern.openings.size(); ++i)
    if (auto found = fault_of_loop(pattern.openings[i].loop, numbered("opening", i, "/openings")))
      return found;
  if (!std::ranges::all_of(pattern.slits, [](const Curve2& slit) { return is_regular(slit); }))
    return pattern_fault("Slits are lines, arcs and splines of finite size.",
                         row("slits", "/slits"));
  for (const FlatBend& bend : pattern.bends)
    if (auto found = fault_of_bend(bend)) return found;
  for (std::size_t f = 0; f < pattern.features.size(); ++f)
    for (const Loop& outline : pattern.features[f].outlines)
      if (auto found = fault_of_loop(outline, numbered("feature", f, "/features"))) return found;
  for (std::size_t i = 0; i < pattern.labels.size(); ++i) {
    const FlatLabel& label = pattern.labels[i];
    if (!is_regular(Curve2(Segment{label.at, label.at})))
      return pattern_fault("A label stands at a point of finite size.",
                           row("label " + label.text, fmt::format("/labels/{}", i)));
  }
  return {};
}

}  // namespace

Result<void> check(const FlatPattern& pattern) {
  if (auto found = fault_of(pattern)) return tl::unexpected(std::move(*found));
  return {};
}

void require_valid(const FlatPattern& pattern) {
  if (const auto found = fault_of(pattern)) rule_broken(found->where, found->message);
}

}  // namespace planish
