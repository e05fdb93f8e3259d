#include "ring.hpp"

#include "refusals.hpp"

#include <limits>

// The surface between two profiles as a ring of patches: profiles set off to the neutral surface
// (math.md#neutral-profiles), their lateral hull, each patch ruled. Which way the axis points is
// known only once both profiles are, so they are made twice. On the inside of the sheet no radius
// may vanish.

namespace planish::transition_detail {
namespace {

/// How far the neutral surface lies outside the face that the sizes are given for.
double set_off(const TransitionSpec& spec) {
  const double share = spec.sizes_are == SizesAre::inside ? 0.0
                       : spec.sizes_are == SizesAre::mid  ? 0.5
                                                          : 1.0;
  return (spec.k_factor - share) * spec.thickness;
}

double extent_of(const std::array<Boundary, 2>& boundaries) {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const Boundary& boundary : boundaries)
    for (const Element& element : boundary.elements) {
      const Vec3 p = element.curve(element.t0).point;
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  return (high - low).norm();
}

Vec3 middle_of(const Boundary& boundary) {
  Vec3 sum = Vec3::Zero();
  for (const Element& element : boundary.elements)
    sum += element.curve(element.t0).point;
  return sum / boundary.count();
}

/// The first one's axis points to the second, the second one's away from the first.
Result<std::array<Boundary, 2>> boundaries_of(const TransitionSpec& spec) {
  const double outwards = set_off(spec);
  const auto first = boundary_of(spec.from, outwards, spec.from.frame.z, "/from/profile");
  if (!first) return pass_on(first);
  const auto second = boundary_of(spec.to, outwards, spec.to.frame.z, "/to/profile");
  if (!second) return pass_on(second);
  const Vec3 towards = middle_of(*second) - middle_of(*first);
  return std::array{*boundary_of(spec.from, outwards, towards, "/from/profile"),
                    *boundary_of(spec.to, outwards, towards, "/to/profile")};
}

Result<void> check_radii(const Ring& ring, const TransitionSpec& spec) {
  const double inside = spec.k_factor * spec.thickness;
  for (const RuledPatch& patch : ring.patches) {
    if (patch.plane()) continue;
    const double radius = patch.smallest_radii(0.0, 1.0).end;
    if (radius > inside) continue;
    const auto [p, q] = patch.ruling(0.5);
    return fail(refuse::neutral_too_tight, {{"thickness", spec.thickness, unit::mm},
                                            {"radius", radius, unit::mm},
                                            {"least", inside, unit::mm},
                                            {"field", place::pointer("/thickness")},
                                            {"bend", place::point(Vec3(0.5 * (p + q)))}});
  }
  return {};
}

}  // namespace

Result<Ring> ring_of(const TransitionSpec& spec, const TransitionOptions& options) {
  auto boundaries = boundaries_of(spec);
  if (!boundaries) return pass_on(boundaries);
  const double size = extent_of(*boundaries);
  auto hull = lateral_hull(std::move((*boundaries)[0]), std::move((*boundaries)[1]), size);
  if (!hull) return pass_on(hull);
  Ring ring{std::make_shared<const Hull>(std::move(*hull)), {}, size};
  for (const HullPatch& patch : ring.hull->patches)
    ring.patches.emplace_back(ring.hull, patch, options.tolerance * size);
  if (auto wide = check_radii(ring, spec); !wide) return pass_on(wide);
  return ring;
}

}  // namespace planish::transition_detail
