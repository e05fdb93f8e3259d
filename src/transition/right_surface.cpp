// Recognises a patch between two coaxial circles as part of a right cone or cylinder, which a press
// brake's and a roll's drawings want by name: the circles must be parallel, their centres on one
// axis, and begin beside each other. All comparisons are shares of the sizes at hand.

#include "right_surface.hpp"

#include <planish/base/tolerance.hpp>

#include <cmath>

namespace planish::transition_detail {
namespace {

/// Directions that differ by less (sine), lengths by less (share), are the same.
constexpr double kSame = tolerance::kRounding;
/// Share of its distance from the origin by which a point may be off, from rounding.
constexpr double kPointRounding = 1e-15;

/// The start of a side, and the circle that it is part of.
struct Arc {
  Circle circle;
  SpaceCurvePoint start;
  Vec3 arm() const { return start.point - circle.centre; }
};

std::optional<Arc> arc_of(const Hull& hull, const HullPatch& patch, int side) {
  const Stretch& stretch = patch.sides[side];
  const Element& element = hull.element(side, stretch);
  if (!element.circle) return std::nullopt;
  return Arc{*element.circle, element.curve(stretch.t0)};
}

/// Whether the second arc begins beside the first one and runs in a parallel plane; `up` is the
/// normal of the first one's.
bool beside(const Arc& first, const Arc& second, const Vec3& up, double near) {
  const Vec3 arm = second.arm(), turning = arm.cross(second.start.derivative);
  return arm.cross(first.arm()).norm() <= near * arm.norm() * first.circle.radius &&
         std::abs(up.dot(arm)) <= near * arm.norm() &&
         up.cross(turning).norm() <= near * turning.norm();
}

/// About the first arc, which turns by `turned`, through a circle `rise` above it. `side` is the
/// first arc's.
RightSurface about(const Arc& arc, const Vec3& up, double turned, double rise, double other_radius,
                   double near, int side) {
  const Vec3 centre = arc.circle.centre;
  const double radius = arc.circle.radius;
  const Vec3 x = arc.arm() / radius;
  const int other = 1 - side;
  RightSurface right;
  if (std::abs(radius - other_radius) <= near * radius) {
    right.surface = Cylinder{{centre, x, up.cross(x), up}, radius};
    right.u1 = turned;
    right.v[other] = rise;
    return right;
  }
  // The apex beyond the smaller circle; the cone opens away from it.
  const double to_apex = rise * radius / (radius - other_radius);
  const Vec3 z = to_apex > 0.0 ? Vec3(-up) : up;
  right.surface = Cone{{centre + to_apex * up, x, z.cross(x), z},
                       std::atan2(std::abs(radius - other_radius), std::abs(rise))};
  right.u1 = to_apex > 0.0 ? -turned : turned;
  const double slant = std::hypot(rise, radius - other_radius);
  const double scale = slant / std::abs(radius - other_radius);
  right.v[side] = scale * radius;
  right.v[other] = scale * other_radius;
  return right;
}

}  // namespace

std::optional<RightSurface> right_surface(const Hull& hull, const HullPatch& patch) {
  const int moving = patch.sides[0].moves() ? 0 : 1, standing = 1 - moving;
  const auto arc = arc_of(hull, patch, moving);
  if (!arc) return std::nullopt;
  const Vec3 centre = arc->circle.centre;
  const double near = kSame + kPointRounding * centre.norm() / arc->circle.radius;
  const Vec3 up = arc->arm().cross(arc->start.derivative).normalized();
  Vec3 other = hull.point(standing, patch.sides[standing], patch.sides[standing].t0);
  double other_radius = 0.0;
  if (patch.sides[standing].moves()) {
    const auto second = arc_of(hull, patch, standing);
    if (!second || !beside(*arc, *second, up, near)) return std::nullopt;
    other = second->circle.centre;
    other_radius = second->circle.radius;
  }
  const Vec3 axis = other - centre;
  if (axis.cross(up).norm() > near * axis.norm()) return std::nullopt;
  const double turned = patch.sides[moving].t1 - patch.sides[moving].t0;
  return about(*arc, up, turned, up.dot(axis), other_radius, near, moving);
}

}  // namespace planish::transition_detail
