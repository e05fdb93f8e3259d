#include "plate_outline.hpp"

#include "sample_fits.hpp"

#include <planish/geometry/region.hpp>

#include <gtest/gtest.h>

namespace planish::test {
namespace {

using namespace connect_detail;

struct Extended {
  PairTask pair;
  BendFit fit;
  Extended(const PlateStructure& structure, const BendRequest& request) : pair(structure, request) {
    auto made = fit_between(pair.task, {});
    EXPECT_TRUE(made) << (made ? "" : made.error().message);
    if (made) fit = std::move(*made);
  }
  Result<ExtendedOutline> outline(int side) const {
    return extended_outline(pair.plates[side], {{5, side, &fit}}, "A");
  }
};

double area_of(const ExtendedOutline& outline) {
  std::vector<Vec2> ring;
  for (const auto& edge : outline.edges)
    ring.push_back(edge.a);
  return ring_area(ring);
}

/// The edge that is the joint of bend 5.
const ExtendedOutline::Edge& joint_of(const ExtendedOutline& outline) {
  const ExtendedOutline::Edge* joint = nullptr;
  for (const auto& edge : outline.edges)
    if (edge.bend) {
      EXPECT_EQ(joint, nullptr) << "one joint";
      EXPECT_EQ(*edge.bend, 5);
      joint = &edge;
    }
  EXPECT_NE(joint, nullptr);
  return joint ? *joint : outline.edges.front();
}

TEST(ExtendedOutline, OfAPlateWithoutBendsIsItsOwn) {
  const PlacedPlate plate = laid(angle_pair(14.0).plates[0]);
  const auto outline = extended_outline(plate, {}, "A");
  ASSERT_TRUE(outline);
  ASSERT_EQ(outline->edges.size(), 4u);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(outline->edges[i].a, plate.outline[i]);
    EXPECT_FALSE(outline->edges[i].bend);
  }
}

TEST(ExtendedOutline, GrowsToTheTangentLine) {
  // A radius of 5 mm, 4 mm thick: the tangent line lies 7 mm from the line of the planes.
  const Extended bend(angle_pair(14.0, 200, 4.0), {.inside_radius = 5.0});
  for (int side = 0; side < 2; ++side) {
    const auto outline = bend.outline(side);
    ASSERT_TRUE(outline) << outline.error().message;
    EXPECT_NEAR(area_of(*outline), 200.0 * (100 + 7), 1e-6);
    const auto& joint = joint_of(*outline);
    EXPECT_NEAR((joint.b - joint.a).norm(), 200.0, 1e-9);
    // On the tangent line, in space.
    for (const Vec2& p : {joint.a, joint.b}) {
      const Vec3 at = bend.pair.plates[side].frame.point(p);
      EXPECT_NEAR(side == 0 ? at.y() : at.z(), side == 0 ? 107.0 : 7.0, 1e-9);
    }
  }
}

TEST(ExtendedOutline, RunsSlantedToABendThatIsNarrower) {
  // The second plate is 100 wide, in the middle of the first, whose corners reach in to it.
  PlateStructure s = angle_pair(14.0, 200, 4.0);
  s.plates[1] = rectangle_plate("B", {50, 114, 14}, {100, 0, 0}, {0, 0, 100});
  const Extended bend(s, {.inside_radius = 5.0, .lateral = LateralBoundary::corner});
  const auto outline = bend.outline(0);
  ASSERT_TRUE(outline) << outline.error().message;
  EXPECT_NEAR((joint_of(*outline).b - joint_of(*outline).a).norm(), 100.0, 1e-9);
  EXPECT_NEAR(area_of(*outline), 200.0 * 100 + 7 * 0.5 * (200 + 100), 1e-6) << "a trapezium";
}

TEST(JointRange, IsTheBoundsOfTheBendOnItsPlate) {
  const Extended bend(angle_pair(14.0, 200, 4.0), {.inside_radius = 5.0});
  const JointRange range = joint_range(bend.fit, 0, bend.pair.plates[0]);
  EXPECT_NEAR(range.low, bend.fit.boundaries.low.v[0], 1e-12);
  EXPECT_NEAR(range.high, bend.fit.boundaries.high.v[0], 1e-12);
}

TEST(JointRange, EndsAtTheCornersOfAnEdgeOnTheRuling) {
  // Both edges lie on their tangent lines; the bend as an arc is 50 wider than the second.
  PlateStructure s = angle_pair(14.0, 200, 4.0);
  s.plates[1] = rectangle_plate("B", {50, 114, 14}, {100, 0, 0}, {0, 0, 100});
  const Extended bend(s, {.lateral = LateralBoundary::arc});
  EXPECT_NEAR(bend.fit.boundaries.high.v[1] - bend.fit.boundaries.low.v[1], 150.0, 1e-9);
  const JointRange range = joint_range(bend.fit, 1, bend.pair.plates[1]);
  EXPECT_NEAR(range.high - range.low, 100.0, 1e-9);
}

}  // namespace
}  // namespace planish::test
