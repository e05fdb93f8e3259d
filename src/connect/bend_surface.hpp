#pragma once

#include <planish/connect/connect.hpp>
#include <planish/geometry/curve.hpp>
#include <planish/geometry/developable.hpp>
#include <planish/geometry/general_cone.hpp>

#include <array>

namespace planish::connect_detail {

/// The mid-surface of a bend and how it joins the plates. Its azimuth runs from 0 on side `first`
/// to `sweep` on the other.
struct BendSurface {
  Developable mid;
  BendKind kind = BendKind::cylinder;
  int first = 0;
  double sweep = 0.0;
  /// Where each plate is tangent: the ruling's point v = 0, its direction towards growing v, and
  /// the direction in the plate's plane away from the bend; unit vectors.
  struct Tangent {
    Vec3 origin, along, away;
  };
  std::array<Tangent, 2> tangents;
  double tan_half_angle = 0.0;  ///< of cones: radius of curvature over the distance from the apex

  // Of general cones: the arc they stand on, the apex, the distances of the arc's ends from it by
  // side, and the smallest radius of curvature along the arc.
  SpaceCurve arc;
  Vec3 apex = Vec3::Zero();
  std::array<double, 2> rails{};
  double tightest = 0.0;

  double azimuth(int side) const { return side == first ? 0.0 : sweep; }
  /// (v, h) of a point in the plane of a side: v along the tangent ruling, h away from the bend.
  Vec2 local(int side, const Vec3& p) const {
    const Tangent& t = tangents[side];
    return {(p - t.origin).dot(t.along), (p - t.origin).dot(t.away)};
  }
  Vec3 point(int side, const Vec2& vh) const {
    const Tangent& t = tangents[side];
    return t.origin + vh.x() * t.along + vh.y() * t.away;
  }
  /// The coordinate that is constant along a circle about the axis: v for cylinders and cones, for
  /// general cones the share of the way from the apex to the arc.
  double level(int side, double v) const;
  double v_at(int side, double level) const;
  /// Radius of curvature of the mid-surface at a level (of general cones the smallest there).
  double radius(double level) const;
  /// The curve of one level in (u, v), from azimuth 0 to `sweep`; of general cones to `tolerance`.
  Curve2 at_level(double level, double tolerance) const;
  /// The angle through which the sheet is turned from one side to the other.
  Angle turned() const;
};

/// Cylinder (slope 0) or right cone tangent to both plates along `line` (math.md#tangent-cylinder
/// and math.md#tangent-cone). A cone requires k x − q > 0 on the span used; its v is the distance
/// from the apex.
BendSurface tangent_surface(const BendFrame& frame, EdgeKind edges, const TangentLine& line);

/// A half-turn between parallel planes: `line` has slope 0.
BendSurface half_turn(const BendFrame& frame, const TangentLine& line);

}  // namespace planish::connect_detail
