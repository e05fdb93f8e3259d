#include "measure.hpp"

#include "support/sheets.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace planish::test {
namespace {

using std::numbers::pi;

TEST(Measure, TakesOpeningsFromTheAreaAndCutsEachSlitOnce) {
  FlatPattern pattern;
  pattern.outer.loop = rectangle(100, 60);
  pattern.openings.push_back({circular_opening({30, 30}, 5), {}});
  pattern.openings.push_back({obround_opening({70, 30}, 12, 4, Angle::degrees(30)), {}});
  pattern.slits = {Segment{{10, 10}, {20, 10}}, Segment{{10, 50}, {13, 54}}};
  sheet_detail::measure(pattern);
  EXPECT_NEAR(pattern.area, 6000 - 25 * pi - (16 * pi + 12 * 8), 1e-9);
  EXPECT_NEAR(pattern.perimeter, 320 + 10 * pi + (8 * pi + 24) + 10 + 5, 1e-9);
}

}  // namespace
}  // namespace planish::test
