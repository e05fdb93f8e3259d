// Convex polygons: cutting an outline into few of them (triangles joined across shared sides, long
// ones first, while they stay convex), hulls by monotone chains, and distances by separating axes,
// which for polygons are normals of their sides.
#include "convex.hpp"

#include <planish/base/id_vector.hpp>
#include <planish/base/tolerance.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace planish::brake_detail {
namespace {

bool turns_left(const Vec2& a, const Vec2& b, const Vec2& c) {
  const Vec2 ab = b - a, bc = c - b;
  return cross(ab, bc) >= -tolerance::kComputed * ab.norm() * bc.norm();
}

bool is_convex(const Convex& polygon) {
  const size_t n = polygon.size();
  double turned = 0.0;
  for (size_t i = 0; i < n; ++i) {
    const Vec2 &a = polygon[i], &b = polygon[(i + 1) % n], &c = polygon[(i + 2) % n];
    if (!turns_left(a, b, c)) return false;
    turned += std::atan2(cross(b - a, c - b), (b - a).dot(c - b));
  }
  constexpr double kOnce = 6.3;  // above 2π, below two turns
  return turned < kOnce;
}

/// Polygons by the numbers of their corners, joined across shared sides while they stay convex.
class Joining {
 public:
  explicit Joining(const std::vector<std::array<Vec2, 3>>& triangles) {
    for (const auto& triangle : triangles)
      add({number(triangle[0]), number(triangle[1]), number(triangle[2])});
  }

  std::vector<Convex> joined() && {
    std::vector<std::pair<int, int>> sides;
    for (const auto& [side, polygon] : at_side_)
      if (side.first < side.second) sides.push_back(side);
    std::ranges::sort(sides, [&](const auto& a, const auto& b) {
      return length(a) > length(b);  // long ones first: what is left over is not thin
    });
    for (const auto& side : sides)
      join(side);
    std::vector<Convex> result;
    for (const std::vector<int>& polygon : polygons_)
      if (!polygon.empty()) result.push_back(corners(polygon));
    return result;
  }

 private:
  double length(const std::pair<int, int>& side) const {
    return (points_[side.first] - points_[side.second]).squaredNorm();
  }
  int number(const Vec2& p) {
    const auto [at, added] = numbers_.try_emplace({p.x(), p.y()}, std::ssize(points_));
    if (added) points_.push_back(p);
    return at->second;
  }
  Convex corners(const std::vector<int>& polygon) const {
    return mapped(polygon, [&](int i) { return points_[i]; });
  }
  void add(std::vector<int> polygon) {
    if (ring_area(corners(polygon)) < 0.0) std::ranges::reverse(polygon);
    const int id = static_cast<int>(polygons_.size());
    for (size_t i = 0; i < polygon.size(); ++i)
      at_side_[{polygon[i], polygon[(i + 1) % polygon.size()]}] = id;
    polygons_.push_back(std::move(polygon));
  }
  /// The corners from the end of a side round to its start.
  static std::vector<int> behind(std::vector<int> polygon, int start, int end) {
    const auto at = std::ranges::find(polygon, end);
    std::rotate(polygon.begin(), at, polygon.end());
    return polygon.back() == start ? polygon : std::vector<int>();
  }
  void join(const std::pair<int, int>& side) {
    const auto left = at_side_.find(side), right = at_side_.find({side.second, side.first});
    if (left == at_side_.end() || right == at_side_.end()) return;
    const int a = left->second, b = right->second;
    if (a == b) return;
    std::vector<int> ring = behind(polygons_[a], side.first, side.second);
    const std::vector<int> rest = behind(polygons_[b], side.second, side.first);
    if (ring.empty() || rest.empty()) return;
    ring.insert(ring.end(), rest.begin() + 1, rest.end() - 1);
    if (!is_convex(corners(ring))) return;
    polygons_[b].clear();
    for (size_t i = 0; i < ring.size(); ++i)
      at_side_[{ring[i], ring[(i + 1) % ring.size()]}] = a;
    at_side_.erase(left);
    at_side_.erase(right);
    polygons_[a] = std::move(ring);
  }

  std::vector<Vec2> points_;
  std::map<std::pair<double, double>, int> numbers_;
  std::vector<std::vector<int>> polygons_;
  std::map<std::pair<int, int>, int> at_side_;  // by start and end
};

/// Largest distance between the polygons across a side of `a`.
double apart_across(const Convex& a, const Convex& b) {
  double most = -std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < a.size(); ++i) {
    const Vec2 side = a[(i + 1) % a.size()] - a[i];
    const double length = side.norm();
    if (length <= tolerance::kTiniest) continue;
    const Vec2 outward(side.y() / length, -side.x() / length);
    double least = std::numeric_limits<double>::infinity();
    for (const Vec2& p : b)
      least = std::min(least, outward.dot(p - a[i]));
    most = std::max(most, least);
  }
  return most;
}

double corners_to_sides(const Convex& a, const Convex& b) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vec2& p : a)
    least = std::min(least, distance_to_ring(b, p));
  return least;
}

}  // namespace

std::vector<Convex> convex_pieces(const Polygon& polygon, double inset) {
  if (inset == 0.0 && polygon.holes.empty()) {
    Convex ring = polygon.outer;
    if (ring_area(ring) < 0.0) std::ranges::reverse(ring);
    if (ring.size() >= 3 && is_convex(ring)) return {ring};
  }
  return Joining(inset_triangles(polygon, inset)).joined();
}

bool is_thin(const Convex& polygon, double width) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [a, b] : sides_of(polygon)) {
    const Vec2 side = b - a;
    if (side.norm() <= tolerance::kTiniest) continue;
    double most = 0.0;
    for (const Vec2& p : polygon)
      most = std::max(most, std::abs(cross(side.normalized(), p - a)));
    least = std::min(least, most);
  }
  return polygon.size() < 3 || least < width;
}

double separation(const Convex& a, const Convex& b) {
  return std::max(apart_across(a, b), apart_across(b, a));
}

double distance(const Convex& a, const Convex& b) {
  if (separation(a, b) <= 0.0) return 0.0;
  return std::min(corners_to_sides(a, b), corners_to_sides(b, a));
}

Convex moved(Convex polygon, const Vec2& by) {
  for (Vec2& p : polygon)
    p += by;
  return polygon;
}

Convex mirrored(const Convex& polygon) {
  Convex result(polygon.rbegin(), polygon.rend());
  for (Vec2& p : result)
    p.x() = -p.x();
  return result;
}

}  // namespace planish::brake_detail
