#include "prepared.hpp"

#include "large_radius.hpp"
#include "plane_side.hpp"
#include "refusals.hpp"
#include "sentences.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

// What a plan needs, checked before anything is searched: the tools, the options, a bend that a
// press brake can form, and for each line a punch and a die that bear it (math.md#tool-fit). So the
// search finds a tool for every line, and the first fault is told with its numbers.

namespace planish::brake_detail {
namespace {

/// The first option that is out of its range.
std::optional<Error> wrong_option(const Sheet& sheet, const PlanOptions& options) {
  const auto wrong = [](const char* name, const Quantity& value, const char* range) {
    return error_of(refuse::bad_plan_option,
                    {{"option", name}, {"value", value.value, value.unit}, {"range", range}}, name);
  };
  const auto is_length = [](double value) { return std::isfinite(value) && value >= 0.0; };
  if (!is_length(options.clearance))
    return wrong("clearance", {options.clearance, unit::mm}, "0 or more");
  if (options.shortfall && !is_length(*options.shortfall))
    return wrong("shortfall", {*options.shortfall, unit::mm}, "0 or more");
  if (!(options.springback.degrees() >= 0.0 && options.springback.degrees() < 45.0))
    return wrong("springback", {options.springback.degrees(), unit::degrees},
                 "an angle from 0° to below 45°");
  if (!(is_length(options.tensile_strength) && options.tensile_strength > 0.0))
    return wrong("tensile_strength", {options.tensile_strength, "N/mm²"}, "a value above 0");
  if (!is_length(options.radius_of_opening))
    return wrong("radius_of_opening", {options.radius_of_opening}, "0 or more");
  if (options.opening && !(is_length(*options.opening) && *options.opening > 0.0))
    return wrong("opening", {*options.opening, unit::mm}, "a value above 0");
  if (!(is_length(options.chord_error) && options.chord_error > 0.0))
    return wrong("chord_error", {options.chord_error, unit::mm}, "a value above 0");
  for (const BendId bend : options.begin_with)
    if (!sheet.bends.has(bend))
      return error_of(refuse::begins_with_unknown, {{"bend", place::bend(name_of(bend))}},
                      "begin_with");
  return std::nullopt;
}

}  // namespace

namespace {

/// A bend of large radius beside which nothing is long enough for any V, even if nothing is formed.
std::optional<BendId> large_without_room(const StrokeInputs& inputs) {
  StageCache cache(inputs);
  const LineSet nothing = no_lines(inputs.lines());
  for (int line = 0; line < inputs.lines(); ++line) {
    const BrakeLine& large = inputs.work.lines[line];
    const auto has_room = [&](const ToolPair& pair) {
      return !too_short(cache, {&nothing, only(inputs.lines(), line), line, pair.punch, pair.die});
    };
    if ((large.is_large || large.bump_pitch) &&
        std::ranges::none_of(inputs.fitting[line].pairs, has_room))
      return large.bends.front();
  }
  return std::nullopt;
}

}  // namespace

std::string name_of(BendId bend) { return fmt::format("B{}", index_of(bend) + 1); }

namespace {

/// What no tool cures is said of the press.
const Refusal& refusal_of(std::string_view why) {
  if (why == say::kShortPress) return refuse::press_too_short;
  if (why == say::kWeakPressForHem) return refuse::press_too_weak_for_hem;
  if (why == say::kWeakOverWanted) return refuse::press_too_weak_over_wanted;
  if (why == say::kWeakOverUsual) return refuse::press_too_weak_over_usual;
  if (why == say::kWeakOverWide) return refuse::press_too_weak_over_wide;
  if (why == say::kSlightlyShortRows) return refuse::rows_slightly_short;
  return why == say::kWeakPress ? refuse::press_too_weak : refuse::no_tool_bears;
}

/// What is asked for over a V or by bumps may still be rolled.
const Refusal& refusal_of(std::string_view why, const BrakeLine& line) {
  const Refusal& refusal = refusal_of(why);
  const bool is_large = line.is_large || line.bump_pitch;
  return is_large && &refusal == &refuse::no_tool_bears ? refuse::no_tool_bears_large : refusal;
}

}  // namespace

std::optional<Error> line_without_tool(const StrokeInputs& inputs) {
  for (int i = 0; i < std::ssize(inputs.work.lines); ++i) {
    const FittingTools& fitting = inputs.fitting[i];
    if (!fitting.pairs.empty()) continue;
    const BrakeLine& line = inputs.work.lines[i];
    const std::string name = name_of(line.bends.front());
    const Told& why = fitting.why->told;
    Facts facts{{"bend", place::bend(name)},
                {"angle", line.angle.degrees(), unit::degrees},
                {"radius", line.drawn_radius, unit::mm},
                {"length", line.length(), unit::mm},
                {"thickness", line.bend.thickness, unit::mm},
                {"why", why.sentence}};
    if (fitting.wider > 0.0) facts.emplace_back("v", fitting.wider, unit::none);
    if (fitting.shortfall > 0.0) {
      facts.emplace_back("short", fitting.shortfall, unit::mm);
      facts.emplace_back("shortfall", fitting.shortfall, unit::none);
    }
    Error error = error_of(refusal_of(fitting.why->code, line), facts, name);
    error.numbers.insert(error.numbers.end(), why.numbers.begin(), why.numbers.end());
    return error;
  }
  return std::nullopt;
}

Result<StrokeInputs> prepared(const Sheet& sheet, const Layout& layout, const BrakeTools& tools,
                              const PlanOptions& options) {
  if (const auto right = check(tools); !right) return pass_on(right);
  if (const auto error = wrong_option(sheet, options)) return tl::unexpected(*error);
  if (options.gauge_openings && !tools.machine.gauge)
    return fail(refuse::no_gauge, {}, "gauge_openings");
  WorkpieceOptions cut = workpiece_options(sheet.thickness, tools, options,
                                           large_bends(sheet, layout, tools, options));
  for (;;) {
    auto work = workpiece_of(sheet, layout, cut);
    if (!work) return pass_on(work);
    StrokeInputs inputs = stroke_inputs(std::move(*work), tools, options);
    if (const auto bend = large_without_room(inputs);
        bend && take_next(cut.large, *bend, sheet, layout, options))
      continue;
    if (const auto error = line_without_tool(inputs)) return tl::unexpected(*error);
    return inputs;
  }
}

LineSet lines_of(const Workpiece& work, const OrderedStroke& stroke) {
  LineSet lines = no_lines(static_cast<int>(work.lines.size()));
  for (int i = 0; i < std::ssize(work.lines); ++i)
    for (const BendId bend : work.lines[i].bends)
      if (std::ranges::find(stroke.bends, bend) != stroke.bends.end() &&
          work.lines[i].press_line == stroke.press_line &&
          work.lines[i].closes.has_value() == stroke.flattening)
        insert(lines, i);
  return lines;
}

}  // namespace planish::brake_detail
