#include <planish/geometry/plane.hpp>

#include <limits>

namespace planish {

bool properly_cross(const Segment& a, const Segment& b) {
  const auto parts = [](const Segment& line, const Segment& other) {
    return cross(line.b - line.a, other.a - line.a) * cross(line.b - line.a, other.b - line.a) <
           0.0;
  };
  return parts(a, b) && parts(b, a);
}

double distance(const Segment& a, const Segment& b) {
  if (properly_cross(a, b)) return 0.0;
  return std::min({distance(a.a, b), distance(a.b, b), distance(b.a, a), distance(b.b, a)});
}

Box2 box_of(const std::vector<Vec2>& points) {
  Box2 box;
  for (const Vec2& p : points)
    box.add(p);
  return box;
}

double distance_to_ring(const std::vector<Vec2>& ring, const Vec2& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const Segment& side : sides_of(ring))
    least = std::min(least, distance(p, side));
  return least;
}

std::vector<Vec2> clipped(const std::vector<Vec2>& polygon, const Vec2& normal, double offset) {
  std::vector<Vec2> result;
  for (const auto& [a, b] : sides_of(polygon)) {
    const double da = normal.dot(a) - offset, db = normal.dot(b) - offset;
    if (da <= 0.0) result.push_back(a);
    if ((da < 0.0 && db > 0.0) || (da > 0.0 && db < 0.0))
      result.push_back(a + da / (da - db) * (b - a));
  }
  return result.size() < 3 ? std::vector<Vec2>() : result;
}

std::vector<Vec2> hull_of(std::vector<Vec2> points) {
  const auto before = [](const Vec2& a, const Vec2& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  };
  std::ranges::sort(points, before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Vec2> hull;
  const auto add_chain = [&hull](auto first, auto last) {
    const std::size_t base = hull.size();
    for (auto it = first; it != last; ++it) {
      while (hull.size() >= base + 2 &&
             cross(hull.back() - hull[hull.size() - 2], *it - hull.back()) <= 0.0) {
        hull.pop_back();
      }
      hull.push_back(*it);
    }
    hull.pop_back();  // begins the other chain
  };
  add_chain(points.begin(), points.end());
  add_chain(points.rbegin(), points.rend());
  return hull;
}

}  // namespace planish
