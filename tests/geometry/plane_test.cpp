#include <planish/geometry/plane.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace planish {
namespace {

constexpr int kLooks = 400;  // along a segment

struct Dice {
  std::mt19937 random{7};
  double between(double lo, double hi) {
    return std::uniform_real_distribution<double>(lo, hi)(random);
  }
  Vec2 point() { return {between(-10, 10), between(-10, 10)}; }
  Segment segment() { return {point(), point()}; }
};

Vec2 at(const Segment& segment, int look) {
  return segment.a + (segment.b - segment.a) * look / kLooks;
}

TEST(Plane, CrossIsTheSineTimesBothLengths) {
  Dice dice;
  for (int run = 0; run < 100; ++run) {
    const double angle = dice.between(-3, 3), start = dice.between(-3, 3);
    const double a = dice.between(0.1, 5), b = dice.between(0.1, 5);
    const Vec2 first(a * std::cos(start), a * std::sin(start)),
        second(b * std::cos(start + angle), b * std::sin(start + angle));
    EXPECT_NEAR(cross(first, second), a * b * std::sin(angle), 1e-9);
  }
}

/// No point of the segment is nearer than the one that is named.
TEST(Plane, NearestPointIsNearerThanEveryOther) {
  Dice dice;
  for (int run = 0; run < 200; ++run) {
    const Segment segment = dice.segment();
    const Vec2 p = dice.point();
    const double share = nearest_share(segment, p), told = distance(p, segment);
    EXPECT_GE(share, 0.0);
    EXPECT_LE(share, 1.0);
    EXPECT_NEAR((nearest_on(segment, p) - p).norm(), told, 1e-12);
    EXPECT_LT((nearest_on(segment, p) - segment.a - share * (segment.b - segment.a)).norm(), 1e-12);
    double least = 1e9;
    for (int look = 0; look <= kLooks; ++look)
      least = std::min(least, (at(segment, look) - p).norm());
    EXPECT_LE(told, least + 1e-12);
    EXPECT_GT(told, least - (segment.b - segment.a).norm() / kLooks);
  }
}

TEST(Plane, ASegmentWithoutLengthIsItsPoint) {
  const Segment point{{1, 2}, {1, 2}};
  EXPECT_EQ(nearest_share(point, {4, 6}), 0.0);
  EXPECT_EQ(distance(Vec2(4, 6), point), 5.0);
}

/// Of two segments by many places of both, and 0 exactly where they cross.
TEST(Plane, DistanceOfSegmentsIsThatOfTheirNearestPoints) {
  Dice dice;
  int crossed = 0;
  for (int run = 0; run < 60; ++run) {
    const Segment a = dice.segment(), b = dice.segment();
    double least = 1e9;
    for (int i = 0; i <= kLooks; ++i)
      least = std::min(least, distance(at(a, i), b));
    const double step = (a.b - a.a).norm() / kLooks;
    EXPECT_LE(distance(a, b), least + 1e-12);
    EXPECT_GT(distance(a, b), least - step);
    EXPECT_EQ(distance(a, b), distance(b, a));
    EXPECT_EQ(properly_cross(a, b), distance(a, b) == 0.0);
    crossed += properly_cross(a, b) ? 1 : 0;
  }
  EXPECT_GT(crossed, 5);
  EXPECT_LT(crossed, 55);
}

TEST(Plane, SegmentsThatTouchDoNotCross) {
  const Segment base{{0, 0}, {4, 0}};
  EXPECT_FALSE(properly_cross(base, {{2, 0}, {2, 3}}));
  EXPECT_FALSE(properly_cross(base, {{4, 0}, {6, 1}}));
  EXPECT_EQ(distance(base, Segment{{2, 0}, {2, 3}}), 0.0);
  EXPECT_TRUE(properly_cross(base, {{2, -1}, {2, 3}}));
  // Each has to part the other: this line would, its segment ends before.
  EXPECT_FALSE(properly_cross(base, {{2, -3}, {2, -1}}));
  EXPECT_FALSE(properly_cross({{2, -3}, {2, -1}}, base));
}

TEST(Plane, BoxHoldsEachPointAndHasOneOnEachSide) {
  Dice dice;
  std::vector<Vec2> points;
  for (int i = 0; i < 20; ++i)
    points.push_back(dice.point());
  const Box2 box = box_of(points);
  Vec2 lo = points[0], hi = points[0];
  for (const Vec2& p : points)
    for (const int axis : {0, 1}) {
      if (p[axis] < lo[axis]) lo[axis] = p[axis];
      if (p[axis] > hi[axis]) hi[axis] = p[axis];
    }
  EXPECT_EQ(box.lo, lo);
  EXPECT_EQ(box.hi, hi);
  EXPECT_TRUE(box_of({}).empty());
}

}  // namespace
}  // namespace planish
