#include "hulls.hpp"

#include <algorithm>
#include <utility>

namespace planish::nest_detail {
namespace {

bool turns_left(const IntPoint& a, const IntPoint& b, const IntPoint& c) {
  return (b.X - a.X) * (c.Y - a.Y) > (b.Y - a.Y) * (c.X - a.X);
}

}  // namespace

Path convex_hull(const Path& outline) {
  Path points = outline;
  std::ranges::sort(points, [](const IntPoint& a, const IntPoint& b) {
    return a.X != b.X ? a.X < b.X : a.Y < b.Y;
  });
  // The lower chain from left to right, then the upper one back (Andrew).
  Path hull;
  const auto add_chain = [&hull](const auto& from, const auto& to) {
    const std::size_t start = hull.size();
    for (auto p = from; p != to; ++p) {
      while (hull.size() >= start + 2 && !turns_left(hull[hull.size() - 2], hull.back(), *p))
        hull.pop_back();
      hull.push_back(*p);
    }
    hull.pop_back();
  };
  add_chain(points.begin(), points.end());
  add_chain(points.rbegin(), points.rend());
  return hull;
}

std::vector<Shape> with_hulls(std::vector<Shape> shapes) {
  constexpr double kWorthwhile = 0.1;  // of the outline's area
  std::vector<std::pair<double, std::size_t>> gains;
  std::vector<Path> hulls;
  for (std::size_t s = 0; s < shapes.size(); ++s) {
    const double area = ClipperLib::Area(shapes[s].outline);
    hulls.push_back(convex_hull(shapes[s].outline));
    const double gain = ClipperLib::Area(hulls.back()) - area;
    if (gain > kWorthwhile * area) gains.emplace_back(-gain * shapes[s].count, s);
  }
  std::ranges::sort(gains);
  gains.resize(std::min(gains.size(), kMostHollow));
  for (std::size_t s = 0; s < shapes.size(); ++s)
    if (std::ranges::none_of(gains, [s](const auto& gain) { return gain.second == s; }))
      shapes[s].outline = std::move(hulls[s]);
  return shapes;
}

}  // namespace planish::nest_detail
