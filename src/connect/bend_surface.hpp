#pragma once

#include <planish/connect/connect.hpp>
#include <planish/geometry/curve.hpp>
#include <planish/geometry/developable.hpp>

#include <array>

namespace planish::connect_detail {

/// The mid-surface of a bend and how it hangs on the plates. Its azimuth runs from 0 on side `first` to
/// `sweep` on the other.
struct BendSurface {
  Developable mid;
  BendKind kind = BendKind::cylinder;
  int first = 0;
  double sweep = 0.0;
  /// Where each plate is tangent: the ruling's point v = 0, its direction towards growing v, and the
  /// direction in the plate's plane away from the bend; unit vectors.
  struct Tangent {
    Vec3 origin, along, away;
  };
  std::array<Tangent, 2> tangents;
  double tan_half_angle = 0.0;  ///< of cones: radius of curvature over the distance from the apex

  double azimuth(int side) const { return side == first ? 0.0 : sweep; }
  /// (v, h) of a point in the plane of a side: v along the tangent ruling, h away from the bend.
  Vec2 local(int side, const Vec3& p) const {
    const Tangent& t = tangents[static_cast<std::size_t>(side)];
    return {(p - t.origin).dot(t.along), (p - t.origin).dot(t.away)};
  }
  Vec3 point(int side, const Vec2& vh) const {
    const Tangent& t = tangents[static_cast<std::size_t>(side)];
    return t.origin + vh.x() * t.along + vh.y() * t.away;
  }
  /// Radius of curvature of the mid-surface at v (of general bends the smallest along the azimuth).
  double radius(double v) const;
  /// The angle through which the sheet is turned from one side to the other.
  Angle turned() const;
};

/// Cylinder (slope 0) or right cone tangent to both plates along `line` (MATH 3.2, 3.3). A cone wants
/// k x − q > 0 on the span it is used for; its v is the distance from the apex.
BendSurface tangent_surface(const BendFrame& frame, EdgeKind edges, const TangentLine& line);

/// A half-turn between parallel planes: `line` has slope 0.
BendSurface half_turn(const BendFrame& frame, const TangentLine& line);

}  // namespace planish::connect_detail
