#include "bend_measure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

// Angle, radius and inside of a bend, from its faces alone. Cylinders and cones have closed forms;
// of others the normals at equal steps along the middle of the face give the turn, the smallest
// radius and the side. The angle between two normals is less than half a turn, so a bend that turns
// farther is told by how far its normal has travelled.

namespace planish::brep {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// The turn between two directions at the angle `between`, if the path from one to the other turns
/// by `along`: the long way around if that is beyond a half-turn.
Angle turn_of(double between, double along) {
  return Angle::radians(along <= std::numbers::pi ? between : 2 * std::numbers::pi - between);
}

Bend measured(Bend bend, const Cylinder& cylinder, double turn, double skin_to_inside) {
  bend.kind = BendKind::cylinder;
  bend.angle = Angle::radians(turn);
  bend.inside_radius = std::max(0.0, cylinder.radius - skin_to_inside);
  return bend;
}

Bend measured(Bend bend, const Cone& cone, const Box2& box, double skin_to_inside) {
  const double turn = box.size().x();
  const double s = std::sin(cone.half_angle);
  const double c = std::cos(cone.half_angle);
  const double between = std::acos(std::clamp(c * c * std::cos(turn) + s * s, -1.0, 1.0));
  bend.kind = BendKind::cone;
  bend.angle = turn_of(between, turn);
  bend.inside_radius = std::max(
      0.0, (box.lo.y() + box.hi.y()) / 2 * std::tan(cone.half_angle) - skin_to_inside);
  return bend;
}

/// Middle of the part of the ruling at u that lies on the face.
double middle_of_ruling(const Face& face, double u, const Box2& box) {
  double low = kInfinite;
  double high = -kInfinite;
  for (const Border& border : face.loops.front())
    for (const double t : crossings(border.curve, {u, 0.0}, Vec2::UnitY())) {
      const double v = point_at(border.curve, t).y();
      low = std::min(low, v);
      high = std::max(high, v);
    }
  return low <= high ? 0.5 * (low + high) : 0.5 * (box.lo.y() + box.hi.y());
}

/// How the outward normal turns over a short way across the rulings.
struct Step {
  double turn = 0.0;    ///< radians, positive if the skin is the outside of the bend
  double radius = 0.0;  ///< of the skin, mm
};
Step step_between(const Face& face, double u0, double u1, double v) {
  const Vec2 a(u0, v), b(u1, v);
  const Vec3 n0 = outward_normal(face, a);
  const Vec3 n1 = outward_normal(face, b);
  const Vec3 d = skin_point(face, b) - skin_point(face, a);
  const Vec3 ruling = ruling_on(std::get<Developable>(face.surface), 0.5 * (u0 + u1));
  const double across = (d - d.dot(ruling) * ruling).norm();
  const double angle = angle_between(n0, n1);
  return {d.dot(n1 - n0) > 0 ? angle : -angle, angle > 0 ? across / angle : kInfinite};
}

/// Smallest of radii taken in the middles of equal steps, the ends of the first and the last step
/// included: extrapolated there by the parabola through the three nearest.
double smallest_of(const std::vector<double>& radii) {
  double smallest = *std::ranges::min_element(radii);
  const auto end_beyond = [](auto first) {
    return (15 * first[0] - 10 * first[1] + 3 * first[2]) / 8;
  };
  for (const double end : {end_beyond(radii.begin()), end_beyond(radii.rbegin())})
    if (end > 0) smallest = std::min(smallest, end);
  return smallest;
}

Bend measured_by_steps(Bend bend, const Face& face, const Box2& box, double thickness) {
  constexpr int kSteps = 256;
  double turned = 0.0;
  std::vector<double> radii;
  for (int i = 0; i < kSteps; ++i) {
    const double u0 = box.lo.x() + box.size().x() * i / kSteps;
    const double u1 = box.lo.x() + box.size().x() * (i + 1) / kSteps;
    const double v = middle_of_ruling(face, 0.5 * (u0 + u1), box);
    const Step step = step_between(face, u0, u1, v);
    turned += step.turn;
    radii.push_back(step.radius);
  }
  const double between = angle_between(outward_normal(face, box.lo), outward_normal(face, box.hi));
  bend.kind = BendKind::general;
  // The normal travels farther than the turn if it does not stay in one plane.
  bend.angle = turn_of(between, std::abs(turned));
  bend.reference_inside = turned < 0;
  bend.inside_radius = std::max(0.0,
                                smallest_of(radii) - (bend.reference_inside ? 0.0 : thickness));
  return bend;
}

/// The box of the bend's faces, ended at tangent lines where the bend's own faces end there.
Box2 turned_box(const Sheet& sheet, BendId id, const std::optional<Interval>& own_u) {
  Box2 box = parameter_box(sheet, sheet[id]);
  if (!own_u) return box;
  constexpr double kSame = 1e-4;  // radians: files round
  Interval joints{kInfinite, -kInfinite};
  const auto is_own = [&](const BorderRef& ref) { return sheet[ref.face].part_of == PartId(id); };
  for (const Joint& joint : sheet.joints)
    for (const auto& [own, other] : {std::pair{joint.a, joint.b}, std::pair{joint.b, joint.a}}) {
      if (!is_own(own) || is_own(other)) continue;
      const double u = point_at(sheet[own].curve, 0.5).x();
      joints = {std::min(joints.lo, u), std::max(joints.hi, u)};
    }
  if (joints.lo <= own_u->lo + kSame) box.lo.x() = joints.lo;
  if (joints.hi >= own_u->hi - kSame) box.hi.x() = joints.hi;
  return box;
}

}  // namespace

Bend measured_bend(const Sheet& sheet, BendId id, std::optional<Interval> own_u) {
  Bend bend = sheet[id];
  const Face& face = sheet[bend.faces.front()];
  const Box2 box = turned_box(sheet, id, own_u);
  const auto& surface = std::get<Developable>(face.surface);
  bend.reference_inside = face.sense < 0;
  const double skin_to_inside = bend.reference_inside ? 0.0 : sheet.thickness;
  if (const auto* cylinder = std::get_if<Cylinder>(&surface))
    return measured(std::move(bend), *cylinder, box.size().x(), skin_to_inside);
  if (const auto* cone = std::get_if<Cone>(&surface))
    return measured(std::move(bend), *cone, box, skin_to_inside);
  return measured_by_steps(std::move(bend), face, box, sheet.thickness);
}

}  // namespace planish::brep
