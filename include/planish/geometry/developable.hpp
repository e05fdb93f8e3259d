#pragma once

#include <planish/geometry/curve.hpp>
#include <planish/geometry/frame.hpp>

#include <memory>
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

/// General developable x(u, v) = b(u) + v·g(u), |g| = 1, det(b′, g, g′) = 0
/// (math.md#general-developable), given by two or more knots with growing u. b is interpolated by
/// cubic Hermite spans, g by such spans scaled to unit length; beyond the first and last knot the
/// end spans continue. The normal is b′ × g, normalised; b′ and g must never be parallel. Between
/// knots h apart the spans deviate from the intended surface by O(h⁴), their normal by O(h³):
/// choose h for the accuracy wanted. The surface ends at its edge of regression, on the side where
/// b lies (v = 0).
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
/// surface keeps its rulings, and (u, v) names the same normal line on every offset
/// (math.md#neutral-surface).
Vec3 point_on(const Developable& surface, const Vec2& uv, double offset = 0.0);

/// Unit normal at azimuth u: away from the axis for cylinder and cone, b′ × g for a ruled surface.
/// On all three it is the direction of ∂/∂u × ∂/∂v.
Vec3 normal_on(const Developable& surface, double u);

/// Unit direction of the ruling through u, towards growing v.
Vec3 ruling_on(const Developable& surface, double u);

/// (u, v) of the point of the surface nearest to p. If several are equally near, as at every turn
/// of a cylinder or at the seam of a closed ruled surface, the one with u nearest to `u_near`. A
/// cone ends at its apex; the rulings of a ruled surface extend to the edge of regression, and a p
/// beyond its first or last ruling gets that ruling or one slightly beyond it.
/// Cost: constant for cylinder and cone, linear in the knots of a ruled surface.
Vec2 parameters_of(const Developable& surface, const Vec3& p, double u_near);

namespace geometry_detail {
class RuledImage;
}

/// The isometry between one offset of a developable surface and the plane, in both directions
/// (math.md#development). Orientation: seen from the tip of the normal, the image is not mirrored.
/// Placement: a cylinder's (u, v) goes to (ρu, v); a cone's apex to the origin, its ruling u = 0
/// along +x; a ruled surface's first knot to the origin, its first ruling along +y.
/// Requires a regular surface at that offset: ρ = radius + offset > 0, v + offset·cot(half-angle)
/// > 0, and of a ruled surface the side of the edge of regression where b lies.
/// Accuracy: cylinder and cone to machine precision; ruled surfaces to 1e-10 of their extent.
class Development {
 public:
  /// `u_near` chooses the turn that `fold` returns on a cone. Each point of a cone's image has
  /// several azimuths, 2π/sin(half-angle) apart; `fold` returns the one nearest to `u_near`. The
  /// middle of the face is a good choice. Cylinders and ruled surfaces do not need it.
  /// Cost for a ruled surface: linear in its knots, some 20 evaluations each.
  Development(const Developable& surface, double offset, double u_near = 0.0);

  /// Image in the plane of the point with parameters uv.
  Vec2 develop(const Vec2& uv) const;
  /// Parameters of the point whose image is p; the inverse of `develop`. Where the image of a ruled
  /// surface covers itself, the point nearest to b along its ruling; a p beyond its first or last
  /// ruling gets that ruling or one slightly beyond it.
  Vec2 fold(const Vec2& p) const;
  /// Derivative of `develop`: columns are ∂/∂u and ∂/∂v. Its determinant is positive.
  Eigen::Matrix2d jacobian(const Vec2& uv) const;
  /// Image of a curve given in (u, v). Segments along rulings, and segments and splines on a
  /// cylinder, are exact; a segment of constant v on a cone is an exact arc; everything else is
  /// fitted to `tolerance` (within the limit on spans of `fit_cubics`). Ends map to ends.
  Curve2 develop(const Curve2& uv_curve, double tolerance) const;

 private:
  struct Rolled {
    double radius;
  };
  struct Sector {
    double sine;   // of the half-angle
    double shift;  // added to v: the offset cone's apex lies that much further back
    double u_near;
  };
  using Unrolled = std::shared_ptr<const geometry_detail::RuledImage>;
  using Image = std::variant<Rolled, Sector, Unrolled>;

  static Image image_of(const Cylinder& cylinder, double offset, double u_near);
  static Image image_of(const Cone& cone, double offset, double u_near);
  static Image image_of(const Ruled& ruled, double offset, double u_near);

  Image image_;
};

}  // namespace planish
