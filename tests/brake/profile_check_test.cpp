#include "profile_check.hpp"

#include <planish/geometry/region.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace planish::test {
namespace {

using namespace brake_detail;

using std::numbers::pi;

ToolProfile regular(int corners, double radius) {
  ToolProfile profile;
  for (int i = 0; i < corners; ++i)
    profile.emplace_back(radius * std::cos(2 * pi * i / corners),
                         radius * std::sin(2 * pi * i / corners));
  return profile;
}

const ToolProfile kEll = {{0, 0}, {40, 0}, {40, 10}, {10, 10}, {10, 30}, {0, 30}};

TEST(ProfileCheck, KnowsAnglesWithinTheBody) {
  for (const int corners : {3, 4, 7})
    for (int i = 0; i < corners; ++i)
      EXPECT_NEAR(angle_within(regular(corners, 5.0), i), pi * (corners - 2) / corners, 1e-9);
  for (std::size_t i = 0; i < kEll.size(); ++i)
    EXPECT_NEAR(angle_within(kEll, i), i == 3 ? 1.5 * pi : 0.5 * pi, 1e-9);
}

TEST(ProfileCheck, FindsCornersAndPlacesOnTheOutline) {
  EXPECT_EQ(corner_at(kEll, {10, 10}), std::optional<std::size_t>(3));
  EXPECT_FALSE(corner_at(kEll, {10.1, 10}));
  EXPECT_TRUE(on_outline(kEll, {25, 10}));
  EXPECT_TRUE(on_outline(kEll, {0, 15}));  // the edge that closes the outline
  EXPECT_FALSE(on_outline(kEll, {5, 15}));
  EXPECT_FALSE(on_outline(kEll, {45, 0}));
  EXPECT_GT(corner_tolerance(kEll), 0.0);
  EXPECT_LT(corner_tolerance(kEll), 0.01);
}

/// A circle in a corner of the angle a takes r / tan(a/2) of both edges.
TEST(ProfileCheck, RoundsCornersAsFarAsTheirEdgesGo) {
  for (const int corners : {3, 4, 6}) {
    const ToolProfile profile = regular(corners, 10.0);
    const double edge = (profile[1] - profile[0]).norm();
    const double most = edge * std::tan(0.5 * pi * (corners - 2) / corners);
    EXPECT_FALSE(fault_of_rounding(profile, 1, most - 0.01));
    EXPECT_TRUE(fault_of_rounding(profile, 1, most + 0.01));
    // The first corner has the last one beside it.
    EXPECT_FALSE(fault_of_rounding(profile, 0, most - 0.01));
    EXPECT_TRUE(fault_of_rounding(profile, 0, most + 0.01));
  }
  // Edges of 40 and 10 at the second corner: the shorter one counts.
  EXPECT_FALSE(fault_of_rounding(kEll, 1, 9.9));
  EXPECT_TRUE(fault_of_rounding(kEll, 1, 10.1));
  EXPECT_FALSE(fault_of_rounding({{0, 0}, {5, 0}, {10, 0}, {10, 10}}, 1, 1e3));  // straight
}

TEST(ProfileCheck, PassesOutlinesOfBodies) {
  for (int corners = 3; corners < 9; ++corners)
    EXPECT_FALSE(fault_of(regular(corners, 20.0)));
  EXPECT_FALSE(fault_of(kEll));
}

/// Wherever the outline begins, the same is wrong with it.
TEST(ProfileCheck, FindsWhatIsNoBodyWhereverItBegins) {
  const std::vector<ToolProfile> wrong = {
      {{0, 0}, {10, 10}, {10, 0}, {0, 10}},                        // crosses itself
      {{0, 0}, {20, 0}, {20, 20}, {10, 0}, {0, 20}},               // touches an edge
      {{0, 0}, {20, 0}, {20, 10}, {30, 10}, {20, 10.0}, {0, 10}},  // a spike
      {{0, 0}, {10, 0}, {10, 0}, {10, 10}},                        // a corner twice
      {{0, 0}, {0, 10}, {10, 10}, {10, 0}},                        // clockwise
  };
  for (std::size_t which = 0; which < wrong.size(); ++which)
    for (std::size_t first = 0; first < wrong[which].size(); ++first) {
      ToolProfile profile = wrong[which];
      std::ranges::rotate(profile, profile.begin() + static_cast<std::ptrdiff_t>(first));
      EXPECT_TRUE(fault_of(profile)) << which << " from " << first;
    }
  EXPECT_TRUE(fault_of({{0, 0}, {10, 0}}));
  EXPECT_TRUE(fault_of({{0, 0}, {10, 0}, {NAN, 10}}));
  EXPECT_TRUE(fault_of({{0, 0}, {10, 0}, {0, 1e9}}));
}

TEST(ProfileCheck, TellsTheCornerAtFault) {
  EXPECT_EQ(fault_of({{0, 0}, {10, 0}, {10, 0}, {10, 10}})->where, "/2");
  EXPECT_EQ(fault_of({{0, 0}, {10, 0}, {10, 10}, {0, 0}})->where, "/3");
  EXPECT_EQ(fault_of({{0, 0}, {10, 0}, {INFINITY, 10}})->where, "/2");
  EXPECT_EQ(fault_of({{0, 0}, {0, 10}, {10, 0}})->where, "");
}

}  // namespace
}  // namespace planish::test
