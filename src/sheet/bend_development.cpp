// Where a bend's neutral surface lies and how that is developed (math.md#neutral-surface): K T from
// the inside, so on the reference skin's side of it by the difference of both depths. A sharp bend
// has no surface; its allowance is the strip that is left between its faces, measured at the hinge
// if the reference surface lies between the skins. The neutral surface must have a radius
// everywhere.

#include "bend_development.hpp"

#include "refusals.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/sheet/places.hpp>

#include <algorithm>
#include <cmath>

namespace planish::sheet_detail {
namespace {

/// How far the neutral surface of a bend lies below the reference surface.
double neutral_depth(const Sheet& sheet, const Bend& bend, double k) {
  return (bend.reference_inside ? k : 1.0 - k) * sheet.thickness - sheet.reference_depth;
}

/// The allowance of a bend that is made with another radius: its flanges keep their planes, so each
/// ends (drawn − made) tan(α/2) farther from the bend, and what is left between the drawn ends is
/// developed as if K made it so long. Nothing may be left out of that.
Result<BendAllowance> allowance_as_made(const Sheet& sheet, BendId id,
                                        const FlattenOptions& options, double radius) {
  const Bend& bend = sheet[id];
  auto made = allowance_of_radius(sheet, id, radius, options);
  if (!made) return made;
  const double angle = bend.angle.radians();
  // Faces of a sharp bend may meet below the inside skin.
  const double below = bend.reference_inside ? sheet.reference_depth
                                             : sheet.thickness - sheet.reference_depth;
  const bool meet_below = bend.faces.empty() && sheet.reference_depth > 0.0;
  const double moved = 2.0 * (bend.inside_radius - radius - (meet_below ? below : 0.0)) *
                       std::tan(0.5 * angle);
  made->allowance += moved;
  made->deduction = 2.0 * outside_setback(bend.inside_radius, sheet.thickness, bend.angle) -
                    made->allowance;
  made->k_factor = (made->allowance / angle - bend.inside_radius) / sheet.thickness;
  if (!(made->allowance > 0.0))
    return fail(refuse::radius_takes_flanges, {{"bend", place_of(sheet, id)},
                                               {"radius", radius, unit::mm},
                                               {"short", -made->allowance, unit::mm}});
  return made;
}

/// If the reference surface lies between the skins, a sharp bend turns about it; on an outside skin
/// the faces meet beyond it.
void settle_hinge(const Sheet& sheet, const Bend& bend, BendAllowance& allowance) {
  const double outwards = bend.reference_inside ? 1.0 : -1.0;
  allowance.allowance = bend.angle.radians() * outwards *
                        neutral_depth(sheet, bend, allowance.k_factor);
  const double outside = bend.reference_inside ? sheet.thickness - sheet.reference_depth
                                               : sheet.reference_depth;
  allowance.deduction = 2.0 * outside_setback(0.0, outside, bend.angle) - allowance.allowance;
}

/// Whether the surface exists at this offset: general surfaces end at their edge of regression,
/// which lies away from the sheet.
bool has_radius(const Sheet& sheet, const Bend& bend, double offset) {
  const double least = tolerance::kComputed * sheet.thickness;
  for (const FaceId id : bend.faces) {
    const auto& surface = std::get<Developable>(sheet[id].surface);
    if (const auto* cylinder = std::get_if<Cylinder>(&surface))
      if (cylinder->radius + offset <= least) return false;
    if (const auto* cone = std::get_if<Cone>(&surface)) {
      const double nearest = parameter_box(sheet[id]).lo.y() * std::tan(cone->half_angle);
      if (nearest + offset < -least) return false;
    }
  }
  return true;
}

}  // namespace

Result<IdVector<BendId, BendAllowance>> allowances_of(const Sheet& sheet,
                                                      const FlattenOptions& options) {
  IdVector<BendId, BendAllowance> allowances;
  for (const BendId id : sheet.bends.ids()) {
    const auto made = std::ranges::find(options.made_radius, id, &std::pair<BendId, double>::first);
    const bool as_drawn = made == options.made_radius.end();
    auto allowance = as_drawn ? allowance_of_radius(sheet, id, sheet[id].inside_radius, options)
                              : allowance_as_made(sheet, id, options, made->second);
    if (!allowance) return pass_on(allowance);
    if (as_drawn && sheet[id].faces.empty() && sheet.reference_depth > 0.0)
      settle_hinge(sheet, sheet[id], *allowance);
    allowances.push_back(std::move(*allowance));
  }
  return allowances;
}

Result<IdVector<BendId, std::optional<Development>>> developments_of(
    const Sheet& sheet, const IdVector<BendId, BendAllowance>& allowances) {
  IdVector<BendId, std::optional<Development>> developments;
  for (const BendId id : sheet.bends.ids()) {
    auto& development = developments.emplace_back();
    const Bend& bend = sheet[id];
    if (bend.faces.empty()) continue;
    const Face& face = sheet[bend.faces.front()];
    const auto& surface = std::get<Developable>(face.surface);
    const double offset = -face.sense * neutral_depth(sheet, bend, allowances[id].k_factor);
    if (!has_radius(sheet, bend, offset))
      return fail(refuse::no_neutral_radius,
                  {{"bend", place_of(sheet, id)},
                   {"radius", bend.inside_radius, unit::mm},
                   {"k", allowances[id].k_factor, unit::none}},
                  id_text(place_of(sheet, id)));
    const Box2 box = parameter_box(face);
    development.emplace(surface, offset, 0.5 * (box.lo.x() + box.hi.x()));
  }
  return developments;
}

IdVector<FaceId, double> neutral_offsets_of(const Sheet& sheet,
                                            const IdVector<BendId, BendAllowance>& allowances) {
  IdVector<FaceId, double> offsets;
  for (const Face& face : sheet.faces) {
    const auto* bend = std::get_if<BendId>(&face.part_of);
    offsets.push_back(
        bend ? -face.sense * neutral_depth(sheet, sheet[*bend], allowances[*bend].k_factor) : 0.0);
  }
  return offsets;
}

}  // namespace planish::sheet_detail

namespace planish {

Result<BendAllowance> allowance_of_radius(const Sheet& sheet, BendId bend, double radius,
                                          const FlattenOptions& options) {
  const Angle angle = sheet[bend].angle;
  for (const auto& [single, k] : options.bend_k)
    if (single == bend)
      return bend_allowance(ConstantK{k, "this bend"}, sheet.thickness, radius, angle);
  return bend_allowance(options.allowance, sheet.thickness, radius, angle);
}

}  // namespace planish
