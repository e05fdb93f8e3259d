#include "meetings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace planish::collision_detail {
namespace {

Triangle triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
  return triangle_of(Mesh{{a, b, c}, {{0, 1, 2}}}, 0);
}

/// In z = 0, looking up.
Triangle floor_triangle() { return triangle({-10, -10, 0}, {10, -10, 0}, {0, 10, 0}); }

/// Every point is `aside` below both planes, at least.
void expect_below(const std::vector<Vec3>& points, const Triangle& a, const Triangle& b,
                  double aside) {
  for (const Vec3& p : points)
    for (const Triangle* t : {&a, &b})
      EXPECT_NEAR(t->normal.dot(p - t->corners[0]), -aside, 1e-9);
}

TEST(PointsBelowBoth, LieAsideOfTheSegmentInWhichTrianglesCross) {
  const Triangle a = floor_triangle();
  for (const double lean : {0.0, 0.5, -0.7}) {
    const Triangle b = triangle({lean, -3, -5}, {lean, 3, -5}, {-lean, 0, 5});
    const auto points = points_below_both(a, b, 0.02, 0.1);
    ASSERT_EQ(points.size(), 3u);
    expect_below(points, a, b, 0.02);
    // b is 3 wide, from −1.5 to 1.5, where it passes a's plane; places at .5, .15 and .85 of that.
    std::vector<double> along;
    for (const Vec3& p : points)
      along.push_back(std::abs(p.y()));
    std::ranges::sort(along);
    EXPECT_NEAR(along[0], 0.0, 1e-9);
    EXPECT_NEAR(along[1], 1.05, 1e-9);
    EXPECT_NEAR(along[2], 1.05, 1e-9);
  }
}

TEST(PointsBelowBoth, AreOnTheSegmentThatBothHave) {
  // a's part of the line runs from −5 to 5 along x at y = 0, b's from 3 to 9.
  const Triangle a = floor_triangle();
  const Triangle b = triangle({3, 0, -4}, {9, 0, 4}, {3, 0, 4});
  const auto points = points_below_both(a, b, 0.01, 0.1);
  ASSERT_EQ(points.size(), 3u);
  for (const Vec3& p : points) {
    EXPECT_GT(p.x(), 3.0);
    EXPECT_LT(p.x(), 5.0);
  }
}

TEST(PointsBelowBoth, AreNoneWhereTrianglesDoNotMeet) {
  const Triangle a = floor_triangle();
  const auto none = [&](const Triangle& b) { return points_below_both(a, b, 0.01, 0.1).empty(); };
  EXPECT_TRUE(none(triangle({0, -3, 1}, {0, 3, 1}, {0, 0, 9}))) << "above";
  EXPECT_TRUE(none(triangle({0, -3, 0}, {0, 3, 0}, {0, 0, 9}))) << "stands on it";
  EXPECT_TRUE(none(triangle({20, -3, -5}, {20, 3, -5}, {20, 0, 5}))) << "beside";
  EXPECT_TRUE(none(triangle({-10, -10, 0}, {10, -10, 0}, {0, 0, -5}))) << "a neighbour";
  EXPECT_TRUE(none(triangle({0, 10, 0}, {10, -10, 0}, {-10, -10, 0}))) << "its back";
  EXPECT_TRUE(none(triangle({1, 1, 0}, {2, 2, 0}, {3, 3, 0}))) << "no area";
}

TEST(PointsBelowBoth, LieBelowTheLowerOfTwoThatCoverEachOther) {
  const Triangle a = floor_triangle();
  for (const double height : {0.05, -0.05}) {
    const Triangle b = triangle({-4, -4, height}, {4, -4, height}, {0, 4, height});
    const auto points = points_below_both(a, b, 0.02, 0.1);
    ASSERT_EQ(points.size(), 1u);
    EXPECT_NEAR(points[0].z(), std::min(height, 0.0) - 0.02, 1e-9);
    EXPECT_NEAR(points[0].x(), 0.0, 1e-9);
    EXPECT_NEAR(points[0].y(), -4.0 / 3, 1e-9) << "in the middle of what they share";
  }
  const auto at = [&](double height) {
    return points_below_both(a, triangle({-4, -4, height}, {4, -4, height}, {0, 4, height}), 0.02,
                             0.1);
  };
  EXPECT_TRUE(at(0.11).empty());
  EXPECT_TRUE(at(-0.11).empty());
  // A strip of 0.04 is narrower than half of the reach.
  const auto strip = [&](double width) {
    return points_below_both(a, triangle({-40, -10 + width, 0}, {0, -50, 0}, {40, -10 + width, 0}),
                             0.02, 0.1);
  };
  EXPECT_TRUE(strip(0.02).empty());
  EXPECT_EQ(strip(1.0).size(), 1u);
}

TEST(PointsBelowBoth, AreNoneBetweenSkinsThatTouch) {
  const Triangle a = floor_triangle();
  const Triangle facing = triangle({-4, -4, -0.0001}, {0, 4, 0.0001}, {4, -4, -0.0001});
  EXPECT_LT(facing.normal.z(), 0.0);
  EXPECT_TRUE(points_below_both(a, facing, 0.02, 0.1).empty());
}

TEST(SharedCorners, AreThoseAtTheSamePlaces) {
  const Triangle a = floor_triangle();
  EXPECT_EQ(shared_corners(a, a), 3);
  EXPECT_EQ(shared_corners(a, triangle({10, -10, 0}, {-10, -10, 0}, {0, -20, 3})), 2);
  EXPECT_EQ(shared_corners(a, triangle({10, -10, 1e-14}, {30, 0, 0}, {0, -20, 3})), 1);
  EXPECT_EQ(shared_corners(a, triangle({10, -10, 1e-3}, {30, 0, 0}, {0, -20, 3})), 0);
}

}  // namespace
}  // namespace planish::collision_detail
