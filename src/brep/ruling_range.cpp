#include "ruling_range.hpp"

#include "border_curve.hpp"
#include "fitted_curve.hpp"

#include <planish/base/tolerance.hpp>

#include <Geom2d_BSplineCurve.hxx>

#include <algorithm>
#include <cmath>

// The part of each ruling that a face uses, as a smooth limit that stays clear of the edge of
// regression (math.md#general-developable): the surface narrows along a ruling as 1 + q v, and a
// limit of −L / (1 + q L) is never where it vanishes, whatever q is. q is a polynomial through its
// values at nodes, so the rectangle of (u, v) that a kernel's B-spline needs carries no kink.

namespace planish::brep {
namespace {

constexpr int kSamples = 64;

/// Largest L that a border point needs: v ≥ −L/(1 + q L) is L ≥ −v/(1 + q v), and mirrored.
double reach_of(const Face& face, double side, const auto& narrowing) {
  double reach = 0.0;
  for (const BorderLoop& loop : face.loops)
    for (const Border& border : loop)
      for (int i = 0; i <= kSamples; ++i) {
        const Vec2 uv = point_at(border.curve, double(i) / kSamples);
        const double left = 1.0 + narrowing(uv.x()) * uv.y();
        if (side * uv.y() > 0.0) reach = std::max(reach, left > 0.0 ? side * uv.y() / left : 1e300);
      }
  constexpr double beyond = 1.01;  // of what the samples need, as a margin between them
  return beyond * reach;
}

}  // namespace

double speed_across(const Face& face, const Vec2& uv, double depth) {
  const auto& surface = std::get<Developable>(face.surface);
  const auto& knots = std::get<Ruled>(surface).knots;
  constexpr double kStep = tolerance::kDifference;  // of the range of u
  const Vec2 h(kStep * (knots.back().u - knots.front().u), 0.0);
  const Vec3 across = ruling_on(surface, uv.x()).cross(normal_on(surface, uv.x()));
  return (point_below(face, uv + h, depth) - point_below(face, uv - h, depth)).dot(across) /
         (2 * h.x());
}

double RulingRange::narrowing(double u) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < nodes; ++i) {
    double weight = narrowing_[i];
    for (std::size_t j = 0; j < nodes; ++j)
      if (j != i) weight *= (u - node(j)) / (node(i) - node(j));
    sum += weight;
  }
  return sum;
}

double RulingRange::limit(double u) const {
  return reach_ / (1.0 + std::abs(narrowing(u) * reach_));
}

double RulingRange::lo(double u) const { return reach_ < 0.0 ? limit(u) : box_.lo.y(); }
double RulingRange::hi(double u) const { return reach_ > 0.0 ? limit(u) : box_.hi.y(); }

RulingRange ruling_range(const Face& face, double depth) {
  RulingRange range(parameter_box(face));
  const Box2& box = range.box_;
  const RulingRange whole = range;
  const double span = box.size().y();
  const auto narrowing = [&](double u) {
    return (speed_across(face, {u, span}, depth) / speed_across(face, {u, 0.0}, depth) - 1.0) /
           span;
  };
  for (std::size_t i = 0; i < RulingRange::nodes; ++i)
    range.narrowing_[i] = narrowing(range.node(i));
  // If narrower than this share of its width at v = 0, readers do not accept it as a regular
  // surface.
  constexpr double narrowest = 0.1;
  const auto [least, most] = std::ranges::minmax(range.narrowing_);
  const bool narrow_below = 1.0 + most * box.lo.y() < narrowest && least > 0.0;
  const bool narrow_above = 1.0 + least * box.hi.y() < narrowest && most < 0.0;
  if (!narrow_below && !narrow_above) return whole;
  const double side = narrow_below ? -1.0 : 1.0;
  range.reach_ = side * reach_of(face, side, [&](double u) { return range.narrowing(u); });
  for (int i = 0; i <= kSamples; ++i) {
    const double u = box.lo.x() + box.size().x() * i / kSamples;
    if (range.narrowing(u) * side >= 0.0 || 1.0 + narrowing(u) * range.limit(u) <= 0.0)
      return whole;
  }
  return range;
}

Handle(Geom2d_Curve) carried_into(const RulingRange& range, const Handle(Geom2d_Curve) & curve,
                                  double length, double tolerance) {
  const Box2& box = range.box();
  const auto carried = [&](const gp_Pnt2d& p) -> Vec2 {
    const double lo = range.lo(p.X()), hi = range.hi(p.X());
    return {p.X(), box.lo.y() + box.size().y() * (p.Y() - lo) / (hi - lo)};
  };
  const gp_Pnt2d start = curve->Value(0.0), end = curve->Value(length);
  if (std::abs(end.X() - start.X()) < tolerance::kRounding * box.size().x())
    return plane_line(carried(start), carried(end), length);

  std::vector<double> breaks{0.0, length};
  if (const auto spline = Handle(Geom2d_BSplineCurve)::DownCast(curve); !spline.IsNull())
    for (int i = spline->FirstUKnotIndex() + 1; i < spline->LastUKnotIndex(); ++i)
      breaks.insert(breaks.end() - 1, spline->Knot(i));
  // As long in u as in v, so that the tolerance means the same for both.
  const double scale = box.size().y() / box.size().x();
  FittedPath path = fit_path(
      [&](double s) -> Eigen::VectorXd {
        return carried(curve->Value(s)).cwiseProduct(Vec2(scale, 1.0));
      },
      breaks, tolerance);
  for (auto* rows : {&path.values, &path.slopes})
    for (Eigen::VectorXd& row : *rows)
      row.x() /= scale;
  return plane_curve(path);
}

}  // namespace planish::brep
