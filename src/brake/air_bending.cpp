// What bending over a V takes and leaves: the opening that is wanted for a thickness or a radius,
// the force, the radius (math.md#v-choice, math.md#tool-fit).
#include "air_bending.hpp"

#include <planish/base/tolerance.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace planish::brake_detail {
namespace {

constexpr double kNarrowest = 4.0, kWidest = 12.0;  // V in thicknesses (math.md#v-choice)
constexpr double kMet = 1.0 / 3.0;                  // of the drawn radius, either way
constexpr double kVOfRadius = 2.2;                  // over which a punch of that radius bends

}  // namespace

double wanted_opening(double thickness) {
  if (thickness <= 2.5) return 6.0 * thickness;
  return (thickness <= 8.0 ? 8.0 : 10.0) * thickness;
}

double narrowest_opening(double thickness) { return kNarrowest * thickness; }
double widest_opening(double thickness) { return kWidest * thickness; }

double wanted_opening(const BrakeLine& line, const BrakeTools& tools, const PlanOptions& options) {
  const double thickness = line.bend.thickness, radius = line.drawn_radius;
  if (options.opening) return *options.opening;
  if (!line.is_large) return wanted_opening(thickness);
  const double most = largest_tool_angle(line, options);
  const bool has_punch = std::ranges::any_of(tools.punches, [&](const Punch& punch) {
    return punch.angle.radians() <= most && meets(punch.tip_radius, radius);
  });
  if (has_punch || options.radius_of_opening == 0.0) return kVOfRadius * radius + 2.0 * thickness;
  return radius / options.radius_of_opening;
}

double force_per_length(double tensile_strength, double thickness, double opening) {
  return 1.42 * tensile_strength * thickness * thickness / opening;
}

double closing_force(double tensile_strength, double thickness) {
  constexpr double kClosing = 4.0;
  return kClosing * force_per_length(tensile_strength, thickness, wanted_opening(thickness));
}

double force_of(const BrakeLine& line, const Die& die, const PlanOptions& options) {
  const double strength = options.tensile_strength, thickness = line.bend.thickness;
  return line.length() / kMillimetres *
         (line.closes ? closing_force(strength, thickness)
                      : force_per_length(strength, thickness, die.opening));
}

double largest_tool_angle(const BrakeLine& line, const PlanOptions& options) {
  return std::numbers::pi - line.angle.radians() - options.springback.radians() + kWritten;
}

bool is_sharp_for(const BrakeLine& line, const Die& die, const PlanOptions& options) {
  return die.opening > 0.0 && die.angle.radians() <= largest_tool_angle(line, options);
}

double made_radius(const Punch& punch, const Die& die, const PlanOptions& options) {
  return std::max(punch.tip_radius, options.radius_of_opening * die.opening);
}

bool meets(double made, double drawn) { return std::abs(made - drawn) <= kMet * drawn + kWritten; }

bool is_large_radius(double radius, double thickness, const PlanOptions& options) {
  return radius * (1.0 - kMet) > options.radius_of_opening * widest_opening(thickness);
}

}  // namespace planish::brake_detail
