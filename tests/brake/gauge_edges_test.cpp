#include "gauge_edges.hpp"

#include "brake/stroke_room.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace planish::test {
namespace {

using namespace brake_detail;

constexpr double kHalfZone = 0.25 * std::numbers::pi * (2.0 + 0.44 * 1.5);

/// A web of 80 with a lip at its far end, and a flange to be bent at the other.
Sheet with_lip(double lip) {
  const Turn turn{Angle::degrees(90), 2, BendDirection::up};
  return strip({Straight{lip}, turn, Straight{80}, turn, Straight{40}}, 60, 1.5);
}

BackGauge gauge_up_to(double highest) {
  return {10, 300, 30, {{0, 0}, {0, -20}, {80, -20}, {80, 0}}, -40.0, highest};
}

struct Facing {
  std::vector<GaugeEdge> edges, faces;
};

/// Of the second bend, with the web at the gauge.
Facing at_web(double lip, const std::vector<int>& formed, const BackGauge& gauge) {
  Room room(with_lip(lip), plain_tools());
  const LineSet stage = room.lines(formed);
  for (const StrokeChoice& choice : room.ways(2, formed)) {
    const Setting stroke = setting(room.inputs(), stage, choice);
    const BrakeLine& line = room.work().lines[stroke.line];
    if (room.work().bodies[line.bodies[stroke.direction > 0 ? 1 : 0]].flange != FlangeId(1))
      continue;
    return {edges_facing(room.cache(), stroke), faces_facing(room.cache(), stroke, gauge)};
  }
  ADD_FAILURE() << "no way has the web at the gauge";
  return {};
}

TEST(GaugeEdges, AreBordersInThePlaneOfTheSheet) {
  const Facing flat = at_web(30.0, {}, gauge_up_to(80.0));
  ASSERT_EQ(flat.edges.size(), 1u);
  EXPECT_TRUE(flat.faces.empty());
  EXPECT_NEAR(flat.edges[0].away, 80.0 + 30.0 + 3.0 * kHalfZone, 1e-9);
  EXPECT_NEAR(flat.edges[0].along.hi - flat.edges[0].along.lo, 60.0, 1e-9);
  EXPECT_TRUE(at_web(30.0, {1}, gauge_up_to(80.0)).edges.empty());
}

/// A lip's outer face is R + T beyond its tangent line and plane from R above the upper skin on.
TEST(GaugeEdges, AreLevelLinesOfUprightFaces) {
  for (const double lip : {3.0, 30.0}) {
    const Facing up = at_web(lip, {1}, gauge_up_to(80.0));
    ASSERT_EQ(up.faces.size(), 1u);
    EXPECT_NEAR(up.faces[0].away, 80.0 + kHalfZone + 3.5, 1e-9);
    EXPECT_NEAR(up.faces[0].touched, std::min(lip, 20.0), 1e-9);
    EXPECT_EQ(up.faces[0].flange, FlangeId(0));
  }
  // A finger that stays low touches less, or nothing.
  EXPECT_NEAR(at_web(30.0, {1}, gauge_up_to(9.0)).faces.at(0).touched, 7.0, 1e-9);
  EXPECT_EQ(at_web(30.0, {1}, gauge_up_to(1.0)).faces.at(0).touched, 0.0);
}

}  // namespace
}  // namespace planish::test
