#include "meetings.hpp"

#include <planish/base/id_vector.hpp>
#include <planish/base/tolerance.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

// Where material below two triangles is shared: points just below both planes, on the line where
// they cross, or below the lower of two that cover each other (math.md#self-intersection). Corners
// within rounding of a plane are in it, with a height of exactly 0. Skins that touch enclose a flat
// wedge and are left out, as are triangles with an edge in common.

namespace planish::collision_detail {
namespace {

/// Corners this near another triangle's plane lie in it; of the triangles' extent.
constexpr double kInPlane = tolerance::kComputed;
/// Planes that make a smaller angle (radians) and look at each other enclose a wedge in which a
/// point that is deep enough lies far from where they meet: skins that touch.
constexpr double kFlatWedge = 1e-3;
/// Cosine of the angle up to which triangles that cover each other count as one above the other.
constexpr double kSameWay = 0.9;
/// What two triangles cover together is a strip between neighbouring faces, drawn over each other
/// by rounding, if it is narrower than this share of the reach.
constexpr double kNarrow = 0.5;
/// Where along a crossing to look: a corner of what is shared may be narrow.
constexpr std::array<double, 3> kPlaces{0.5, 0.15, 0.85};

double extent(const Triangle& a, const Triangle& b) {
  double largest = 0.0;
  for (int i = 0; i < 3; ++i)
    for (const Triangle* t : {&a, &b})
      largest = std::max(largest, (t->corners[i] - a.corners[0]).cwiseAbs().maxCoeff());
  return largest;
}

/// Distances of a triangle's corners above another's plane; corners in the plane have exactly 0.
std::array<double, 3> heights(const Triangle& of, const Triangle& over, double in_plane) {
  std::array<double, 3> result;
  for (int i = 0; i < 3; ++i) {
    const double h = over.normal.dot(of.corners[i] - over.corners[0]);
    result[i] = std::abs(h) <= in_plane ? 0.0 : h;
  }
  return result;
}

bool goes_below(const std::array<double, 3>& h) { return std::ranges::min(h) < 0.0; }

struct Span {
  double low, high;
};

/// The part of a line, by distance along it, that lies in a triangle whose corners have these
/// heights above a plane through the line. Empty if the triangle meets the plane in a point only.
std::optional<Span> span_in_plane(const Triangle& t, const std::array<double, 3>& h,
                                  const Vec3& origin, const Vec3& along, double shortest) {
  Span span{HUGE_VAL, -HUGE_VAL};
  const auto add = [&](const Vec3& p) {
    const double s = along.dot(p - origin);
    span = {std::min(span.low, s), std::max(span.high, s)};
  };
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    if (h[i] == 0.0) add(t.corners[i]);
    if (h[i] * h[j] < 0.0) add(t.corners[i] + h[i] / (h[i] - h[j]) * (t.corners[j] - t.corners[i]));
  }
  if (span.high - span.low <= shortest) return std::nullopt;
  return span;
}

int shared_within(const Triangle& a, const Triangle& b, double same) {
  int shared = 0;
  for (const Vec3& p : a.corners)
    for (const Vec3& q : b.corners)
      if ((p - q).cwiseAbs().maxCoeff() <= same) ++shared;
  return shared;
}

std::vector<Vec3> below_crossing(const Triangle& a, const Triangle& b, double aside,
                                 double in_plane) {
  const std::array<double, 3> ha = heights(a, b, in_plane), hb = heights(b, a, in_plane);
  if (!goes_below(ha) || !goes_below(hb)) return {};
  const Vec3 along = a.normal.cross(b.normal).normalized();
  const auto span_a = span_in_plane(a, ha, a.corners[0], along, in_plane);
  const auto span_b = span_in_plane(b, hb, a.corners[0], along, in_plane);
  if (!span_a || !span_b) return {};
  const Span both{std::max(span_a->low, span_b->low), std::min(span_a->high, span_b->high)};
  if (both.high - both.low <= in_plane) return {};
  // The point of the line nearest to a's corner: on both planes, and at a distance of 0 along.
  const double cosine = a.normal.dot(b.normal);
  const double height = b.normal.dot(a.corners[0] - b.corners[0]);
  const Vec3 foot = a.corners[0] -
                    height / (1.0 - cosine * cosine) * (b.normal - cosine * a.normal);
  const Vec3 down = -aside / (1.0 + cosine) * (a.normal + b.normal);
  return mapped(kPlaces, [&](double place) -> Vec3 {
    return foot + (both.low + place * (both.high - both.low)) * along + down;
  });
}

/// What a convex ring has on the left of the line from p to q, seen from the tip of `up`.
std::vector<Vec3> left_of(const std::vector<Vec3>& ring, const Vec3& p, const Vec3& q,
                          const Vec3& up) {
  const Vec3 inwards = up.cross(q - p);
  std::vector<Vec3> left;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec3& from = ring[i];
    const Vec3& to = ring[(i + 1) % ring.size()];
    const double at_from = inwards.dot(from - p), at_to = inwards.dot(to - p);
    if (at_from >= 0.0) left.push_back(from);
    if (at_from * at_to < 0.0) left.push_back(from + at_from / (at_from - at_to) * (to - from));
  }
  return left;
}

/// Below the lower of two triangles that look the same way, in the middle of what they share.
std::vector<Vec3> below_cover(const Triangle& a, const Triangle& b, double aside, double reach) {
  std::vector<Vec3> ring(a.corners.begin(), a.corners.end());
  for (int i = 0; i < 3 && !ring.empty(); ++i)
    ring = left_of(ring, b.corners[i], b.corners[(i + 1) % 3], b.normal);
  if (ring.size() < 3) return {};
  Vec3 middle = Vec3::Zero(), twice_area = Vec3::Zero();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    middle += ring[i] / static_cast<double>(ring.size());
    twice_area += (ring[i] - ring[0]).cross(ring[(i + 1) % ring.size()] - ring[0]);
  }
  double around = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i)
    around += (ring[(i + 1) % ring.size()] - ring[i]).norm();
  if (twice_area.norm() <= kNarrow * reach * around) return {};  // as good as a line
  const double height = b.normal.dot(middle - b.corners[0]);
  if (std::abs(height) > reach) return {};
  return {middle - (std::max(height, 0.0) + aside) * b.normal};
}

}  // namespace

int shared_corners(const Triangle& a, const Triangle& b) {
  return shared_within(a, b, kInPlane * extent(a, b));
}

std::vector<Vec3> points_below_both(const Triangle& a, const Triangle& b, double aside,
                                    double reach) {
  const double cosine = a.normal.dot(b.normal);
  const double sine = a.normal.cross(b.normal).norm();
  const double in_plane = kInPlane * extent(a, b);
  if (a.normal.isZero() || b.normal.isZero()) return {};
  if (cosine < 0.0 && sine < kFlatWedge) return {};
  if (shared_within(a, b, in_plane) >= 2) return {};
  std::vector<Vec3> points;
  if (cosine > kSameWay) points = below_cover(a, b, aside, reach);
  if (sine >= kFlatWedge) {
    const std::vector<Vec3> crossing = below_crossing(a, b, aside, in_plane);
    points.insert(points.end(), crossing.begin(), crossing.end());
  }
  return points;
}

}  // namespace planish::collision_detail
