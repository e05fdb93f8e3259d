#include "bend_dimensions.hpp"

#include "support/sheets.hpp"

#include <planish/sheet/moved_pattern.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

namespace planish::drawing {
namespace {

using namespace planish::test;
using testing::Contains;
using testing::DoubleNear;
using testing::ElementsAre;
using testing::IsEmpty;

/// A plate of 100 × 60 that begins at (-10, 5), with bends along the lines.
FlatPattern plate_with(const std::vector<Segment>& lines) {
  FlatPattern flat = *flatten(strip({Straight{100.0}}, 60.0, 1.0));
  const Box2 box = bounds(flat.outer.loop);
  const Isometry2 shift(Eigen::Translation2d(Vec2(-10.0, 5.0) - box.lo));
  flat = transformed(flat, shift);
  for (const Segment& line : lines) {
    FlatBend bend;
    bend.id = "B" + std::to_string(flat.bends.size() + 1);
    bend.lines = {line};
    flat.bends.push_back(bend);
  }
  return flat;
}

TEST(BendDistances, AreFromTheEdgesOfThePatternEachOnce) {
  const auto found = bend_distances(plate_with({{{20, 5}, {20, 65}},
                                                {{15, 65}, {15, 40}},
                                                {{20, 10}, {20, 8}},
                                                {{-10, 45}, {90, 45}},
                                                {{0, 10}, {10, 20}}}));
  EXPECT_THAT(found.from_left, ElementsAre(DoubleNear(25.0, 1e-9), DoubleNear(30.0, 1e-9)));
  EXPECT_THAT(found.from_below, ElementsAre(DoubleNear(40.0, 1e-9))) << "slanted ones have none";
}

TEST(BendDistances, StandBesideThePattern) {
  const FlatPattern flat = plate_with({{{20, 5}, {20, 65}}, {{-10, 45.25}, {90, 45.25}}});
  Page page(210.0, 297.0);
  const Fit fit(bounds(flat.outer.loop), {{30.0, 30.0}, {100.0, 60.0}}, 20.0);
  EXPECT_EQ(dimension_bends(page, flat, fit, schema::Units(LengthUnit::mm)), 0u);
  ASSERT_EQ(page.texts().size(), 2u);
  EXPECT_EQ(page.texts()[0].text, "30");
  EXPECT_GT(page.texts()[0].at.y(), 90.0) << "below the pattern";
  EXPECT_NEAR(page.texts()[0].at.x(), 60.0, 1.5);
  EXPECT_EQ(page.texts()[1].text, "40.25");
  EXPECT_GT(page.texts()[1].at.x(), 130.0) << "on its right";
  EXPECT_NEAR(page.texts()[1].at.y(), 90.0 - 40.25, 1.5);
}

TEST(BendDistances, AreCountedWhereThereIsNoRoom) {
  std::vector<Segment> lines;
  for (int i = 1; i < 99; ++i)
    lines.push_back({{-10.0 + i, 5.0}, {-10.0 + i, 65.0}});
  const FlatPattern flat = plate_with(lines);
  Page page(210.0, 297.0);
  const Fit fit(bounds(flat.outer.loop), {{30.0, 30.0}, {100.0, 60.0}}, 20.0);
  EXPECT_EQ(dimension_bends(page, flat, fit, schema::Units(LengthUnit::mm)), 98u);
  EXPECT_THAT(page.texts(), IsEmpty());
}

TEST(Spread, LeavesPlacesThatAreApart) {
  EXPECT_THAT(spread({1.0, 5.0, 9.0}, 3.0, 0.0, 10.0), ElementsAre(1.0, 5.0, 9.0));
  EXPECT_THAT(spread({4.0, 4.5, 5.0}, 2.0, 0.0, 20.0), ElementsAre(4.0, 6.0, 8.0));
  EXPECT_THAT(spread({9.0, 9.5}, 2.0, 0.0, 10.0), ElementsAre(8.0, 10.0));
  EXPECT_THAT(spread({1.0, 2.0, 3.0}, 2.0, 0.0, 3.0), IsEmpty());
}

RC_GTEST_PROP(Spread, KeepsTheGapWithinTheLimits, (std::vector<int> places)) {
  std::ranges::sort(places);
  std::vector<double> wanted;
  for (const int place : places)
    wanted.push_back(std::abs(std::fmod(place, 1000.0)));
  std::ranges::sort(wanted);
  const auto found = spread(wanted, 2.0, 0.0, 1000.0);
  RC_PRE(!found.empty());
  RC_ASSERT(found.size() == wanted.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    RC_ASSERT(found[i] > -1e-9 && found[i] < 1000.0 + 1e-9);
    RC_ASSERT(i == 0 || found[i] - found[i - 1] > 2.0 - 1e-9);
  }
}

}  // namespace
}  // namespace planish::drawing
