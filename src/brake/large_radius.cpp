// Bends of a radius that no usual V leaves: over a wider V if a tool of the shop leaves it within a
// third, else by bumps, n small bends of α/n at the pitch BA/n. With the chord error e the most
// that a bump may turn is 2 acos(1 − e/R). Where that takes more bumps than anybody presses, or no
// order of strokes makes them, the bend is rolled (math.md#large-radii).
#include "large_radius.hpp"

#include "fits.hpp"

#include <planish/base/tolerance.hpp>

#include <algorithm>
#include <cmath>

namespace planish::brake_detail {
namespace {

constexpr int kMostBumps = 60;         // of one bend: more are rolled
constexpr double kAlwaysLarge = 10.0;  // inside radius in thicknesses, as in the rules

bool is_asked(const Bend& bend) {
  return bend.press_lines.empty() && bend.kind != BendKind::general && !bend.faces.empty();
}

/// With the wanted V and no other, a radius is large where no press brake would try it.
bool is_large(const Bend& bend, double thickness, const PlanOptions& options) {
  if (options.v == VChoice::wanted && !options.large_radii)
    return bend.inside_radius > kAlwaysLarge * thickness;
  return is_large_radius(bend.inside_radius, thickness, options);
}

bool has_v(const Bend& bend, double thickness, const BrakeTools& tools,
           const PlanOptions& options) {
  BrakeLine line;
  line.is_large = true;
  line.angle = bend.angle;
  line.inside_radius = line.drawn_radius = bend.inside_radius;
  line.bend.thickness = thickness;
  return !fitting_tools(line, tools, options).pairs.empty();
}

LargeBend by_bumps(BendId id, const Sheet& sheet, const Layout& layout,
                   const PlanOptions& options) {
  const Bend& bend = sheet[id];
  LargeBend made = bumps_of(bend.angle, bend.inside_radius, layout.allowance[id].allowance,
                            sheet.thickness, options.chord_error);
  made.bend = id;
  if (made.bumps > kMostBumps && !options.large_radii) made = {id, Forming::rolled};
  return made;
}

}  // namespace

LargeBend bumps_of(Angle angle, double radius, double allowance, double thickness,
                   double chord_error) {
  LargeBend made;
  made.forming = Forming::bumps;
  const double half = std::acos(std::clamp(1.0 - chord_error / radius, -1.0, 1.0));
  const double wanted = std::ceil(angle.radians() / (2.0 * half) - tolerance::kComputed);
  const double most = std::floor(allowance / thickness);
  made.bumps = static_cast<int>(std::max(2.0, std::min(wanted, most)));
  made.pitch = allowance / made.bumps;
  made.angle = Angle::radians(angle.radians() / made.bumps);
  made.chord_error = radius * (1.0 - std::cos(0.5 * made.angle.radians()));
  return made;
}

std::vector<LargeBend> large_bends(const Sheet& sheet, const Layout& layout,
                                   const BrakeTools& tools, const PlanOptions& options) {
  std::vector<LargeBend> large;
  for (const BendId id : sheet.bends.ids()) {
    const Bend& bend = sheet[id];
    if (!is_asked(bend) || !is_large(bend, sheet.thickness, options)) continue;
    const auto known = std::ranges::find(options.large, id, &LargeBend::bend);
    if (known != options.large.end()) {
      large.push_back(*known);
      continue;
    }
    const Forming forming = options.large_radii.value_or(
        has_v(bend, sheet.thickness, tools, options) ? Forming::over_v : Forming::bumps);
    if (forming == Forming::bumps)
      large.push_back(by_bumps(id, sheet, layout, options));
    else
      large.push_back({id, forming});
  }
  return large;
}

bool take_next(std::vector<LargeBend>& large, BendId bend, const Sheet& sheet, const Layout& layout,
               const PlanOptions& options) {
  const auto found = std::ranges::find(large, bend, &LargeBend::bend);
  if (found == large.end() || found->forming == Forming::rolled || options.large_radii)
    return false;
  *found = found->forming == Forming::over_v ? by_bumps(bend, sheet, layout, options)
                                             : LargeBend{bend, Forming::rolled};
  return true;
}

bool has_next(const std::vector<LargeBend>& large, const PlanOptions& options) {
  return !options.large_radii && std::ranges::any_of(large, [](const LargeBend& one) {
    return one.forming != Forming::rolled;
  });
}

bool take_next(std::vector<LargeBend>& large, const std::vector<BendId>& unformed,
               const Sheet& sheet, const Layout& layout, const PlanOptions& options) {
  bool taken = false;
  for (const BendId bend : unformed)
    taken = take_next(large, bend, sheet, layout, options) || taken;
  if (taken || !has_next(large, options)) return taken;
  for (const BendId bend : mapped(large, &LargeBend::bend))
    take_next(large, bend, sheet, layout, options);
  return true;
}

}  // namespace planish::brake_detail
