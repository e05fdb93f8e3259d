#include "station.hpp"

#include <gtest/gtest.h>

namespace planish::test {
namespace {

using namespace brake_detail;

/// Rows of 100, punch and die alike, from 0.
StationTools hundred() {
  StationTools tools;
  tools.rows = {{{{0.0, {60.0, 40.0}}}, {{0.0, {60.0, 40.0}}}}};
  tools.tools = tools.reach = {0.0, 100.0};
  return tools;
}

Demand line_of(double length) {
  Demand demand;
  demand.pieces = {{0.0, length}};
  demand.part = {0.0, length};
  return demand;
}

/// A line no longer than the rows and their shortfalls lies in their middle.
TEST(StationTools, PressAShorterLineInTheirMiddle) {
  const StationTools tools = hundred();
  const auto at = tools.where(line_of(70.0), 2.0);
  ASSERT_TRUE(at);
  EXPECT_NEAR(*at, 15.0, 1e-9);
  EXPECT_TRUE(tools.where(line_of(104.0), 2.0));
  EXPECT_FALSE(tools.where(line_of(104.1), 2.0));
}

/// A wall beside the line pushes the rows away from it; two walls closer than the rows keep them
/// out.
TEST(StationTools, StandBesideWalls) {
  const StationTools tools = hundred();
  Demand demand = line_of(70.0);
  demand.walls[0] = {{70.0, 75.0}};
  const auto at = tools.where(demand, 2.0);
  ASSERT_TRUE(at);
  // The punch ends at 100, and the wall is at least there; the line begins at 0 or later.
  EXPECT_GE(*at + 70.0, 100.0 - kPenetration - kSameLength);
  EXPECT_GE(*at, -2.0);
  demand.walls[1] = {{-40.0, -35.0}};
  EXPECT_TRUE(tools.where(demand, 2.0)) << "105 between the walls";
  demand.walls[1] = {{-40.0, -29.0}};
  EXPECT_FALSE(tools.where(demand, 2.0)) << "99 between them";
}

/// Punch and die stay as they stand to each other.
TEST(StationTools, KeepPunchOverDie) {
  StationTools tools = hundred();
  tools.rows[1] = {{30.0, {60.0, 40.0}}};
  EXPECT_TRUE(tools.where(line_of(74.0), 2.0)) << "both are there for 70";
  EXPECT_FALSE(tools.where(line_of(75.0), 2.0));
}

TEST(StationTools, ReachAsFarAsTheirWorkpieces) {
  StationTools tools = hundred();
  Demand demand = line_of(70.0);
  demand.stroke = 3;
  demand.part = {-50.0, 90.0};
  tools.add(std::make_shared<Demand>(demand), 15.0);
  EXPECT_DOUBLE_EQ(tools.reach.lo, -35.0);
  EXPECT_DOUBLE_EQ(tools.reach.hi, 105.0);
  EXPECT_EQ(tools.first_stroke(), 3);
}

}  // namespace
}  // namespace planish::test
