#include <planish/geometry/plane.hpp>

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

}  // namespace planish
