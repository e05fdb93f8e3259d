#include "edge_curve.hpp"

#include <planish/geometry/plane.hpp>

#include <gtest/gtest.h>

#include <cmath>

// Edges of strips: lines keep their coordinates, chains their corners and ends.

namespace planish::test {
namespace {

using namespace slit_detail;

std::vector<Vec2> arc(int lines) {
  std::vector<Vec2> chain;
  for (int i = 0; i <= lines; ++i) {
    const double angle = 1.2 * i / lines;
    chain.emplace_back(300.0 * std::sin(angle), 50.0 + 300.0 * (1.0 - std::cos(angle)));
  }
  return chain;
}

TEST(EdgeCurve, OfALineHasTheCoordinateAlongAsAbscissa) {
  const EdgeCurve line(35.0);
  EXPECT_TRUE(line.is_line());
  const EdgePlace place = line.place(123.0);
  EXPECT_EQ(place.at, Vec2(123.0, 35.0));
  EXPECT_EQ(place.first, Vec2::UnitX());
  EXPECT_EQ(place.second, Vec2::Zero());
}

TEST(EdgeCurve, RunsFromTheFirstCornerToTheLast) {
  const EdgeCurve edge(arc(40), 200.0, 560.0);
  EXPECT_LT((edge.place(200.0).at - arc(40).front()).norm(), 1e-12);
  EXPECT_LT((edge.place(560.0).at - arc(40).back()).norm(), 1e-9);
  EXPECT_EQ(edge.across(), 50.0);
}

/// Of 300 mm an arc whose lines are 9 mm long: rounded corners lie within the lines' sagitta,
/// 9²/8R.
TEST(EdgeCurve, StaysByItsChainAndTurnsAsItDoes) {
  const EdgeCurve edge(arc(40), 200.0, 560.0);
  const double speed = 360.0 / 360.0;
  for (double s = 215.0; s < 545.0; s += 0.37) {
    const EdgePlace place = edge.place(s);
    const double off = (place.at - Vec2(0.0, 350.0)).norm() - 300.0;
    EXPECT_LE(std::abs(off), 81.0 / (8.0 * 300.0)) << s;
    EXPECT_NEAR(place.first.norm(), speed, 1e-3) << s;
    // Curvature of the circle, from the derivatives.
    EXPECT_NEAR(planish::cross(place.first, place.second), 1.0 / 300.0, 1e-5) << s;
  }
}

TEST(EdgeCurve, HasTheDerivativesOfItsDifferences) {
  const EdgeCurve edge({{0, 0}, {40, 10}, {60, 50}, {160, 45}}, 10.0, 310.0);
  constexpr double kStep = 1e-5;
  for (double s = 10.7; s < 310.0; s += 1.13) {
    const EdgePlace up = edge.place(s + kStep), down = edge.place(s - kStep), at = edge.place(s);
    EXPECT_LT(((up.at - down.at) / (2.0 * kStep) - at.first).norm(), 1e-6) << s;
    EXPECT_LT(((up.first - down.first) / (2.0 * kStep) - at.second).norm(), 1e-6) << s;
  }
  // Places and first derivatives do not jump, also at corners.
  for (double s = 10.01; s < 309.9; s += 0.01)
    EXPECT_LT((edge.place(s + 0.01).first - edge.place(s).first).norm(), 2e-3) << s;
}

TEST(EdgeCurve, IsMetByARidgeOnItsChain) {
  const std::vector<Vec2> chain = arc(12);
  const EdgeCurve edge(chain, 200.0, 560.0);
  for (double s = 200.0; s <= 560.0; s += 7.3) {
    const EdgePlace place = edge.place(s);
    const Vec2 near = place.at,
               from = near - 20.0 * place.first - 40.0 * perpendicular(place.first);
    const EdgeCurve::Crossing met = edge.on_chain(from, near, s);
    EXPECT_LT(std::abs(planish::cross(near - from, met.at - from)) / (near - from).norm(), 1e-10);
    EXPECT_LT(distance(met.at, {chain[met.line], chain[met.line + 1]}), 1e-10);
    // Lines of 30 mm on 300 mm: their sagitta, on the slope of the ridge to a line beside.
    const double slope = std::sin(std::atan2(40.0, 20.0) - 30.0 / 300.0);
    EXPECT_LT((met.at - near).norm(), 30.0 * 30.0 / (8.0 * 300.0) / slope);
  }
}

}  // namespace
}  // namespace planish::test
