#include "side_wall.hpp"

#include "kernel_points.hpp"

#include <planish/base/tolerance.hpp>

#include <Geom2d_Line.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>

#include <cmath>

// The cut edge between both skins. Between two circles about an axis it is a plane, a cylinder or a
// cone, along a straight border a plane, unless mitres twist it into a ruled surface; otherwise it
// is ruled between two curves fitted as one path, so that its rulings are the normals of the sheet.
// Its four edges get their curves in its parameters here, since these are known in closed form.

namespace planish::brep {
namespace {

/// Radii or heights that differ by less are the same, mm.
constexpr double kSame = 1e-9;

Handle(Geom2d_Curve) ray(const Vec2& from, const Vec2& direction) {
  return new Geom2d_Line(kernel_point(from), gp_Dir2d(direction.x(), direction.y()));
}

/// Curves of a wall whose u is `along` · the border's parameter and whose v is 0 on the reference
/// skin and ±depth on the other.
void set_curves(SideWall& wall, double along, double length, double v_other) {
  const double across = v_other > 0 ? 1.0 : -1.0;
  wall.on_reference = ray({0, 0}, {along, 0});
  wall.on_other = ray({0, v_other}, {along, 0});
  wall.at_start = ray({0, 0}, {0, across});
  wall.at_end = ray({along * length, 0}, {0, across});
  wall.middle = {along * 0.5 * length, 0};
}

Handle(Geom_Plane) plane(const Vec3& point, const Vec3& normal) {
  return new Geom_Plane(kernel_point(point), kernel_direction(normal));
}

/// Between two circles about one axis, run with equal angles.
void set_turned_surface(SideWall& wall, const SpaceCircle& reference, const SpaceCircle& other,
                        double sweep) {
  const double rise = (other.center - reference.center).dot(reference.axis);
  const double growth = other.radius - reference.radius;
  if (std::abs(rise) < kSame) {
    wall.surface = plane(reference.center, wall.outward);
    return;
  }
  if (std::abs(growth) < kSame) {
    wall.surface = new Geom_CylindricalSurface(
        kernel_axes(reference.center, reference.axis, reference.start), reference.radius);
    set_curves(wall, 1.0, sweep, rise);
    return;
  }
  // The kernel's cones grow along their axis: reverse it if the wall's does not.
  const double along = growth * rise > 0 ? 1.0 : -1.0;
  wall.surface = new Geom_ConicalSurface(
      kernel_axes(reference.center, along * reference.axis, reference.start),
      std::atan(std::abs(growth / rise)), reference.radius);
  set_curves(wall, along, sweep, std::copysign(std::hypot(growth, rise), growth));
}

}  // namespace

Vec3 outward_across(const Face& face, const BorderCurve& border, double s) {
  gp_Pnt2d p;
  gp_Vec2d d;
  border.uv->D1(s, p, d);
  const Vec2 uv(p.X(), p.Y());
  Vec3 along;
  if (const auto* frame = std::get_if<Frame>(&face.surface)) {
    along = d.X() * frame->x + d.Y() * frame->y;
  } else {
    const double h = tolerance::kAside * border.length;
    along = point_below(face, uv + h * Vec2(d.X(), d.Y()), 0.0) -
            point_below(face, uv - h * Vec2(d.X(), d.Y()), 0.0);
  }
  return along.cross(outward_normal(face, uv)).normalized();
}

SideWall straight_wall(const std::array<Vec3, 4>& corners, const Vec3& outward, double tolerance) {
  const auto& [a, b, a_other, b_other] = corners;
  SideWall wall;
  wall.outward = outward;
  const Vec3 normal = (b_other - a).cross(b - a_other).normalized();
  if (std::abs(normal.dot(a - b)) < tolerance && std::abs(normal.dot(a_other - a)) < tolerance &&
      std::abs(normal.dot(b_other - b)) < tolerance) {
    wall.surface = plane(a, normal.dot(outward) > 0 ? normal : Vec3(-normal));
    return wall;
  }
  const auto rails = [&](double u) -> Eigen::VectorXd {
    Eigen::VectorXd both(6);
    both << (1 - u) * a + u * b, (1 - u) * a_other + u * b_other;
    return both;
  };
  wall.surface = ruled_surface(fit_path(rails, {0.0, 1.0}, tolerance), 0.0, 1.0);
  wall.on_reference = plane_line({0, 0}, {1, 0}, (b - a).norm());
  wall.on_other = plane_line({0, 1}, {1, 1}, (b_other - a_other).norm());
  wall.at_start = plane_line({0, 0}, {0, 1}, (a_other - a).norm());
  wall.at_end = plane_line({1, 0}, {1, 1}, (b_other - b).norm());
  wall.middle = {0.5, 0.0};
  return wall;
}

CurvedWall curved_wall(const Face& face, const BorderCurve& border, const Depths& depths,
                       double tolerance) {
  CurvedWall result;
  SideWall& wall = result.wall;
  wall.outward = outward_across(face, border, 0.5 * border.length);
  switch (border.shape) {
    case BorderCurve::Shape::circle:
      set_turned_surface(wall, circle_below(face, border, depths.first),
                         circle_below(face, border, depths.second), border.length);
      return result;
    case BorderCurve::Shape::planar_spline:
      wall.surface = new Geom_SurfaceOfLinearExtrusion(
          space_curve_below(face, border, depths.first, tolerance),
          kernel_direction(-std::get<Frame>(face.surface).z));
      set_curves(wall, 1.0, border.length, depths.between());
      return result;
    case BorderCurve::Shape::general:
      break;
    case BorderCurve::Shape::line:
      break;
  }
  const FittedPath path = fit_two_depths(face, border, depths.first, depths.second, tolerance);
  result.reference_edge = space_curve(path, 0);
  result.other_edge = space_curve(path, 3);
  wall.surface = ruled_surface(path, 0.0, depths.between());
  set_curves(wall, 1.0, border.length, depths.between());
  return result;
}

}  // namespace planish::brep
