#include "gauge_edges.hpp"

#include "brake/stroke_room.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace planish::test {
namespace {

using namespace brake_detail;

constexpr double kHalfZone = 0.25 * std::numbers::pi * (2.0 + 0.44 * 1.5);

/// A web of 80 with a lip at its far end, and a flange to be bent at the other.
Sheet with_lip(double lip, const Turn& far = {Angle::degrees(90), 2, BendDirection::up}) {
  const Turn turn{Angle::degrees(90), 2, BendDirection::up};
  return strip({Straight{lip}, far, Straight{80}, turn, Straight{40}}, 60, 1.5);
}

BackGauge gauge_up_to(double highest) {
  return {10, 300, 30, {{0, 0}, {0, -20}, {80, -20}, {80, 0}}, -40.0, highest};
}

struct Facing {
  std::vector<GaugeEdge> edges, faces;
  Vec2 line_at, outward;  ///< of the bend line and towards the gauge, in the pattern
};

/// Of the second bend, with the web at the gauge.
Facing at_web(const Sheet& sheet, const std::vector<int>& formed, const BackGauge& gauge) {
  Room room(sheet, plain_tools());
  const LineSet stage = room.lines(formed);
  for (const StrokeChoice& choice : room.ways(2, formed)) {
    const Setting stroke = setting(room.inputs(), stage, choice);
    const BrakeLine& line = room.work().lines[stroke.line];
    if (room.work().bodies[line.bodies[stroke.direction > 0 ? 1 : 0]].flange != FlangeId(1))
      continue;
    return {edges_facing(room.cache(), stroke), formed_facing(room.cache(), stroke, gauge),
            line.origin, stroke.direction * line.across()};
  }
  ADD_FAILURE() << "no way has the web at the gauge";
  return {};
}

TEST(GaugeEdges, AreBordersInThePlaneOfTheSheet) {
  const Facing flat = at_web(with_lip(30.0), {}, gauge_up_to(80.0));
  ASSERT_EQ(flat.edges.size(), 1u);
  EXPECT_TRUE(flat.faces.empty());
  EXPECT_NEAR(flat.edges[0].away, 80.0 + 30.0 + 3.0 * kHalfZone, 1e-9);
  EXPECT_NEAR(flat.edges[0].along.hi - flat.edges[0].along.lo, 60.0, 1e-9);
  EXPECT_TRUE(at_web(with_lip(30.0), {1}, gauge_up_to(80.0)).edges.empty());
}

/// A lip's outer face is R + T beyond its tangent line and plane from R above the upper skin on.
TEST(GaugeEdges, AreLevelLinesOfUprightFaces) {
  for (const double lip : {3.0, 30.0}) {
    const Facing up = at_web(with_lip(lip), {1}, gauge_up_to(80.0));
    ASSERT_EQ(up.faces.size(), 1u);
    EXPECT_NEAR(up.faces[0].away, 80.0 + kHalfZone + 3.5, 1e-9);
    EXPECT_NEAR(up.faces[0].touched, std::min(lip, 20.0), 1e-9);
    EXPECT_EQ(up.faces[0].flange, FlangeId(0));
  }
  // A finger that stays low touches less, or nothing.
  EXPECT_NEAR(at_web(with_lip(30.0), {1}, gauge_up_to(9.0)).faces.at(0).touched, 7.0, 1e-9);
  EXPECT_EQ(at_web(with_lip(30.0), {1}, gauge_up_to(1.0)).faces.at(0).touched, 0.0);
}

/// A lip that leans back over the web is touched at its fold, which goes out to R + T beyond its
/// tangent line, at R above the upper skin or below the lower one: with half of T about it.
TEST(GaugeEdges, AreFoldsOfWhatLeansBack) {
  const double radius = 2.0, thickness = 1.5;
  for (const double degrees : {90.5, 120.0, 150.0})
    for (const BendDirection direction : {BendDirection::up, BendDirection::down}) {
      const Sheet sheet = with_lip(30.0, {Angle::degrees(degrees), radius, direction});
      const Facing facing = at_web(sheet, {1}, gauge_up_to(80.0));
      ASSERT_EQ(facing.faces.size(), 1u);
      const GaugeEdge& fold = facing.faces[0];
      EXPECT_FALSE(fold.flange);
      EXPECT_TRUE(fold.fold);
      EXPECT_NEAR(fold.away, 80.0 + kHalfZone + radius + thickness, 1e-9);
      EXPECT_NEAR(fold.length(), 60.0, 1e-9);
      EXPECT_NEAR(fold.height, direction == BendDirection::up ? radius + 0.5 * thickness : 0.0,
                  1e-9);
      // In the pattern it is a quarter of a turn from the tangent line.
      const double quarter = 0.5 * std::numbers::pi * (radius + 0.44 * thickness);
      const double at = (fold.in_pattern.a - facing.line_at).dot(facing.outward);
      EXPECT_NEAR(at, 80.0 + kHalfZone + quarter, 1e-9);
      // A finger that cannot rise so far does not touch it.
      const BackGauge low = gauge_up_to(1.9);
      EXPECT_EQ(at_web(sheet, {1}, low).faces.empty(), direction == BendDirection::up);
    }
  EXPECT_TRUE(
      at_web(with_lip(30.0, {Angle::degrees(80), 2, BendDirection::up}), {1}, gauge_up_to(80.0))
          .faces.empty());
}

}  // namespace
}  // namespace planish::test
