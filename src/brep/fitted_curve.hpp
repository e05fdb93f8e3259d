#pragma once

#include <planish/geometry/curve.hpp>
#include <planish/geometry/frame.hpp>

#include <Geom2d_BSplineCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>

#include <functional>
#include <vector>

namespace planish::brep {

/// A point in space of one parameter, or several moving together: coordinates one after the other.
using PathFunction = std::function<Eigen::VectorXd(double)>;

/// Cubic Hermite spans through a path, C1.
struct FittedPath {
  std::vector<double> knots;
  std::vector<Eigen::VectorXd> values, slopes;  ///< at the knots
};

/// Fits f between the first and the last of `breaks` (two or more, ascending; all become knots, so
/// give the places where f is not smooth). Spans are halved until three points in each are within
/// `tolerance`, at most 2^10 times as fine as the breaks.
FittedPath fit_path(const PathFunction& f, const std::vector<double>& breaks, double tolerance);

/// The coordinates 0–2 (or 3–5) of the path, and 0–1 in the plane, as B-splines over its knots.
Handle(Geom_BSplineCurve) space_curve(const FittedPath& path, int first_coordinate);
Handle(Geom2d_BSplineCurve) plane_curve(const FittedPath& path);

/// The surface that joins coordinates 0–2 (at v0) straight to coordinates 3–5 (at v1).
Handle(Geom_BSplineSurface) ruled_surface(const FittedPath& path, double v0, double v1);

/// A planar spline as a B-spline with knots spaced so that it is C1 wherever its spans are tangent
/// to each other; begins at parameter 0. Tangents that differ by more than `kink` radians stay
/// corners.
Handle(Geom2d_BSplineCurve) plane_curve(const CubicSpline& spline, double kink);

/// From a to b at constant speed, parameter 0 to `length`.
Handle(Geom2d_BSplineCurve) plane_line(const Vec2& a, const Vec2& b, double length);

}  // namespace planish::brep
