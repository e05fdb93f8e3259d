#include "fitted_curve.hpp"

#include "kernel_points.hpp"

#include <planish/base/tolerance.hpp>

#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TColgp_Array2OfPnt.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

// Paths of several coordinates fitted by cubic Hermite spans with common knots, so that curves that
// belong together (both edges of a wall, space and parameters) keep one parameter. Spans are halved
// until three points in each are near enough. C1 spans become a cubic B-spline with two poles a
// knot, and a planar spline gets knots spaced by its speed, so that it is C1 wherever its spans are
// tangent.

namespace planish::brep {
namespace {

using Eigen::VectorXd;

/// Slope by differences within [lo, hi]: f need not exist outside.
VectorXd slope(const PathFunction& f, double t, double lo, double hi) {
  constexpr double kStep = tolerance::kDifference;  // of the range
  const double h = kStep * (hi - lo);
  if (t - h < lo) return (4 * f(t + h) - f(t + 2 * h) - 3 * f(t)) / (2 * h);
  if (t + h > hi) return (3 * f(t) - 4 * f(t - h) + f(t - 2 * h)) / (2 * h);
  return (f(t + h) - f(t - h)) / (2 * h);
}

struct Knot {
  double t;
  VectorXd value, slope;
};

VectorXd between(const Knot& a, const Knot& b, double t) {
  const double h = b.t - a.t, s = (t - a.t) / h, r = 1 - s;
  return r * r * (1 + 2 * s) * a.value + s * s * (1 + 2 * r) * b.value +
         h * s * r * (r * a.slope - s * b.slope);
}

class Fitter {
 public:
  Fitter(const PathFunction& f, double lo, double hi, double tolerance)
      : f_(f), lo_(lo), hi_(hi), tolerance_(tolerance) {}

  Knot at(double t) const { return {t, f_(t), slope(f_, t, lo_, hi_)}; }

  /// Appends the knots after a up to b.
  void refine(const Knot& a, const Knot& b, int halvings, std::vector<Knot>& knots) const {
    if (halvings == 0 || close(a, b)) {
      knots.push_back(b);
      return;
    }
    const Knot middle = at(0.5 * (a.t + b.t));
    refine(a, middle, halvings - 1, knots);
    refine(middle, b, halvings - 1, knots);
  }

 private:
  bool close(const Knot& a, const Knot& b) const {
    return std::ranges::all_of(std::vector<double>{0.21, 0.5, 0.79}, [&](double s) {
      const double t = a.t + s * (b.t - a.t);
      return (f_(t) - between(a, b, t)).lpNorm<Eigen::Infinity>() <= tolerance_;
    });
  }

  const PathFunction& f_;
  double lo_, hi_, tolerance_;
};

/// A list as the kernel takes them, from 1.
template <typename Array, typename List, typename Function = std::identity>
Array kernel_array(const List& list, const Function& function = {}) {
  Array array(1, static_cast<int>(list.size()));
  for (int i = 1; i <= array.Length(); ++i)
    array.SetValue(i, function(list[static_cast<std::size_t>(i) - 1]));
  return array;
}

/// Knots and multiplicities of a cubic B-spline: `inner` at the knots between the ends.
struct CubicKnots {
  TColStd_Array1OfReal values;
  TColStd_Array1OfInteger counts;

  explicit CubicKnots(const std::vector<double>& knots)
      : values(1, static_cast<int>(knots.size())), counts(1, static_cast<int>(knots.size())) {
    for (std::size_t i = 0; i < knots.size(); ++i) {
      values.SetValue(static_cast<int>(i) + 1, knots[i]);
      counts.SetValue(static_cast<int>(i) + 1, i == 0 || i + 1 == knots.size() ? 4 : 2);
    }
  }
};

/// B-spline poles of C1 Hermite spans: two at each knot.
std::vector<VectorXd> poles_of(const FittedPath& path) {
  std::vector<VectorXd> poles;
  const std::size_t last = path.knots.size() - 1;
  for (std::size_t i = 0; i <= last; ++i) {
    if (i == 0) poles.push_back(path.values[i]);
    if (i > 0)
      poles.push_back(path.values[i] - (path.knots[i] - path.knots[i - 1]) / 3 * path.slopes[i]);
    if (i < last)
      poles.push_back(path.values[i] + (path.knots[i + 1] - path.knots[i]) / 3 * path.slopes[i]);
    if (i == last) poles.push_back(path.values[i]);
  }
  return poles;
}

}  // namespace

FittedPath fit_path(const PathFunction& f, const std::vector<double>& breaks, double tolerance) {
  const Fitter fitter(f, breaks.front(), breaks.back(), tolerance);
  std::vector<Knot> knots{fitter.at(breaks.front())};
  for (std::size_t i = 1; i < breaks.size(); ++i) {
    const Knot from = knots.back();
    fitter.refine(from, fitter.at(breaks[i]), 10, knots);
  }
  FittedPath path;
  for (const Knot& knot : knots) {
    path.knots.push_back(knot.t);
    path.values.push_back(knot.value);
    path.slopes.push_back(knot.slope);
  }
  return path;
}

Handle(Geom_BSplineCurve) space_curve(const FittedPath& path, int first_coordinate) {
  const auto points = kernel_array<TColgp_Array1OfPnt>(poles_of(path), [&](const VectorXd& pole) {
    return kernel_point(Vec3(pole.segment<3>(first_coordinate)));
  });
  const CubicKnots knots(path.knots);
  return new Geom_BSplineCurve(points, knots.values, knots.counts, 3);
}

Handle(Geom2d_BSplineCurve) plane_curve(const FittedPath& path) {
  const auto points = kernel_array<TColgp_Array1OfPnt2d>(
      poles_of(path), [](const VectorXd& pole) { return kernel_point(Vec2(pole.head<2>())); });
  const CubicKnots knots(path.knots);
  return new Geom2d_BSplineCurve(points, knots.values, knots.counts, 3);
}

Handle(Geom_BSplineSurface) ruled_surface(const FittedPath& path, double v0, double v1) {
  const std::vector<VectorXd> poles = poles_of(path);
  TColgp_Array2OfPnt points(1, static_cast<int>(poles.size()), 1, 2);
  for (std::size_t i = 0; i < poles.size(); ++i)
    for (int side : {0, 1})
      points.SetValue(static_cast<int>(i) + 1, side + 1,
                      kernel_point(Vec3(poles[i].segment<3>(3 * side))));
  const CubicKnots u(path.knots);
  const auto v = kernel_array<TColStd_Array1OfReal>(std::array{v0, v1});
  const auto counts = kernel_array<TColStd_Array1OfInteger>(std::array{2, 2});
  return new Geom_BSplineSurface(points, u.values, v, u.counts, counts, 3, 1);
}

Handle(Geom2d_BSplineCurve) plane_curve(const CubicSpline& spline, double kink) {
  const int pieces = static_cast<int>(spline.poles.size() - 1) / 3;
  std::vector<Vec2> poles{spline.poles[0]};
  TColStd_Array1OfReal knots(1, pieces + 1);
  TColStd_Array1OfInteger counts(1, pieces + 1);
  double width = 1.0, end = 0.0;
  for (int i = 0; i < pieces; ++i) {
    const Vec2* p = &spline.poles[3 * i];
    bool smooth = false;
    if (i > 0) {
      const Vec2 before = p[0] - p[-1], after = p[1] - p[0];
      const double sine = before.x() * after.y() - before.y() * after.x();
      smooth = std::abs(std::atan2(sine, before.dot(after))) < kink && before.norm() > 0.0;
      // Equal speed on both sides: handles are proportional to the widths of the spans.
      if (smooth) width *= after.norm() / before.norm();
      if (!smooth) poles.push_back(p[0]);
    }
    poles.insert(poles.end(), {p[1], p[2]});
    knots.SetValue(i + 1, end);
    counts.SetValue(i + 1, i == 0 ? 4 : smooth ? 2 : 3);
    end += width;
  }
  poles.push_back(spline.poles.back());
  knots.SetValue(pieces + 1, end);
  counts.SetValue(pieces + 1, 4);
  const auto points = kernel_array<TColgp_Array1OfPnt2d>(
      poles, [](const Vec2& pole) { return kernel_point(pole); });
  return new Geom2d_BSplineCurve(points, knots, counts, 3);
}

Handle(Geom2d_BSplineCurve) plane_line(const Vec2& a, const Vec2& b, double length) {
  return new Geom2d_BSplineCurve(
      kernel_array<TColgp_Array1OfPnt2d>(std::array{kernel_point(a), kernel_point(b)}),
      kernel_array<TColStd_Array1OfReal>(std::array{0.0, length}),
      kernel_array<TColStd_Array1OfInteger>(std::array{2, 2}), 1);
}

}  // namespace planish::brep
