#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>

namespace planish {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;

/// A rigid motion of the plane; a reflection when `linear().determinant() < 0`.
using Isometry2 = Eigen::Isometry2d;

/// v turned by +90°.
inline Vec2 perpendicular(const Vec2& v) { return {-v.y(), v.x()}; }

/// Radians, from 0 to π.
inline double angle_between(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// An orthonormal right-handed frame in space. Lengths in mm.
struct Frame {
  Vec3 origin = Vec3::Zero();
  Vec3 x = Vec3::UnitX();
  Vec3 y = Vec3::UnitY();
  Vec3 z = Vec3::UnitZ();

  Vec3 point(const Vec2& p) const { return origin + p.x() * x + p.y() * y; }
  Vec3 local(const Vec3& p) const {
    const Vec3 d = p - origin;
    return {d.dot(x), d.dot(y), d.dot(z)};
  }
  Vec2 local2(const Vec3& p) const { return local(p).head<2>(); }
};

/// Frame with the given origin and z axis; x is chosen perpendicular to z.
Frame frame_from_normal(const Vec3& origin, const Vec3& z);

/// Frame with the given origin, z axis and an x hint that is not parallel to z.
Frame frame_from_axes(const Vec3& origin, const Vec3& z, const Vec3& x_hint);

}  // namespace planish
