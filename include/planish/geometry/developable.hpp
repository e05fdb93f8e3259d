#pragma once

#include <planish/base/result.hpp>
#include <planish/geometry/curve.hpp>
#include <planish/geometry/frame.hpp>
#include <variant>
#include <vector>

namespace planish {

/// Circular cylinder about the frame's z axis. u: azimuth θ (radians, any turn), v: height z (mm).
struct Cylinder {
  Frame frame;
  double radius = 0.0;
};

/// Right circular cone with its apex at the frame's origin, opening along +z. u: azimuth θ,
/// v: distance s from the apex along the ruling (mm, positive).
struct Cone {
  Frame frame;
  double half_angle = 0.0;
};

/// General developable x(u, v) = b(u) + v·g(u), |g| = 1, det(b′, g, g′) = 0 (MATH 2.5), given by
/// knots and interpolated by cubic Hermite pieces. The normal is b′ × g, normalised.
struct Ruled {
  struct Knot {
    double u;
    Vec3 b, b_prime;
    Vec3 g, g_prime;
  };
  std::vector<Knot> knots;
};

using Developable = std::variant<Cylinder, Cone, Ruled>;

/// Point at (u, v) on the surface that lies `offset` along the normal from `surface`. The offset
/// surface keeps its rulings, and (u, v) names the same normal line on every offset (MATH 2.6).
Vec3 point_on(const Developable& surface, const Vec2& uv, double offset = 0.0);

/// Unit normal at azimuth u: away from the axis for cylinder and cone, b′ × g for a ruled surface.
Vec3 normal_on(const Developable& surface, double u);

/// Unit direction of the ruling through u, towards growing v.
Vec3 ruling_on(const Developable& surface, double u);

/// (u, v) of the point of the surface nearest to p; u is taken in the turn nearest to `u_near`.
Vec2 parameters_of(const Developable& surface, const Vec3& p, double u_near);

/// The isometry between one offset of a developable surface and the plane, in both directions
/// (MATH 2.2–2.5). Orientation: seen from the tip of the normal, the image is not mirrored.
/// Accuracy: cylinder and cone to machine precision; ruled surfaces to 1e-10 of their extent.
class Development {
 public:
  Development(const Developable& surface, double offset);

  /// Image in the plane of the point with parameters uv.
  Vec2 develop(const Vec2& uv) const;
  /// Parameters of the point whose image is p; the inverse of `develop`.
  Vec2 fold(const Vec2& p) const;
  /// Derivative of `develop`: columns are ∂/∂u and ∂/∂v.
  Eigen::Matrix2d jacobian(const Vec2& uv) const;
  /// Image of a curve given in (u, v). Segments along rulings, and every segment on a cylinder, are
  /// exact; a segment of constant v on a cone is an exact arc; all else is fitted to `tolerance`.
  Curve2 develop(const Curve2& uv_curve, double tolerance) const;

 private:
  struct PlaneKnot {
    double u;
    Vec2 b, b_prime;
    double angle, angle_prime;  // of the ruling's image
  };
  struct Rolled {
    double radius;
  };
  struct Sector {
    double sine;   // of the half-angle
    double shift;  // added to v: the offset cone's apex lies that much further back
  };
  std::variant<Rolled, Sector, std::vector<PlaneKnot>> image_;
};

}  // namespace planish
