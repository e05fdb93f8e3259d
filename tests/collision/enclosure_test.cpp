#include "enclosure.hpp"

#include "collision/solid_meshes.hpp"

#include <gtest/gtest.h>

namespace planish::collision_detail {
namespace {

using planish::test::append;
using planish::test::block;

Mesh two_blocks() {
  MeshOfFaces both = block({0, 0, 0}, {10, 10, 10}, 3);
  append(both, block({6, 5, 4}, {20, 20, 20}, 2));
  return both.mesh;
}

int times_in_blocks(const Vec3& p) {
  const auto in = [&](const Vec3& low, const Vec3& high) {
    return (p.array() > low.array()).all() && (p.array() < high.array()).all();
  };
  return in({0, 0, 0}, {10, 10, 10}) + in({6, 5, 4}, {20, 20, 20});
}

TEST(Enclosure, CountsHowManySolidsHoldAPoint) {
  const Enclosure enclosure(two_blocks());
  for (double x = -1.3; x < 22; x += 2.1)
    for (double y = -1.2; y < 22; y += 2.3)
      for (double z = -1.1; z < 22; z += 2.7)
        EXPECT_EQ(enclosure.times_enclosed({x, y, z}), times_in_blocks({x, y, z}))
            << x << " " << y << " " << z;
}

TEST(Enclosure, CountsAPointInLineWithEdgesToo) {
  const Enclosure enclosure(block({0, 0, 0}, {9, 9, 9}, 3).mesh);
  for (const double x : {3.0, 6.0, 4.5})
    for (const double y : {3.0, 6.0, 4.5})
      EXPECT_EQ(enclosure.times_enclosed({x, y, 4.5}), 1);
}

TEST(Enclosure, CountsAnOpeningThroughAGapOnce) {
  // A wall of the block is missing: the ray through it counts one too few, and the least is taken.
  MeshOfFaces open = block({0, 0, 0}, {10, 10, 10});
  open.mesh.triangles.erase(open.mesh.triangles.begin(), open.mesh.triangles.begin() + 2);
  EXPECT_LE(Enclosure(open.mesh).times_enclosed({5.2, 4.1, 4.7}), 0);
}

TEST(Enclosure, MeasuresTheClearBallToFacesEdgesAndCorners) {
  const Enclosure enclosure(block({0, 0, 0}, {10, 10, 10}, 2).mesh);
  const auto radius = [&](const Vec3& p, double most) {
    const Ball ball = enclosure.clear_ball(p, most);
    EXPECT_TRUE(ball.centre.isApprox(p));
    return ball.radius;
  };
  EXPECT_NEAR(radius({3, 4, 5}, 100), 3, 1e-12);
  EXPECT_NEAR(radius({3, 4, 9}, 100), 1, 1e-12);
  EXPECT_NEAR(radius({3, 4, 5}, 2), 2, 1e-12) << "no more than asked";
  EXPECT_NEAR(radius({5, 13, 14}, 100), 5, 1e-12) << "from an edge";
  EXPECT_NEAR(radius({-2, -3, -6}, 100), 7, 1e-12) << "from a corner";
}

TEST(Enclosure, ClimbsToTheWidestBall) {
  for (const Vec3& from : {Vec3(0.5, 0.4, 0.3), Vec3(9, 9.5, 1), Vec3(15, 5, 2)}) {
    // A bar of 20 × 10 × 4: a ball of radius 2 anywhere in its middle plane.
    const Ball ball = Enclosure(block({0, 0, 0}, {20, 10, 4}, 2).mesh).widest_ball(from);
    EXPECT_NEAR(ball.radius, 2, 0.01);
    EXPECT_NEAR(ball.centre.z(), 2, 0.01);
  }
  const Ball cube = Enclosure(block({0, 0, 0}, {6, 6, 6}).mesh).widest_ball({0.5, 1, 2});
  EXPECT_NEAR(cube.radius, 3, 0.02);
  EXPECT_NEAR((cube.centre - Vec3(3, 3, 3)).norm(), 0.0, 0.1);
  const Ball common = Enclosure(two_blocks()).widest_ball({6.5, 9, 9});
  EXPECT_NEAR(common.radius, 2, 0.02) << "what both hold is 4 × 5 × 6";
  EXPECT_NEAR(common.centre.x(), 8, 0.05);
}

TEST(Enclosure, ClimbsInAWedgeToItsInscribedBall) {
  // A prism over a right triangle of 30, 40, 50, as a quadrilateral whose fourth corner lies on a
  // side: its inscribed circle has radius 10.
  const auto wedge = planish::test::quad_prism({Vec2(0, 0), Vec2(30, 0), Vec2(15, 20), Vec2(0, 40)},
                                               0, 100);
  const Ball ball = Enclosure(wedge.mesh).widest_ball({2, 3, 50});
  EXPECT_NEAR(ball.radius, 10, 0.1);
  EXPECT_NEAR(ball.centre.x(), 10, 0.3);
  EXPECT_NEAR(ball.centre.y(), 10, 0.3);
}

}  // namespace
}  // namespace planish::collision_detail
