#include "plane_profile.hpp"

#include "sample_transitions.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace planish::test {
namespace {

using namespace transition_detail;

std::vector<PlaneElement> elements(const Profile& profile, double outwards = 0.0) {
  auto made = elements_of(profile, outwards, "/p");
  EXPECT_TRUE(made) << (made ? "" : made.error().message);
  return made ? *made : std::vector<PlaneElement>{};
}

/// Each element ends where the next begins.
void expect_closed(const std::vector<PlaneElement>& all) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    const PlaneElement& next = all[(i + 1) % all.size()];
    EXPECT_LT((all[i].curve(all[i].t1).point - next.curve(next.t0).point).norm(), 1e-10) << i;
  }
}

double length_of(const PlaneElement& element) {
  return simpson([&](double t) { return element.curve(t).first.norm(); }, element.t0, element.t1,
                 200);
}

double perimeter(const std::vector<PlaneElement>& all) {
  double sum = 0.0;
  for (const PlaneElement& element : all)
    sum += length_of(element);
  return sum;
}

TEST(PiecesOf, APolygonAreItsEdgesWithMitredCorners) {
  const auto all = elements(rectangle(100, 60), 2.0);
  ASSERT_EQ(all.size(), 4u);
  expect_closed(all);
  EXPECT_LT((all[0].curve(0.0).point - Vec2(-52, -32)).norm(), 1e-12);
  EXPECT_LT((all[2].curve(0.0).point - Vec2(52, 32)).norm(), 1e-12);
  for (const PlaneElement& element : all)
    EXPECT_TRUE(element.straight);
}

TEST(PiecesOf, AClockwisePolygonRunsTheOtherWayAndKeepsItsNumbers) {
  const PolygonProfile given{{{0, 0}, {0, 50}, {80, 50}, {80, 0}}};
  const auto all = elements(given);
  ASSERT_EQ(all.size(), 4u);
  double twice = 0.0;
  for (const PlaneElement& element : all) {
    const Vec2 a = element.curve(0.0).point, b = element.curve(1.0).point;
    twice += a.x() * b.y() - a.y() * b.x();
    ASSERT_EQ(element.edges.size(), 1u);
    const int edge = element.edges[0].number;
    const Vec2 middle = 0.5 * (given.corners[edge] + given.corners[(edge + 1) % 4]);
    EXPECT_LT((element.curve(0.5).point - middle).norm(), 1e-12);
    ASSERT_EQ(element.corners.size(), 1u);
    EXPECT_EQ(a, given.corners[element.corners[0].number]);
  }
  EXPECT_NEAR(twice, 2.0 * 80 * 50, 1e-9) << "counter-clockwise";
}

TEST(PiecesOf, EdgesInOneLineAreOnePieceWithTheirShares) {
  const auto all = elements(PolygonProfile{{{0, 0}, {30, 0}, {100, 0}, {100, 50}, {0, 50}}});
  ASSERT_EQ(all.size(), 4u);
  ASSERT_EQ(all[0].edges.size(), 2u);
  EXPECT_NEAR(all[0].edges[0].to, 0.3, 1e-12);
  EXPECT_NEAR(all[0].edges[1].from, 0.3, 1e-12);
  EXPECT_EQ(all[0].edges[1].to, 1.0);
  ASSERT_EQ(all[0].corners.size(), 2u);
  EXPECT_NEAR(all[0].corners[1].at, 0.3, 1e-12);
}

TEST(PiecesOf, AnEllipseAreQuartersOfOneCurve) {
  const auto all = elements(EllipseProfile{50, 30});
  ASSERT_EQ(all.size(), 4u);
  expect_closed(all);
  EXPECT_NEAR(perimeter(all), ellipse_perimeter(50, 30), 1e-8);
  for (const PlaneElement& element : all) {
    EXPECT_EQ(element.source, all[0].source);
    EXPECT_DOUBLE_EQ(element.period, 2.0 * kPi);
  }
}

TEST(PiecesOf, ARoundedRectangleAreSidesAndQuartersSetOff) {
  const double w = 100, h = 60, r = 10, d = 2;
  const auto all = elements(RoundedRectangleProfile{w, h, r}, d);
  ASSERT_EQ(all.size(), 8u);
  expect_closed(all);
  EXPECT_NEAR(perimeter(all), 2 * (w - 2 * r) + 2 * (h - 2 * r) + 2 * kPi * (r + d), 1e-9);
  EXPECT_EQ(std::ranges::count_if(all, [](const auto& p) { return p.straight; }), 4);
  EXPECT_EQ(all[0].edges[0].number, 0) << "the side below";
  EXPECT_NEAR(all[0].curve(0.5).point.y(), -0.5 * h - d, 1e-12);
  // Without a radius it is the rectangle.
  const auto sharp = elements(RoundedRectangleProfile{w, h, 0.0}, d),
             same = elements(rectangle(w, h), d);
  ASSERT_EQ(sharp.size(), same.size());
  for (std::size_t i = 0; i < same.size(); ++i)
    EXPECT_LT((sharp[i].curve(sharp[i].t0).point - same[i].curve(same[i].t0).point).norm(), 1e-12);
}

TEST(PiecesOf, AnObroundHasHalfCirclesOfOneCurveEach) {
  const auto all = elements(ObroundProfile{100, 40});
  ASSERT_EQ(all.size(), 6u);
  expect_closed(all);
  EXPECT_NEAR(perimeter(all), 2 * 60 + kPi * 40, 1e-9);
  std::vector<int> sources;
  for (const PlaneElement& element : all)
    if (!element.straight) sources.push_back(element.source);
  ASSERT_EQ(sources.size(), 4u);
  std::ranges::sort(sources);
  EXPECT_EQ(sources[0], sources[1]);
  EXPECT_EQ(sources[2], sources[3]);
  EXPECT_NE(sources[1], sources[2]);
}

TEST(PiecesOf, ASplineAreQuartersOfItsPieces) {
  const auto all = elements(SplineProfile{regular_polygon(6, 50).corners});
  ASSERT_EQ(all.size(), 24u);
  expect_closed(all);
  EXPECT_EQ(all[5].knots.size(), 7u);
}

TEST(PiecesOf, AnEdgeThatTheThicknessUsesUpIsRefused) {
  // Set in by 4 mm, an edge of 8 mm between right angles has no length left.
  const auto refused = elements_of(rectangle(60, 8), -4.0, "/p");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, code::radius_too_small);
  EXPECT_EQ(refused.error().where, "/p/polygon");
  EXPECT_TRUE(elements_of(rectangle(60, 8), -3.999, "/p"));
}

}  // namespace
}  // namespace planish::test
