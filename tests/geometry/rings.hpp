#pragma once

#include <planish/geometry/region.hpp>

#include <numbers>
#include <vector>

namespace planish::test {

using std::numbers::pi;

inline std::vector<Vec2> box(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

inline std::vector<Vec2> moved(std::vector<Vec2> points, const Isometry2& motion) {
  for (Vec2& p : points)
    p = motion * p;
  return points;
}

inline Loop outline(const std::vector<Vec2>& corners) {
  Loop loop;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    loop.push_back(Segment{corners[i], corners[(i + 1) % corners.size()]});
  }
  return loop;
}

}  // namespace planish::test
