#include "crossing.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace planish::test {
namespace {

using namespace slit_detail;

/// A flat strip of one quad, 100 long and 20 wide.
FoldedStrip strip_in(const Frame& frame) {
  FoldedStrip strip;
  strip.quads = {frame};
  for (const double along : {0.0, 100.0})
    strip.ridges.push_back({{Vec2(along, 0), Vec2(along, 20)},
                            {frame.point({along, 0}), frame.point({along, 20})},
                            {}});
  return strip;
}

FoldedStrip strip_at(const Vec3& origin) {
  Frame frame;
  frame.origin = origin;
  return strip_in(frame);
}

TEST(Crossing, OfStripsThatGoThroughEachOtherIsSeen) {
  Frame across = frame_from_axes({50, 10, -30}, Vec3::UnitX(), Vec3::UnitZ());
  EXPECT_TRUE(cross(strip_at({0, 0, 0}), strip_in(across)));
  EXPECT_TRUE(cross(strip_in(across), strip_at({0, 0, 0})));
  across.origin.x() = 150;
  EXPECT_FALSE(cross(strip_at({0, 0, 0}), strip_in(across)));
}

TEST(Crossing, DoesNotSeeTouching) {
  EXPECT_FALSE(cross(strip_at({0, 0, 0}), strip_at({0, 20, 0})));
  EXPECT_FALSE(cross(strip_at({0, 0, 0}), strip_at({0, 0, 0})));
  // An upright strip that stands on the other.
  const Frame upright = frame_from_axes({50, 0, 0}, Vec3::UnitX(), Vec3::UnitZ());
  EXPECT_FALSE(cross(strip_at({0, 0, 0}), strip_in(upright)));
}

TEST(PlanesBeside, KeepAStripBeyondTheBorderOfItsNeighbour) {
  // The strip lies 5 over the right border of its left neighbour, at y = 20.
  const auto planes = planes_beside(strip_at({0, 15, 0}), strip_at({0, 0, 0}), StripEdge::left);
  ASSERT_EQ(planes.size(), 1u);  // ridge 0 stays on the panel
  EXPECT_EQ(planes[0].ridge, 1);
  EXPECT_EQ(planes[0].side, 0);
  EXPECT_NEAR((planes[0].normal - Vec3::UnitY()).norm(), 0.0, 1e-15);
  EXPECT_NEAR(planes[0].offset, 20.0, 1e-12);
  // Seen from the other one, whose right side must stay left of y = 15.
  const auto others = planes_beside(strip_at({0, 0, 0}), strip_at({0, 15, 0}), StripEdge::right);
  ASSERT_EQ(others.size(), 1u);
  EXPECT_EQ(others[0].side, 1);
  EXPECT_NEAR((others[0].normal + Vec3::UnitY()).norm(), 0.0, 1e-15);
  EXPECT_NEAR(others[0].offset, -15.0, 1e-12);
}

TEST(PlanesBeside, AreThoseOfTheNearestQuad) {
  // The neighbour's second quad, from 60 on, is twisted about its border.
  FoldedStrip neighbour = strip_at({0, 0, 0});
  neighbour.ridges.insert(neighbour.ridges.begin() + 1, neighbour.ridges.front());
  for (Vec3& end : neighbour.ridges[1].folded)
    end.x() = 60;
  const Vec3 across(0.0, std::cos(0.1), std::sin(0.1));
  neighbour.quads.push_back(
      frame_from_axes({60, 0, 0}, Vec3::UnitX().cross(across), Vec3::UnitX()));
  const auto planes = planes_beside(strip_at({0, 15, 0}), neighbour, StripEdge::left);
  ASSERT_EQ(planes.size(), 1u);
  EXPECT_NEAR((planes[0].normal - across).norm(), 0.0, 1e-12);
  EXPECT_NEAR(planes[0].offset, across.dot(Vec3(100, 20, 0)), 1e-12);
}

TEST(PlanesBeside, LeaveFreeWhatIsBesideOrFarAbove) {
  EXPECT_TRUE(planes_beside(strip_at({0, 20, 0}), strip_at({0, 0, 0}), StripEdge::left).empty());
  EXPECT_TRUE(planes_beside(strip_at({0, 15, 21}), strip_at({0, 0, 0}), StripEdge::left).empty());
  EXPECT_FALSE(planes_beside(strip_at({0, 15, 19}), strip_at({0, 0, 0}), StripEdge::left).empty());
}

TEST(Mirror, IsPassedByAsMuchAsCornersLieBehindIt) {
  EXPECT_DOUBLE_EQ(depth_behind_mirror(strip_at({-70, 0, 0}), 1.0), 70.0);
  EXPECT_DOUBLE_EQ(depth_behind_mirror(strip_at({-70, 0, 0}), -1.0), 30.0);
  EXPECT_DOUBLE_EQ(depth_behind_mirror(strip_at({1, 0, 0}), 1.0), 0.0);
}

TEST(Mirror, BoundsEveryRidgeBetweenTheEnds) {
  const auto planes = planes_before_mirror(4, -1.0);
  ASSERT_EQ(planes.size(), 6u);
  for (const HalfSpace& plane : planes) {
    EXPECT_TRUE(plane.ridge >= 1 && plane.ridge <= 3);
    EXPECT_EQ(plane.normal, Vec3(-1, 0, 0));
    EXPECT_EQ(plane.offset, 0.0);
  }
}

}  // namespace
}  // namespace planish::test
