#include "changed_work.hpp"

#include "brake/stroke_room.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace planish::test {
namespace {

using namespace brake_detail;

/// Two legs of the same length on a web of 60.
Sheet channel() {
  const Turn bent{Angle::degrees(90), 2.0, BendDirection::up};
  return strip({Straight{40}, bent, Straight{60}, bent, Straight{40}}, 80, 1.5);
}

double area_of(const Body& body) {
  double area = 0.0;
  for (const Convex& piece : body.pieces)
    area += ring_area(piece);
  return area;
}

/// A strip 80 wide: what is taken out of an end or of the web is a rectangle, and the line beyond
/// comes as much nearer.
TEST(ChangedWork, TakesAStripOutOfAFlange) {
  Room room(channel(), plain_tools());
  const Workpiece& work = room.work();
  const int first = room.line_of(1), second = room.line_of(2);
  const auto shared = [&](int body) {
    return std::ranges::count(work.lines[first].bodies, body) +
           std::ranges::count(work.lines[second].bodies, body);
  };
  for (const int body : work.lines[first].bodies) {
    EXPECT_GT(most_shorter(work, body, first), 30.0);
    const auto made = shortened(work, body, first, 7.0);
    EXPECT_NEAR(area_of(made.bodies[body]), area_of(work.bodies[body]) - 7.0 * 80.0, 1e-6);
    const auto between = [&](const Workpiece& of) {
      return std::abs(
          of.lines[first].across().dot(of.lines[second].origin - of.lines[first].origin));
    };
    const bool is_web = shared(body) == 2;
    EXPECT_NEAR(between(made), between(work) - (is_web ? 7.0 : 0.0), 1e-9);
    const int last = *std::ranges::find_if(work.lines[second].bodies,
                                           [&](int other) { return shared(other) == 1; });
    EXPECT_NEAR(area_of(made.bodies[last]), area_of(work.bodies[last]), 1e-9);
  }
}

TEST(ChangedWork, SplitsInTwo) {
  Room room(channel(), plain_tools());
  const auto& work = room.work();
  const auto halves = split_at(work, room.line_of(1));
  EXPECT_EQ(halves[0].bodies.size() + halves[1].bodies.size(), 3u);
  EXPECT_EQ(halves[0].lines.size() + halves[1].lines.size(), 1u);
  double area = 0.0, whole = 0.0;
  for (const auto& half : halves)
    for (const auto& body : half.bodies)
      area += area_of(body);
  for (const auto& body : work.bodies)
    whole += area_of(body);
  EXPECT_NEAR(area, whole, 1e-9);
}

}  // namespace
}  // namespace planish::test
