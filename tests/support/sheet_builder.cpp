#include "support/sheet_builder.hpp"

#include <planish/base/assert.hpp>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace planish::test {
namespace {

double sign_of(BendDirection direction) { return direction == BendDirection::up ? 1.0 : -1.0; }

/// The reference radius: the reference skin is inside up bends, outside down bends.
double reference_radius(const Turn& turn, double thickness) {
  return turn.inside_radius + (turn.direction == BendDirection::up ? 0.0 : thickness);
}

Frame turned_about(const Frame& f, const Vec3& point, const Vec3& axis, double angle) {
  const Eigen::AngleAxisd turn(angle, axis);
  return {point + turn * (f.origin - point), turn * f.x, turn * f.y, turn * f.z};
}

/// Loop of a bend's (u, v) rectangle that starts with the border at u0, run from the rim's end to
/// its start: border 0 joins the rim before, border 2 is the far rim.
Loop bend_rectangle(double u0, double u1, double v_end, double v_start) {
  return polygon({{u0, v_end}, {u0, v_start}, {u1, v_start}, {u1, v_end}});
}

/// ∫ f(t) dt over the curve's [0, 1]: Gauss–Legendre, five points on each of 48 parts or more, none
/// of which holds an end of a spline's piece, where speeds jump.
double integral(const Curve2& curve, const std::function<double(double)>& f) {
  static constexpr std::array<std::array<double, 2>, 5> nodes{
      {{0.0, 128.0 / 225.0},
       {0.5384693101056831, 0.4786286704993665},
       {-0.5384693101056831, 0.4786286704993665},
       {0.9061798459386640, 0.2369268850561891},
       {-0.9061798459386640, 0.2369268850561891}}};
  const auto* spline = std::get_if<CubicSpline>(&curve);
  const int pieces = spline == nullptr ? 1 : static_cast<int>(spline->poles.size() / 3);
  const int parts = pieces * (1 + 47 / pieces);
  double sum = 0.0;
  for (int i = 0; i < parts; ++i)
    for (const auto& [x, weight] : nodes)
      sum += weight * f((i + 0.5 + 0.5 * x) / parts);
  return sum / (2 * parts);
}

/// ∂x/∂u on the offset of a ruled surface, to some 1e-9 of its size.
Vec3 by_u(const Developable& surface, const Vec2& uv, double offset) {
  const auto& knots = std::get<Ruled>(surface).knots;
  const Vec2 h(1e-5 * (knots.back().u - knots.front().u), 0.0);
  return (point_on(surface, uv + h, offset) - point_on(surface, uv - h, offset)) / (2 * h.x());
}

/// ∂x/∂u on the offset surface: across the ruling, and along it.
Vec2 rate(const Developable& surface, const Vec2& uv, double offset) {
  if (const auto* cylinder = std::get_if<Cylinder>(&surface))
    return {cylinder->radius + offset, 0.0};
  if (const auto* cone = std::get_if<Cone>(&surface))
    return {uv.y() * std::sin(cone->half_angle) + offset * std::cos(cone->half_angle), 0.0};
  const Vec3 velocity = by_u(surface, uv, offset);
  const Vec3 ruling = ruling_on(surface, uv.x());
  return {velocity.dot(ruling.cross(normal_on(surface, uv.x()))), velocity.dot(ruling)};
}

/// ∫ rate across the ruling dv from v = 0: it is linear in v.
double stretch_integral(const Developable& surface, const Vec2& uv, double offset) {
  return uv.y() * rate(surface, {uv.x(), 0.5 * uv.y()}, offset).x();
}

}  // namespace

Cylinder cylinder_behind(const Rim& rim, const Turn& turn, double thickness) {
  const Frame& f = rim.frame;
  const double radius = reference_radius(turn, thickness);
  if (turn.direction == BendDirection::up)
    return {{f.origin + rim.length * f.y + radius * f.z, -f.z, f.x, -f.y}, radius};
  return {{f.origin - radius * f.z, f.z, f.x, f.y}, radius};
}

Frame turned(const Frame& rim, const Turn& turn, double thickness) {
  const double s = sign_of(turn.direction);
  const Vec3 center = rim.origin + s * reference_radius(turn, thickness) * rim.z;
  return turned_about(rim, center, rim.y, -s * turn.angle.radians());
}

SheetBuilder::SheetBuilder(double thickness) { sheet_.thickness = thickness; }

FaceId SheetBuilder::add_face(Face face, const std::vector<Loop>& loops) {
  for (const Loop& loop : loops) {
    BorderLoop borders;
    for (const Curve2& curve : loop)
      borders.push_back({.curve = curve, .edge_length = skin_length(face, curve)});
    face.loops.push_back(std::move(borders));
  }
  sheet_.faces.push_back(std::move(face));
  return static_cast<FaceId>(sheet_.faces.size() - 1);
}

FaceId SheetBuilder::flange(const Frame& frame, const std::vector<Loop>& loops) {
  const auto id = static_cast<FlangeId>(sheet_.flanges.size());
  Face blank;
  blank.surface = frame;
  blank.part_of = id;
  const FaceId face = add_face(std::move(blank), loops);
  sheet_.flanges.push_back({{face}});
  return face;
}

void SheetBuilder::continue_from(const Rim& rim, FaceId face) {
  if (rim.border) join(*rim.border, {face, 0, 0}, rim.sharp);
}

FaceId SheetBuilder::flange_behind(const Rim& rim, const std::vector<Loop>& loops) {
  const Frame& f = rim.frame;
  PLANISH_ASSERT(start_of(loops[0][0]).norm() < 1e-9);
  PLANISH_ASSERT((end_of(loops[0][0]) - Vec2(rim.length, 0)).norm() < 1e-9);
  const FaceId face = flange({f.origin + rim.length * f.y, -f.y, f.x, f.z}, loops);
  continue_from(rim, face);
  return face;
}

BendId SheetBuilder::new_bend(const Bend& bend) {
  sheet_.bends.push_back(bend);
  return static_cast<BendId>(sheet_.bends.size() - 1);
}

FaceId SheetBuilder::bend_face(BendId id, const Developable& surface, int sense,
                               const std::vector<Loop>& loops) {
  Face blank;
  blank.surface = surface;
  blank.sense = sense;
  blank.part_of = id;
  const FaceId face = add_face(std::move(blank), loops);
  sheet_.bends[id].faces.push_back(face);
  return face;
}

Rim SheetBuilder::bend(const Rim& rim, const Turn& turn) {
  PLANISH_ASSERT(!rim.sharp);
  const bool up = turn.direction == BendDirection::up;
  const BendId id = new_bend({BendKind::cylinder, {}, turn.angle, turn.inside_radius, up});
  const double v_start = up ? rim.length : 0.0;
  const FaceId face = bend_face(
      id, cylinder_behind(rim, turn, sheet_.thickness), up ? -1 : 1,
      {bend_rectangle(0.0, turn.angle.radians(), rim.length - v_start, v_start)});
  continue_from(rim, face);
  return {turned(rim.frame, turn, sheet_.thickness), rim.length, BorderRef{face, 0, 2}, {}};
}

Rim SheetBuilder::bend(const Rim& rim, const ConeTurn& turn) {
  PLANISH_ASSERT(!rim.sharp);
  const Frame& f = rim.frame;
  const double s = sign_of(turn.direction);
  const double sine = std::sin(turn.half_angle.radians());
  const double cosine = std::cos(turn.half_angle.radians());
  const double u = turn.azimuth.radians();
  // The cone's normal is the rim's z for down bends and its opposite for up bends; the azimuth
  // then runs away from the rim for down bends, towards it for up bends.
  const Cone cone{{f.origin - turn.near_distance * f.y, sine * f.y - s * cosine * f.z, -s * f.x,
                   s * sine * f.z + cosine * f.y},
                  turn.half_angle.radians()};

  const double cos_turned = cosine * cosine * std::cos(u) + sine * sine;
  const double turned = u <= std::numbers::pi ? std::acos(cos_turned)
                                              : 2 * std::numbers::pi - std::acos(cos_turned);
  const double far_distance = turn.near_distance + rim.length;
  const double mid_radius = 0.5 * (turn.near_distance + far_distance) * sine / cosine;
  const bool up = turn.direction == BendDirection::up;
  const BendId id = new_bend({BendKind::cone,
                              {},
                              Angle::radians(turned),
                              up ? mid_radius : mid_radius - sheet_.thickness,
                              up});
  const FaceId face = bend_face(id, cone, up ? -1 : 1,
                                {bend_rectangle(0.0, -s * u, far_distance, turn.near_distance)});
  continue_from(rim, face);
  return {turned_about(f, cone.frame.origin, cone.frame.z, -s * u),
          rim.length,
          BorderRef{face, 0, 2},
          {}};
}

Rim SheetBuilder::crease(const Rim& rim, const Crease& fold) {
  const bool up = fold.direction == BendDirection::up;
  const BendId id = new_bend({BendKind::sharp, {}, fold.angle, 0.0, up});
  const double angle = -sign_of(fold.direction) * fold.angle.radians();
  return {turned_about(rim.frame, rim.frame.origin, rim.frame.y, angle), rim.length, rim.border,
          id};
}

void SheetBuilder::join(const BorderRef& a, const BorderRef& b, std::optional<BendId> sharp) {
  sheet_.joints.push_back({a, b, sharp});
}

Rim SheetBuilder::rim(FaceId flange_face, int border, int loop) const {
  const Face& face = sheet_.faces[flange_face];
  const Frame& frame = std::get<Frame>(face.surface);
  const Curve2& curve = face.loops[loop][border].curve;
  PLANISH_ASSERT(std::holds_alternative<Segment>(curve));
  const Vec2 along = end_of(curve) - start_of(curve);
  const Vec2 d = along.normalized();
  return {{frame.point(start_of(curve)), d.y() * frame.x - d.x() * frame.y,
           d.x() * frame.x + d.y() * frame.y, frame.z},
          along.norm(),
          BorderRef{flange_face, loop, border},
          {}};
}

double SheetBuilder::sharp_volume() const {
  double sum = 0.0;
  for (const Joint& joint : sheet_.joints) {
    if (!joint.sharp) continue;
    const Bend& bend = sheet_[*joint.sharp];
    const Border& border = sheet_[joint.a];
    sum += (bend.reference_inside ? 1.0 : -1.0) * sheet_.thickness * sheet_.thickness *
           std::tan(0.5 * bend.angle.radians()) * *border.edge_length;
  }
  return sum;
}

Sheet SheetBuilder::finish() {
  int edge = 0;
  for (Face& face : sheet_.faces)
    for (BorderLoop& loop : face.loops)
      for (Border& border : loop)
        border.edge = ++edge;
  for (const Joint& joint : sheet_.joints) {
    const auto border = [&](const BorderRef& ref) -> Border& { return sheet_[ref]; };
    border(joint.b).edge = border(joint.a).edge;
  }
  double volume = sharp_volume();
  for (const Face& face : sheet_.faces)
    volume += volume_under(face, sheet_.thickness);
  sheet_.volume = volume;
  return sheet_;
}

Loop polygon(const std::vector<Vec2>& points) {
  Loop loop;
  for (std::size_t i = 0; i < points.size(); ++i)
    loop.push_back(Segment{points[i], points[(i + 1) % points.size()]});
  return loop;
}

Loop rectangle(double width, double height) {
  return polygon({{0, 0}, {width, 0}, {width, height}, {0, height}});
}

Loop circular_opening(const Vec2& center, double radius) {
  return {Arc{center, radius, 0.0, -2 * std::numbers::pi}};
}

Loop obround_opening(const Vec2& center, double straight, double radius, Angle angle) {
  const double a = angle.radians();
  const Vec2 half = 0.5 * straight * Vec2(std::cos(a), std::sin(a));
  const Vec2 side = radius * Vec2(-std::sin(a), std::cos(a));
  constexpr double pi = std::numbers::pi;
  return {Segment{center - half + side, center + half + side},
          Arc{center + half, radius, a + pi / 2, -pi},
          Segment{center + half - side, center - half - side},
          Arc{center - half, radius, a - pi / 2, -pi}};
}

double skin_length(const Face& face, const Curve2& uv) {
  const auto* surface = std::get_if<Developable>(&face.surface);
  if (surface == nullptr) return length(uv);
  return integral(uv, [&](double t) {
    const Vec2 d = derivative_at(uv, t);
    return (d.x() * rate(*surface, point_at(uv, t), 0.0) + Vec2(0.0, d.y())).norm();
  });
}

double volume_under(const Face& face, double thickness) {
  const auto* surface = std::get_if<Developable>(&face.surface);
  const auto under = [&](const Curve2& curve) {
    if (surface == nullptr) return green_area(curve);
    const double middle = -0.5 * face.sense * thickness;
    return -face.sense * integral(curve, [&](double t) {
      return derivative_at(curve, t).x() * stretch_integral(*surface, point_at(curve, t), middle);
    });
  };
  double area = 0.0;
  for (const BorderLoop& loop : face.loops)
    for (const Border& border : loop)
      area += under(border.curve);
  return area * thickness;
}

}  // namespace planish::test
