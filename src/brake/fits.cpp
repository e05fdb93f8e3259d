// Which tools bear a line, whatever the stage: by angle, tip radius, opening and force, of the
// dies that do those of the opening nearest to the wanted one (math.md#tool-fit,
// math.md#closing-hems).
#include "fits.hpp"

#include "sentences.hpp"

#include <planish/base/tolerance.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace planish::brake_detail {
namespace {

constexpr double kWritten = tolerance::kWrittenDigits;  // mm, radians: sizes of tools as written

double largest_tool_angle(const BrakeLine& line, const PlanOptions& options) {
  return std::numbers::pi - line.angle.radians() - options.springback.radians() + kWritten;
}

bool bears(const std::optional<double>& most, double force) { return !most || *most >= force; }

std::string_view no_tool_pattern(const BrakeLine& line, const BrakeTools& tools,
                                 const PlanOptions& options, bool punches) {
  const double most = largest_tool_angle(line, options);
  if (is_hem(line.angle) && !line.closed_by) return say::no_flat_tools;
  if (most <= 0.0) return say::has_to_be_rolled;
  const auto sharp = [&](const auto& tool) { return tool.angle.radians() <= most; };
  if (punches && std::ranges::none_of(tools.punches, sharp)) return say::no_sharp_punch;
  const bool fine = std::ranges::any_of(tools.punches, [&](const Punch& punch) {
    return sharp(punch) && punch.tip_radius <= line.inside_radius + kWritten;
  });
  if (punches) return fine ? say::no_strong_punch : say::no_fine_punch;
  if (std::ranges::none_of(tools.dies, sharp)) return say::no_sharp_die;
  return say::no_strong_die;
}

/// Why no tool bears the line, with its numbers.
Remark no_tool(const BrakeLine& line, const BrakeTools& tools, const PlanOptions& options,
               double force, bool punches) {
  const std::string_view pattern = no_tool_pattern(line, tools, options, punches);
  const double most = Angle::radians(largest_tool_angle(line, options)).degrees();
  const Facts all{{"tool_angle", most, unit::degrees},
                  {"bend_angle", 180.0 - options.springback.degrees(), unit::degrees},
                  {"tip_radius", line.inside_radius, unit::mm},
                  {"force", force, say::kPerMetre}};
  Facts stated;
  for (const Fact& fact : all)
    if (pattern.find("{" + std::string(fact.name()) + "}") != std::string_view::npos)
      stated.push_back(fact);
  return remark_of({say::kNoTool, pattern}, stated);
}

}  // namespace

double wanted_opening(double thickness) {
  if (thickness <= 2.5) return 6.0 * thickness;
  return (thickness <= 8.0 ? 8.0 : 10.0) * thickness;
}

double force_per_length(double tensile_strength, double thickness, double opening) {
  return 1.42 * tensile_strength * thickness * thickness / opening;
}

double closing_force(double tensile_strength, double thickness) {
  constexpr double kClosing = 4.0;
  return kClosing * force_per_length(tensile_strength, thickness, wanted_opening(thickness));
}

Angle angle_before_closing(const BrakeTools& tools, const PlanOptions& options) {
  const auto sharpest = [](const auto& all) {
    Angle angle = Angle::radians(std::numbers::pi);
    for (const auto& tool : all)
      angle = std::min(angle, tool.angle);
    return angle;
  };
  const auto flat = [](const auto& tool) { return flattens(tool.angle); };
  if (std::ranges::none_of(tools.punches, flat) || std::ranges::none_of(tools.dies, flat))
    return {};
  return Angle::radians(std::numbers::pi) -
         std::max(sharpest(tools.punches), sharpest(tools.dies)) - options.springback;
}

WorkpieceOptions workpiece_options(double thickness, const BrakeTools& tools,
                                   const PlanOptions& options) {
  return {options.radius_of_opening * options.opening.value_or(wanted_opening(thickness)),
          angle_before_closing(tools, options)};
}

namespace {

/// Flat tools that bear the force of closing a hem.
FittingTools closing_tools(const BrakeLine& line, const BrakeTools& tools,
                           const PlanOptions& options) {
  FittingTools fitting;
  const double force = closing_force(options.tensile_strength, line.bend.thickness);
  const auto add = [&](const auto& all, std::vector<int>& fits) {
    for (int i = 0; i < std::ssize(all); ++i)
      if (flattens(all[i].angle) && bears(all[i].max_force, force)) fits.push_back(i);
  };
  add(tools.punches, fitting.punches);
  add(tools.dies, fitting.dies);
  if (fitting.punches.empty() || fitting.dies.empty())
    fitting.why = remark_of({say::kNoTool, say::no_strong_flat_tools});
  return fitting;
}

}  // namespace

FittingTools fitting_tools(const BrakeLine& line, const BrakeTools& tools,
                           const PlanOptions& options) {
  if (line.closes) return closing_tools(line, tools, options);
  FittingTools fitting;
  const double most_angle = largest_tool_angle(line, options), t = line.bend.thickness;
  const double wanted = options.opening.value_or(wanted_opening(t));
  double nearest = std::numeric_limits<double>::infinity(), opening = 0.0;
  const auto fits = [&](const Die& die) {
    return die.opening > 0.0 && die.angle.radians() <= most_angle &&
           bears(die.max_force, force_per_length(options.tensile_strength, t, die.opening));
  };
  for (const Die& die : tools.dies) {
    const double away = std::abs(die.opening - wanted);
    const bool nearer = away < nearest - kWritten ||
                        (away < nearest + kWritten && die.opening < opening);
    if (!fits(die) || !nearer) continue;
    nearest = away;
    opening = die.opening;
  }
  for (int i = 0; i < std::ssize(tools.dies); ++i)
    if (fits(tools.dies[i]) && std::abs(tools.dies[i].opening - opening) < kWritten)
      fitting.dies.push_back(i);
  const double force = opening > 0.0 ? force_per_length(options.tensile_strength, t, opening) : 0.0;
  for (int i = 0; i < std::ssize(tools.punches); ++i) {
    const Punch& punch = tools.punches[i];
    if (punch.angle.radians() <= most_angle && punch.tip_radius <= line.inside_radius + kWritten &&
        bears(punch.max_force, force))
      fitting.punches.push_back(i);
  }
  if (fitting.punches.empty() || fitting.dies.empty())
    fitting.why = no_tool(line, tools, options, force, fitting.punches.empty());
  return fitting;
}

}  // namespace planish::brake_detail
