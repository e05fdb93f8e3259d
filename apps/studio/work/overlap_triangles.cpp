#include "overlap_triangles.hpp"

#include <planish/geometry/region.hpp>
#include <planish/inspect/findings.hpp>

#include <algorithm>

namespace planish::studio {
namespace {

double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b - a).x() * (c - b).y() - (b - a).y() * (c - b).x();
}

bool in_triangle(const Vec2& p, const Vec2& a, const Vec2& b, const Vec2& c) {
  return turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0;
}

bool is_ear(const std::vector<Vec2>& ring, std::size_t i) {
  const std::size_t n = ring.size();
  const Vec2 &a = ring[(i + n - 1) % n], &b = ring[i], &c = ring[(i + 1) % n];
  if (turn(a, b, c) <= 0.0) return false;
  return std::ranges::none_of(
      ring, [&](const Vec2& p) { return p != a && p != b && p != c && in_triangle(p, a, b, c); });
}

}  // namespace

std::vector<Vec2> ring_triangles(std::vector<Vec2> ring) {
  if (ring_area(ring) < 0.0) std::ranges::reverse(ring);
  std::vector<Vec2> triangles;
  while (ring.size() >= 3) {
    std::size_t ear = 0;
    while (ear < ring.size() && !is_ear(ring, ear))
      ++ear;
    // Because of rounding a sliver may have no ear: drop a corner anyway.
    const std::size_t n = ring.size(), at = ear % n;
    if (ear < n)
      for (const std::size_t j : {at + n - 1, at, at + 1})
        triangles.push_back(ring[j % n]);
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(at));
  }
  return triangles;
}

std::vector<Vec2> overlap_triangles(const Layout& layout, double thickness) {
  constexpr double kChord = 0.05;  // mm
  const auto polygons = mapped(
      layout.images.ids(), [&](FaceId face) { return polygon_of(layout.region(face), kChord); });
  const double clearance = std::max(kContactShare * thickness, kChord);
  std::vector<Vec2> triangles;
  for (const Overlap& overlap : overlaps(polygons, clearance, clearance * clearance))
    for (const auto& ring : overlap.outline) {
      const auto part = ring_triangles(ring);
      triangles.insert(triangles.end(), part.begin(), part.end());
    }
  return triangles;
}

}  // namespace planish::studio
