#include "ruling_range.hpp"

#include "border_curve.hpp"
#include "fitted_curve.hpp"

#include <planish/base/tolerance.hpp>

#include <Geom2d_BSplineCurve.hxx>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <ranges>

// The part of each ruling that a face uses, as a smooth limit that stays clear of the edge of
// regression (math.md#general-developable): the surface narrows along a ruling as 1 + q v, and a
// limit of −L / (1 + q L) is never where it vanishes, whatever q is. q is a polynomial through its
// values at nodes, so the rectangle of (u, v) that a kernel's B-spline needs carries no kink; nodes
// are doubled until it tells how wide the surface is at the limit.

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

NodePolynomial::NodePolynomial(const std::function<double(double)>& f, double lo, double hi,
                               int nodes) {
  for (int i = 0; i < nodes; ++i) {
    const double turn = std::numbers::pi * i / (nodes - 1);
    nodes_.push_back(std::lerp(lo, hi, 0.5 - 0.5 * std::cos(turn)));
    values_.push_back(f(nodes_.back()));
  }
}

double NodePolynomial::operator()(double u) const {
  // The barycentric formula; the weights of these nodes alternate, halved at the ends.
  double sum = 0.0, weights = 0.0;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (u == nodes_[i]) return values_[i];
    const double end = i == 0 || i + 1 == nodes_.size() ? 0.5 : 1.0;
    const double weight = (i % 2 == 0 ? end : -end) / (u - nodes_[i]);
    sum += weight * values_[i];
    weights += weight;
  }
  return sum / weights;
}

double RulingRange::limit(double u) const {
  return reach_ / (1.0 + std::abs(narrowing_(u) * reach_));
}

double RulingRange::lo(double u) const { return reach_ < 0.0 ? limit(u) : box_.lo.y(); }
double RulingRange::hi(double u) const { return reach_ > 0.0 ? limit(u) : box_.hi.y(); }

RulingRange ruling_range(const Face& face, double depth) {
  const RulingRange whole(parameter_box(face));
  const Box2& box = whole.box();
  const double span = box.size().y();
  const auto narrowing = [&](double u) {
    return (speed_across(face, {u, span}, depth) / speed_across(face, {u, 0.0}, depth) - 1.0) /
           span;
  };
  const auto at = [&](int i) { return std::lerp(box.lo.x(), box.hi.x(), double(i) / kSamples); };
  std::vector<double> sampled;
  for (int i = 0; i <= kSamples; ++i)
    sampled.push_back(narrowing(at(i)));
  // If narrower than this share of its width at v = 0, readers do not accept it as a regular
  // surface.
  constexpr double narrowest = 0.1;
  const auto [least, most] = std::ranges::minmax(sampled);
  const bool narrow_below = 1.0 + most * box.lo.y() < narrowest && least > 0.0;
  const bool narrow_above = 1.0 + least * box.hi.y() < narrowest && most < 0.0;
  if (!narrow_below && !narrow_above) return whole;
  const double side = narrow_below ? -1.0 : 1.0;
  RulingRange range = whole;
  // What remains of the width at the limit is small, and the polynomial must tell it.
  const auto tells_the_width = [&](int i) {
    const double q = range.narrowing_(at(i));
    const double remains = 1.0 + sampled[i] * range.limit(at(i));
    constexpr double kPart = 0.5;
    return q * side < 0.0 && remains * (1.0 + std::abs(q * range.reach_)) > kPart;
  };
  constexpr int kMostNodes = 129;
  for (int nodes = 5; nodes <= kMostNodes; nodes = 2 * nodes - 1) {
    range.narrowing_ = NodePolynomial(narrowing, box.lo.x(), box.hi.x(), nodes);
    range.reach_ = side * reach_of(face, side, range.narrowing_);
    if (std::ranges::all_of(std::views::iota(0, kSamples + 1), tells_the_width)) return range;
  }
  return whole;
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
