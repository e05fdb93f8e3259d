#include "dihedral.hpp"

#include "solid_models.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace planish::brep::test {
namespace {

using std::numbers::pi;

Loop closed(const std::vector<Vec2>& corners) {
  Loop loop;
  for (size_t i = 0; i < corners.size(); ++i)
    loop.push_back(Segment{corners[i], corners[(i + 1) % corners.size()]});
  return loop;
}

TEST(Dihedral, IsARightAngleAtEveryEdgeOfABox) {
  const SolidModel box = plate(2, {10, 5});
  for (int e = 0; e < std::ssize(box.edges); ++e)
    EXPECT_NEAR(dihedral(box, e).value(), pi / 2, 1e-12);
}

TEST(Dihedral, IsNegativeInTheInsideOfAnAngle) {
  const SolidModel angle = prism({closed({{0, 0}, {50, 0}, {50, 30}, {48, 30}, {48, 2}, {0, 2}})},
                                 40);
  EXPECT_NEAR(dihedral(angle, edge_between(angle, 5, 6)).value(), -pi / 2, 1e-12);
  EXPECT_NEAR(dihedral(angle, edge_between(angle, 2, 3)).value(), pi / 2, 1e-12);
}

TEST(Dihedral, IsUnknownAtSeamsAndOpenEdges) {
  const SolidModel drilled = plate(2, {20, 20}, {{{10, 10}, {{3, 2}, {3, 0}}}});
  EXPECT_FALSE(dihedral(drilled, edge_between(drilled, 6, 6)));
  SolidMaker maker;
  maker.plane(Vec3::UnitZ(), {polygon_path({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})});
  EXPECT_FALSE(dihedral(std::move(maker).build_open(), 0));
}

TEST(SmoothEdge, IsWhereABendLeavesItsFlange) {
  const SolidModel bent = prism({strip_profile(2, {{50, pi / 2, 3}, {30}})}, 40);
  EXPECT_TRUE(smooth_edge(bent, edge_between(bent, 2, 3)));
  EXPECT_TRUE(smooth_edge(bent, edge_between(bent, 7, 8)));
  EXPECT_FALSE(smooth_edge(bent, edge_between(bent, 0, 3))) << "a cut edge";
}

/// A strip whose top turns by an angle, from plane to plane.
SolidModel kinked(double angle) {
  return prism({closed({{0, 0}, {100, 0}, {100, 10}, {50, 10}, {0, 10 - 50 * std::tan(angle)}})},
               40);
}

TEST(SmoothEdge, BetweenPlanesIsParallelToATenthOfADegree) {
  const SolidModel nearly = kinked(0.05 * pi / 180);
  EXPECT_TRUE(smooth_edge(nearly, edge_between(nearly, 4, 5)));
  const SolidModel bent = kinked(0.3 * pi / 180);
  EXPECT_FALSE(smooth_edge(bent, edge_between(bent, 4, 5)));
}

}  // namespace
}  // namespace planish::brep::test
