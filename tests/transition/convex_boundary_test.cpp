#include "convex_boundary.hpp"

#include "sample_transitions.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace planish::test {
namespace {

using namespace transition_detail;

const Frame kTilted = frame_at({10, 20, 30}, 0.7, 0.3);

Boundary boundary(const Profile& profile, const Vec3& towards) {
  auto made = boundary_of({profile, kTilted}, 0.0, towards, "/p");
  EXPECT_TRUE(made) << (made ? "" : made.error().message);
  return made ? *made : Boundary{};
}

Vec3 point_at_share(const Boundary& boundary, int element, double share) {
  const Element& e = boundary.element(element);
  return e.curve(std::lerp(e.t0, e.t1, share)).point;
}

class BoundaryOf : public testing::TestWithParam<double> {
 protected:
  Vec3 towards() const { return GetParam() * kTilted.z; }
};
INSTANTIATE_TEST_SUITE_P(BothSides, BoundaryOf, testing::Values(1.0, -1.0));

TEST_P(BoundaryOf, RunsCounterClockwiseAboutItsAxisWhichPointsToTheWantedSide) {
  for (const Profile& profile : std::vector<Profile>{
           rectangle(100, 60), EllipseProfile{50, 30}, RoundedRectangleProfile{100, 60, 10},
           SplineProfile{regular_polygon(7, 40).corners}}) {
    const Boundary b = boundary(profile, towards());
    EXPECT_GT(b.axis.dot(towards()), 0.0);
    Vec3 area = Vec3::Zero();
    for (int i = 0; i < b.count(); ++i) {
      const Element &here = b.element(i), &next = b.element(i + 1);
      const Vec3 end = here.curve(here.t1).point;
      EXPECT_LT((end - next.curve(next.t0).point).norm(), 1e-10) << "element " << i;
      area += (here.curve(here.t0).point - kTilted.origin).cross(end - kTilted.origin);
    }
    EXPECT_GT(area.normalized().dot(b.axis), 1.0 - 1e-12);
  }
}

TEST_P(BoundaryOf, KnowsWhereTheEdgesAndCornersAreThatWereGiven) {
  const PolygonProfile given{{{-50, -30}, {10, -30}, {50, -30}, {50, 30}, {-50, 30}}};
  const Boundary b = boundary(given, towards());
  ASSERT_EQ(b.edges.size(), 5u);
  for (const GivenEdge& edge : b.edges) {
    const Vec2 middle = 0.5 * (given.corners[edge.number] + given.corners[(edge.number + 1) % 5]);
    EXPECT_LT((point_at_share(b, edge.element, 0.5 * (edge.from + edge.to)) - kTilted.point(middle))
                  .norm(),
              1e-10)
        << "edge " << edge.number;
  }
  ASSERT_EQ(b.corners.size(), 5u);
  for (const GivenCorner& corner : b.corners)
    EXPECT_LT(
        (point_at_share(b, corner.element, corner.at) - kTilted.point(given.corners[corner.number]))
            .norm(),
        1e-10)
        << "corner " << corner.number;
}

TEST_P(BoundaryOf, GivesTheDerivativesOfItsCurvesTheWayTheyRun) {
  const Boundary b = boundary(EllipseProfile{50, 30}, towards());
  constexpr double kStep = 1e-5;
  for (const Element& e : b.elements) {
    const double t = std::lerp(e.t0, e.t1, 0.4);
    const Vec3 slope = (e.curve(t + kStep).point - e.curve(t - kStep).point) / (2 * kStep);
    EXPECT_LT((slope - e.curve(t).derivative).norm(), 1e-7);
  }
}

TEST(BoundaryOf, HasCornersWhereAPolygonTurnsAndNoneOnCurves) {
  const Boundary square = boundary(rectangle(10, 10), kTilted.z);
  EXPECT_EQ(std::ranges::count(square.corner, true), 4);
  for (const Profile& smooth : std::vector<Profile>{EllipseProfile{50, 30}, ObroundProfile{100, 40},
                                                    RoundedRectangleProfile{100, 60, 10}}) {
    const Boundary b = boundary(smooth, kTilted.z);
    EXPECT_EQ(std::ranges::count(b.corner, true), 0);
  }
}

TEST(BoundaryOf, KeepsTheCirclesThatItsCurvesAreOf) {
  const Boundary b = boundary(RoundedRectangleProfile{100, 60, 10}, kTilted.z);
  int circles = 0;
  for (const Element& e : b.elements) {
    if (!e.circle) continue;
    ++circles;
    EXPECT_NEAR(e.circle->radius, 10.0, 1e-12);
    EXPECT_NEAR((e.curve(0.5 * (e.t0 + e.t1)).point - e.circle->centre).norm(), 10.0, 1e-12);
  }
  EXPECT_EQ(circles, 4);
}

}  // namespace
}  // namespace planish::test
