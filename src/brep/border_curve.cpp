#include "border_curve.hpp"

#include "fitted_curve.hpp"
#include "kernel_points.hpp"

#include <planish/base/tolerance.hpp>

#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Circle.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Line.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <gp_Circ2d.hxx>

#include <algorithm>
#include <cmath>

// A border of a face, run over one parameter in (u, v) and in space alike: the kernel requires an
// edge's curves to agree at equal parameters. Lines and circles stay exact where the surface has
// them; others are fitted in space, with a knot wherever the border or the surface below it is not
// smooth. Across a joint the neighbour's own border is used if its points agree, else the leading
// one is projected onto the neighbour.

namespace planish::brep {
namespace {

using Shape = BorderCurve::Shape;

/// Smaller corners are rounding of a fit.
constexpr double kKink = tolerance::kFileDigits;  // radians
/// Share of a border's length: parameters closer than this are one knot.
constexpr double kSameKnot = tolerance::kComputed;

const Developable* developable(const Face& face) { return std::get_if<Developable>(&face.surface); }

/// Millimetres per unit of u at height v of the reference skin; 0 where it has no circles.
double circle_radius(const Developable& surface, double v) {
  if (const auto* cylinder = std::get_if<Cylinder>(&surface)) return cylinder->radius;
  if (const auto* cone = std::get_if<Cone>(&surface)) return v * std::sin(cone->half_angle);
  return 0.0;
}

Shape shape_of_segment(const Face& face, const Segment& segment, double tolerance) {
  const Developable* surface = developable(face);
  if (surface == nullptr) return Shape::line;
  const Vec2 d = (segment.b - segment.a).cwiseAbs();
  const double radius = std::max(circle_radius(*surface, segment.a.y()),
                                 circle_radius(*surface, segment.b.y()));
  if (radius == 0.0) {
    // On a ruled surface u is any parameter: the points decide.
    const Vec3 drift = point_on(*surface, segment.b) -
                       point_on(*surface, {segment.a.x(), segment.b.y()});
    return drift.norm() < tolerance && d.y() > tolerance ? Shape::line : Shape::general;
  }
  if (d.x() * radius < tolerance) return Shape::line;
  return d.y() < tolerance ? Shape::circle : Shape::general;
}

/// Where a fit needs a knot: where the curve or the surface under it is not smooth.
std::vector<double> breaks_of(const Face& face, const BorderCurve& border) {
  std::vector<double> breaks{0.0, border.length};
  if (const auto spline = Handle(Geom2d_BSplineCurve)::DownCast(border.uv); !spline.IsNull())
    for (int i = 2; i < spline->NbKnots(); ++i)
      breaks.push_back(spline->Knot(i));
  const Developable* surface = developable(face);
  const auto* ruled = surface != nullptr ? std::get_if<Ruled>(surface) : nullptr;
  if (ruled != nullptr && !Handle(Geom2d_Line)::DownCast(border.uv).IsNull()) {
    const double u0 = border.at(0).x(), u1 = border.at(border.length).x();
    for (const Ruled::Knot& knot : ruled->knots) {
      const double s = (knot.u - u0) / (u1 - u0) * border.length;
      if (s > kSameKnot * border.length && s < (1 - kSameKnot) * border.length) breaks.push_back(s);
    }
  }
  std::ranges::sort(breaks);
  const auto repeated = std::ranges::unique(
      breaks, [&](double a, double b) { return b - a < kSameKnot * border.length; });
  breaks.erase(repeated.begin(), repeated.end());
  return breaks;
}

Handle(Geom_Curve) lifted(const Face& face, const BorderCurve& border, double depth) {
  const auto spline = Handle(Geom2d_BSplineCurve)::DownCast(border.uv);
  TColgp_Array1OfPnt poles(1, spline->NbPoles());
  for (int i = 1; i <= spline->NbPoles(); ++i) {
    const gp_Pnt2d p = spline->Pole(i);
    poles.SetValue(i, kernel_point(point_below(face, {p.X(), p.Y()}, depth)));
  }
  return new Geom_BSplineCurve(poles, spline->Knots(), spline->Multiplicities(), 3);
}

/// The border's (u, v) curve over 0 … length; null if it cannot be stretched to that.
Handle(Geom2d_Curve) with_length(const BorderCurve& border, double length) {
  if (std::abs(border.length - length) < tolerance::kRounding * length) return border.uv;
  if (!Handle(Geom2d_Line)::DownCast(border.uv).IsNull()) return border.uv;
  const auto spline = Handle(Geom2d_BSplineCurve)::DownCast(border.uv);
  if (spline.IsNull()) return {};
  TColStd_Array1OfReal knots = spline->Knots();
  for (int i = knots.Lower(); i <= knots.Upper(); ++i)
    knots(i) *= length / border.length;
  const Handle(Geom2d_BSplineCurve)
      stretched = Handle(Geom2d_BSplineCurve)::DownCast(spline->Copy());
  stretched->SetKnots(knots);
  return stretched.get();
}

}  // namespace

Vec3 point_below(const Face& face, const Vec2& uv, double depth) {
  if (const Developable* surface = developable(face))
    return point_on(*surface, uv, -face.sense * depth);
  const Frame& frame = std::get<Frame>(face.surface);
  return frame.point(uv) - depth * frame.z;
}

Vec2 BorderCurve::at(double s) const {
  const gp_Pnt2d p = uv->Value(s);
  return {p.X(), p.Y()};
}

BorderCurve border_curve(const Face& face, const Curve2& border, double tolerance) {
  if (const auto* segment = std::get_if<Segment>(&border)) {
    const Vec2 d = segment->b - segment->a;
    return {shape_of_segment(face, *segment, tolerance),
            new Geom2d_Line(kernel_point(segment->a), gp_Dir2d(d.x(), d.y())), d.norm()};
  }
  const bool plane = developable(face) == nullptr;
  if (const auto* arc = std::get_if<Arc>(&border)) {
    const gp_Ax2d axis(kernel_point(arc->center),
                       gp_Dir2d(std::cos(arc->start), std::sin(arc->start)));
    return {plane ? Shape::circle : Shape::general,
            new Geom2d_Circle(axis, arc->radius, arc->sweep > 0), std::abs(arc->sweep)};
  }
  const Handle(Geom2d_BSplineCurve) curve = plane_curve(std::get<CubicSpline>(border), kKink);
  return {plane ? Shape::planar_spline : Shape::general, curve.get(), curve->LastParameter()};
}

SpaceCircle circle_below(const Face& face, const BorderCurve& border, double depth) {
  const Vec2 first = border.at(0);
  const Vec3 start = point_below(face, first, depth);
  SpaceCircle circle;
  if (const Developable* surface = developable(face)) {
    const Frame& frame = std::holds_alternative<Cylinder>(*surface)
                             ? std::get<Cylinder>(*surface).frame
                             : std::get<Cone>(*surface).frame;
    circle.center = frame.origin + (start - frame.origin).dot(frame.z) * frame.z;
    circle.axis = border.at(border.length).x() > first.x() ? frame.z : Vec3(-frame.z);
  } else {
    const auto planar = Handle(Geom2d_Circle)::DownCast(border.uv);
    const gp_Pnt2d center = planar->Location();
    circle.center = point_below(face, {center.X(), center.Y()}, depth);
    const Vec3& z = std::get<Frame>(face.surface).z;
    circle.axis = planar->Circ2d().IsDirect() ? z : Vec3(-z);
  }
  circle.radius = (start - circle.center).norm();
  circle.start = (start - circle.center) / circle.radius;
  return circle;
}

Handle(Geom_Curve)
    space_curve_below(const Face& face, const BorderCurve& border, double depth, double tolerance) {
  switch (border.shape) {
    case Shape::line: {
      const Vec3 start = point_below(face, border.at(0), depth);
      const Vec3 d = point_below(face, border.at(border.length), depth) - start;
      return new Geom_Line(kernel_point(start), kernel_direction(d));
    }
    case Shape::circle: {
      const SpaceCircle c = circle_below(face, border, depth);
      return new Geom_Circle(kernel_axes(c.center, c.axis, c.start), c.radius);
    }
    case Shape::planar_spline:
      return lifted(face, border, depth);
    case Shape::general:
      break;
  }
  return space_curve(fit_two_depths(face, border, depth, depth, tolerance), 0);
}

FittedPath fit_two_depths(const Face& face, const BorderCurve& border, double depth0, double depth1,
                          double tolerance) {
  const auto points = [&](double s) {
    Eigen::VectorXd both(6);
    const Vec2 uv = border.at(s);
    both << point_below(face, uv, depth0), point_below(face, uv, depth1);
    return both;
  };
  return fit_path(points, breaks_of(face, border), tolerance);
}

Handle(Geom2d_Curve) across_joint(const Face& face, const BorderCurve& border, const Face& other,
                                  const Curve2& reversed_other, double tolerance) {
  const Developable* surface = developable(other);
  if (surface == nullptr) return {};
  const BorderCurve own = border_curve(other, reversed_other, tolerance);
  const auto on_edge = [&](double s) { return point_below(face, border.at(s), 0.0); };
  const auto gap = [&](double share) {
    return (point_below(other, own.at(share * own.length), 0.0) - on_edge(share * border.length))
        .norm();
  };
  double apart = 0.0;
  for (int i = 1; i < 16; ++i)
    apart = std::max(apart, gap(i / 16.0));
  // If the ends are as far apart, the borders themselves differ, not only their parameters.
  if (apart < tolerance + 2 * std::max(gap(0.0), gap(1.0)))
    if (const Handle(Geom2d_Curve) same = with_length(own, border.length); !same.IsNull())
      return same;

  const Vec2 start = own.at(0.0), end = own.at(own.length);
  const auto projection = [&](double s) {
    const double near = start.x() + (end.x() - start.x()) * s / border.length;
    return parameters_of(*surface, on_edge(s), near);
  };
  // Ends as the face's loop has them, so that it stays closed in (u, v).
  const Vec2 start_gap = start - projection(0.0), end_gap = end - projection(border.length);
  const auto path = [&](double s) -> Eigen::VectorXd {
    const double share = s / border.length;
    return projection(s) + (1.0 - share) * start_gap + share * end_gap;
  };
  return plane_curve(fit_path(path, breaks_of(face, border), tolerance));
}

Handle(Geom2d_Curve)
    curve_in_own_face(const Sheet& sheet, const SheetCorners& corners, BorderId border,
                      const BorderCurve& leading, double tolerance) {
  const auto face_of = [&](BorderId id) -> const Face& {
    return sheet[corners.topology()[id].face];
  };
  if (std::holds_alternative<Frame>(face_of(border).surface)) return {};
  if (corners.leads(border)) return leading.uv;
  return across_joint(face_of(corners.leader(border)), leading, face_of(border),
                      reversed(sheet[corners.topology()[border]].curve), tolerance);
}

}  // namespace planish::brep
