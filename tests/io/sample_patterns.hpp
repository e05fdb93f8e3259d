#pragma once

#include <planish/io/flat_writers.hpp>

#include <numbers>
#include <vector>

namespace planish::sample {

inline constexpr double kPi = std::numbers::pi;

inline Loop polygon(const std::vector<Vec2>& corners) {
  Loop loop;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    loop.emplace_back(Segment{corners[i], corners[(i + 1) % corners.size()]});
  }
  return loop;
}

inline Loop rectangle(const Vec2& lo, const Vec2& hi) {
  return polygon({lo, {hi.x(), lo.y()}, hi, {lo.x(), hi.y()}});
}

inline Loop hole(const Vec2& center, double radius) {
  return {Arc{center, radius, 0.0, -2.0 * kPi}};
}

/// Slot with round ends, clockwise; `reach` from the middle to the centres of the ends.
inline Loop obround(const Vec2& c, double reach, double radius) {
  const Vec2 along(reach, 0.0);
  const Vec2 across(0.0, radius);
  return {Segment{c - along + across, c + along + across}, Arc{c + along, radius, kPi / 2, -kPi},
          Segment{c + along - across, c - along - across}, Arc{c - along, radius, -kPi / 2, -kPi}};
}

/// Closed cubic that starts and ends at `at`, with handles p and q: its area is 3/20 · p × q.
inline Loop petal(const Vec2& at, const Vec2& p, const Vec2& q) {
  return {CubicSpline{{at, at + p, at + q, at}}};
}

inline FlatBend bend(std::string id, BendDirection direction, const Segment& line, double width) {
  const Vec2 along = (line.b - line.a).normalized();
  const Vec2 half = 0.5 * width * Vec2(-along.y(), along.x());
  FlatBend bend;
  bend.id = std::move(id);
  bend.direction = direction;
  bend.angle = Angle::degrees(90.0);
  bend.inside_radius = 2.0;
  bend.lines = {line};
  bend.tangent_lines = {{line.a + half, line.b + half}, {line.a - half, line.b - half}};
  bend.length = (line.b - line.a).norm();
  return bend;
}

/// 200 × 100 with a hole, a slot, a bend up at x = 60 and one down at x = 150.
inline FlatPattern bracket() {
  FlatPattern pattern;
  pattern.thickness = 2.0;
  pattern.outer.loop = rectangle({0, 0}, {200, 100});
  pattern.openings.push_back({hole({20, 50}, 8.0), {}});
  pattern.openings.push_back({obround({100, 30}, 12.0, 5.0), {}});
  pattern.bends.push_back(bend("B1", BendDirection::up, {{60, 0}, {60, 100}}, 4.0));
  pattern.bends.push_back(bend("B2", BendDirection::down, {{150, 100}, {150, 0}}, 4.0));
  return pattern;
}
inline constexpr double kBracketArea = 200.0 * 100.0 - 64.0 * kPi - (24.0 * 10.0 + 25.0 * kPi);

/// The bracket with an opening bounded by a spline.
inline FlatPattern bracket_with_petal() {
  FlatPattern pattern = bracket();
  pattern.openings.push_back({petal({175, 20}, {-30, 60}, {40, 60}), {}});
  return pattern;
}
inline constexpr double kPetalArea = 3.0 / 20.0 * (30.0 * 60.0 + 60.0 * 40.0);

}  // namespace planish::sample
