#include "skin_outlines.hpp"

#include "recognised.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace planish::brep::test {
namespace {

using std::numbers::pi;

BorderLoop circle(double radius) { return {{.curve = Arc{{0, 0}, radius, 0.0, -2 * pi}}}; }

TEST(IsWider, ByMoreThanTheNoiseOfDrilledHoles) {
  EXPECT_TRUE(is_wider(circle(5.002), circle(5)));
  EXPECT_FALSE(is_wider(circle(5.0005), circle(5)));
  EXPECT_FALSE(is_wider(circle(5), circle(5.002)));
}

TEST(SeenThrough, RunsAsTheNearLoopDoes) {
  const Recognised seen = recognised(plate(2, {100, 60}, {{{30, 30}, {{6, 2}, {4, 0}}}}), 2, kTop);
  const auto& plane = std::get<Frame>(seen.model.faces[kTop].surface);
  for (const RimPart& part : seen.rim.parts)
    for (const LoopRef& ref : loops_there(seen.view(), part)) {
      const BorderLoop loop = seen_through(seen.view(), ref, plane);
      double area = 0.0;
      for (const Border& border : loop) {
        area += green_area(border.curve);
        EXPECT_EQ(border.edge_depth, 2.0);
      }
      EXPECT_NEAR(area, seen.outlines[ref.face].outer == ref.loop ? 6000 : -16 * pi, 1e-9);
    }
}

}  // namespace
}  // namespace planish::brep::test
