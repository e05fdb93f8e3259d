#include <planish/slit/bezier.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace planish::test {
namespace {

const BezierCurve kParabola{{{0, 0}, {1, 0}, {2, 2}}};  // y = x²/2, x = 2t

TEST(Bezier, OfDegreeTwoIsAParabola) {
  for (double t : {0.0, 0.2, 0.7, 1.0}) {
    const BezierPoint p = bezier_at(kParabola, t);
    EXPECT_NEAR(p.point.x(), 2 * t, 1e-15);
    EXPECT_NEAR(p.point.y(), 2 * t * t, 1e-15);
    EXPECT_NEAR((p.first - Vec2(2, 4 * t)).norm(), 0.0, 1e-14);
    EXPECT_NEAR((p.second - Vec2(0, 4)).norm(), 0.0, 1e-14);
  }
}

TEST(Bezier, HasTheLengthOfItsIntegral) {
  // ∫0² √(1 + x²) dx.
  EXPECT_NEAR(length(kParabola), std::sqrt(5.0) + 0.5 * std::asinh(2.0), 1e-12);
  EXPECT_NEAR(length(BezierCurve{{{0, 0}, {3, 4}}}), 5.0, 1e-14);
}

TEST(Bezier, OfHighDegreeStaysOnItsLine) {
  BezierCurve line;
  for (int i = 0; i <= 40; ++i)
    line.poles.emplace_back(3.0 * i, 4.0 * i);
  EXPECT_NEAR(length(line), 200.0, 1e-11);
  EXPECT_NEAR((bezier_at(line, 0.3).point - Vec2(36, 48)).norm(), 0.0, 1e-12);
}

TEST(Bezier, IsTightestAtTheParabolasVertex) {
  const TightestBend tightest = tightest_bend(BezierCurve{{{-1, 0.5}, {0, -0.5}, {1, 0.5}}});
  EXPECT_NEAR(tightest.radius, 1.0, 1e-12);
  EXPECT_NEAR(tightest.t, 0.5, 1e-6);
}

TEST(Bezier, NearestPointHasItsFootPerpendicular) {
  const BezierSearch search(kParabola);
  for (const Vec2& p : {Vec2(1.5, 0.2), Vec2(0.3, 1.4), Vec2(1.0, 0.9)}) {
    const auto foot = search.nearest(p);
    EXPECT_NEAR((p - foot.point).dot(bezier_at(kParabola, foot.t).first), 0.0, 1e-12);
    constexpr double kStep = 1e-6;
    for (int axis = 0; axis < 2; ++axis) {
      const Vec2 step = kStep * Vec2::Unit(axis);
      const Vec2 slope = (search.nearest(p + step).point - search.nearest(p - step).point) /
                         (2 * kStep);
      EXPECT_NEAR((slope - foot.derivative.col(axis)).norm(), 0.0, 1e-7);
    }
  }
  EXPECT_EQ(search.nearest({-1, -1}).t, 0.0);
  EXPECT_EQ(search.nearest({-1, -1}).derivative, Eigen::Matrix2d::Zero());
}

TEST(Bezier, PointsAtLengthsLieThere) {
  const auto points = points_at_lengths(BezierCurve{{{0, 0}, {3, 0}, {3, 0}, {10, 0}}},
                                        {0.0, 2.5, 10.0, 20.0});
  EXPECT_NEAR(points[1].x(), 2.5, 1e-3);
  EXPECT_NEAR(points[2].x(), 10.0, 1e-12);
  EXPECT_NEAR(points[3].x(), 10.0, 1e-12);
}

TEST(BezierCurve, StopsWherePolesAreNotFinite) {
  for (const double far : {std::nan(""), std::numeric_limits<double>::infinity(), 1e300}) {
    const BezierCurve curve{{{0, 0}, {1, far}, {2, 0}}};
    EXPECT_FALSE(is_regular(curve));
    EXPECT_DEATH((void)length(curve), "is_regular");
    EXPECT_DEATH((void)points_at_lengths(curve, {1.0}), "is_regular");
    EXPECT_DEATH((void)tightest_bend(curve), "is_regular");
    EXPECT_DEATH((void)BezierSearch(curve), "is_regular");
  }
  EXPECT_FALSE(is_regular(BezierCurve{}));
}

}  // namespace
}  // namespace planish::test
