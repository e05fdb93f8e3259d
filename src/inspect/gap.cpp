// Nearest points of two curves or loops. Exact for segments and for full circles outside the other
// curve; others are sampled on the rounder one and refined by golden section. Boxes leave out what
// cannot be nearer.

#include "gap.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/geometry/box_tree.hpp>
#include <planish/geometry/minimum.hpp>
#include <planish/geometry/plane.hpp>

#include <cmath>
#include <numbers>

// The least distance of two curves, with its places. Segments and full circles have closed forms;
// otherwise one curve is sampled and the distance to the other, which is exact, refined by golden
// section about the best sample. That can only miss a second place that is equally near. Loops
// leave out curves whose boxes are farther than the best so far.

namespace planish::inspect_detail {
namespace {

Gap swapped(const Gap& gap) { return {gap.distance, gap.b, gap.a}; }

void keep_nearer(Gap& best, const Gap& other) {
  if (other.distance < best.distance) best = other;
}

/// From a point to the nearest point of a curve.
Gap gap_from(const Vec2& p, const Curve2& curve) {
  const Nearest found = nearest(curve, p);
  return {found.distance, p, point_at(curve, found.t)};
}

Gap gap_of_ends(const Curve2& a, const Curve2& b) {
  Gap best = gap_from(start_of(a), b);
  keep_nearer(best, gap_from(end_of(a), b));
  keep_nearer(best, swapped(gap_from(start_of(b), a)));
  keep_nearer(best, swapped(gap_from(end_of(b), a)));
  return best;
}

Gap gap_of_segments(const Segment& a, const Segment& b) {
  const Vec2 da = a.b - a.a;
  const Vec2 db = b.b - b.a;
  const double det = cross(da, db);
  if (det != 0.0) {
    const Vec2 w = b.a - a.a;
    const double s = cross(w, db) / det;
    const double t = cross(w, da) / det;
    if (s >= 0.0 && s <= 1.0 && t >= 0.0 && t <= 1.0) {
      const Vec2 meeting = a.a + s * da;
      return {0.0, meeting, meeting};
    }
  }
  return gap_of_ends(a, b);  // segments that do not cross are nearest at an end of one
}

const Arc* full_circle(const Curve2& curve) {
  const Arc* arc = std::get_if<Arc>(&curve);
  constexpr double kFull = 2.0 * std::numbers::pi * (1.0 - tolerance::kRounding);
  return arc && std::abs(arc->sweep) >= kFull ? arc : nullptr;
}

/// From a full circle to a curve outside it; empty if the curve reaches into it.
Gap gap_of_circle(const Arc& circle, const Curve2& curve) {
  const Gap from_center = gap_from(circle.center, curve);
  if (from_center.distance <= circle.radius) return {};
  const Vec2 out = (from_center.b - circle.center) / from_center.distance;
  return {from_center.distance - circle.radius, circle.center + circle.radius * out, from_center.b};
}

int sample_count(const Curve2& curve) {
  if (const Arc* arc = std::get_if<Arc>(&curve))
    return 4 + static_cast<int>(std::abs(arc->sweep) * 16.0 / std::numbers::pi);
  if (const auto* spline = std::get_if<CubicSpline>(&curve))
    return 8 * static_cast<int>(spline->poles.size() / 3);
  return 16;
}

Gap gap_by_sampling(const Curve2& a, const Curve2& b) {
  constexpr int kSteps = 45;  // 0.618^45 = 4e-10 of the interval: beyond, rounding decides
  const auto distance_at = [&](double t) { return nearest(b, point_at(a, t)).distance; };
  Gap best = gap_of_ends(a, b);
  keep_nearer(best,
              gap_from(point_at(a, least_at(distance_at, 0.0, 1.0, sample_count(a), kSteps)), b));
  return best;
}

}  // namespace

BoxedLoop::BoxedLoop(const Loop& curves) : loop(&curves) {
  for (const Curve2& curve : curves) {
    boxes.push_back(bounds(curve));
    box.add(boxes.back());
  }
}

Gap gap_between(const Curve2& a, const Curve2& b) {
  const auto* segment_a = std::get_if<Segment>(&a);
  const auto* segment_b = std::get_if<Segment>(&b);
  if (segment_a && segment_b) return gap_of_segments(*segment_a, *segment_b);
  if (const Arc* circle = full_circle(a)) {
    if (const Gap gap = gap_of_circle(*circle, b); std::isfinite(gap.distance)) return gap;
  }
  if (const Arc* circle = full_circle(b)) {
    if (const Gap gap = gap_of_circle(*circle, a); std::isfinite(gap.distance)) return swapped(gap);
  }
  // The nearest point on the straighter curve is faster to find, so the other one is sampled.
  return segment_a ? swapped(gap_by_sampling(b, a)) : gap_by_sampling(a, b);
}

Gap gap_between(const BoxedLoop& a, const Curve2& b, double reach) {
  const Box2 box = bounds(b);
  Gap best;
  best.distance = reach;
  bool found = false;
  for (size_t i = 0; i < a.loop->size(); ++i) {
    if (box_distance(a.boxes[i], box) >= best.distance) continue;
    const Gap gap = gap_between((*a.loop)[i], b);
    if (gap.distance >= best.distance) continue;
    best = gap;
    found = true;
  }
  return found ? best : Gap{};
}

Gap gap_between(const BoxedLoop& a, const BoxedLoop& b, double reach) {
  Gap best;
  for (size_t i = 0; i < b.loop->size(); ++i) {
    const double nearer = std::min(reach, best.distance);
    if (box_distance(a.box, b.boxes[i]) >= nearer) continue;
    keep_nearer(best, gap_between(a, (*b.loop)[i], nearer));
  }
  return best;
}

}  // namespace planish::inspect_detail
