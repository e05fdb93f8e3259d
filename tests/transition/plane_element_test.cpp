#include "plane_element.hpp"

#include "sample_transitions.hpp"

#include <gtest/gtest.h>

namespace planish::test {
namespace {

using namespace transition_detail;

PlaneCurve ellipse(double rx, double ry) {
  return quarter(rx, ry, Vec2::Zero(), 0.0, 0.0, 0).curve;
}

TEST(PlaneElement, OfAnEdgeIsLinear) {
  const PlaneElement element = straight({10, 20}, {40, 60}, 3);
  EXPECT_TRUE(element.straight);
  EXPECT_EQ(element.source, 3);
  EXPECT_LT((element.curve(0.25).point - Vec2(17.5, 30)).norm(), 1e-14);
  EXPECT_EQ(element.curve(0.7).first, Vec2(30, 40));
  EXPECT_EQ(element.curve(0.7).second, Vec2(0, 0));
}

TEST(PlaneElement, OfACircleIsACircleSetOff) {
  const PlaneElement element = quarter(30, 30, {5, 7}, 2.0, kPi / 2, 0);
  EXPECT_DOUBLE_EQ(element.t1 - element.t0, kPi / 2);
  EXPECT_DOUBLE_EQ(element.circle_radius, 32.0);
  for (const double t : {element.t0, 2.0, element.t1})
    EXPECT_NEAR((element.curve(t).point - Vec2(5, 7)).norm(), 32.0, 1e-12);
  EXPECT_EQ(quarter(30, 20, {5, 7}, 2.0, 0.0, 0).circle_radius, 0.0) << "an ellipse has no radius";
}

TEST(SetOff, LiesAtTheDistanceAlongTheNormalToTheRight) {
  for (const double d : {-3.0, 4.0}) {
    const PlaneCurve curve = ellipse(50, 30), off = set_off(curve, d);
    for (const double t : {0.0, 0.4, 1.3, 4.0}) {
      const PlanePoint p = curve(t), q = off(t);
      const Vec2 right = Vec2(p.first.y(), -p.first.x()).normalized();
      EXPECT_LT((q.point - p.point - d * right).norm(), 1e-12);
    }
  }
}

TEST(SetOff, RunsFasterByItsCurvature) {
  // At t = 0 an ellipse has the curvature rx / ry² and the speed ry.
  const double rx = 50, ry = 30, d = 4;
  const PlanePoint end = set_off(ellipse(rx, ry), d)(0.0);
  EXPECT_NEAR(end.first.norm(), ry * (1.0 + d * rx / (ry * ry)), 1e-12);
}

TEST(SetOff, GivesTheDerivativesOfItself) {
  const PlaneCurve off = set_off(ellipse(50, 30), 4.0);
  constexpr double kStep = 1e-5;
  for (const double t : {0.3, 1.0, 2.5}) {
    const PlanePoint low = off(t - kStep), high = off(t + kStep);
    EXPECT_LT(((high.point - low.point) / (2 * kStep) - off(t).first).norm(), 1e-7);
    EXPECT_LT(((high.first - low.first) / (2 * kStep) - off(t).second).norm(), 1e-7);
  }
}

}  // namespace
}  // namespace planish::test
