#include "hole_shape.hpp"

#include "sample_plates.hpp"

#include <planish/connect/codes.hpp>
#include <planish/connect/connect.hpp>
#include <planish/sheet/codes.hpp>
#include <planish/sheet/flat_pattern.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace planish::test {
namespace {

using std::numbers::pi;

/// Two plates at a right angle with holes in the first, whose plane is z = 0.
PlateStructure with_shapes(std::vector<HoleShape> shapes) {
  PlateStructure s = angle_pair(20.0);
  for (HoleShape& shape : shapes) {
    s.plates[0].shapes.emplace(s.plates[0].holes.size(), std::move(shape));
    s.plates[0].holes.emplace_back();
  }
  return s;
}

const RoundHole kRound{{40, 50, 0}, 12};
const SlotHole kSlot{{80, 30, 0}, {80, 70, 0}, 10};
/// A half disc of radius 15.
const ArcHole kHalf{{{120, 50, 0}, {150, 50, 0}}, {Vec3(135, 65, 0), std::nullopt}};

TEST(HoleShapes, StayCirclesSlotsAndArcsInThePattern) {
  const auto solid = connect(angle_pair(20.0));
  ASSERT_TRUE(solid);
  const double removed = pi * 12 * 12 + (40 * 10 + pi * 5 * 5) + 0.5 * pi * 15 * 15;
  for (const double sign : {1.0, -1.0}) {  // material on either side of the plates
    PlateStructure s = with_shapes({kRound, kSlot, kHalf});
    for (Vec3& p : s.plates[1].outline)
      p.z() *= sign;
    const auto made = connect(s);
    ASSERT_TRUE(made) << made.error().message;
    const FlattenOptions options{.allowance = ConstantK{0.5, "test"}, .root = made->root};
    const auto pattern = flatten(made->sheet, options), whole = flatten(solid->sheet, options);
    ASSERT_TRUE(pattern && whole);
    EXPECT_NEAR(pattern->area, whole->area - removed, 1e-8);
    ASSERT_EQ(pattern->openings.size(), 3u);
    std::size_t arcs = 0, others = 0;
    for (const Contour& opening : pattern->openings)
      for (const Curve2& curve : opening.loop)
        ++(std::holds_alternative<Arc>(curve) ? arcs : others);
    EXPECT_EQ(arcs, 1u + 2u + 1u);
    EXPECT_EQ(others, 2u + 1u);
  }
}

TEST(HoleShapes, RunClockwiseWhicheverWayTheyAreGiven) {
  const Frame plane = frame_from_normal(Vec3::Zero(), Vec3::UnitZ());
  ArcHole turned = kHalf;
  std::ranges::reverse(turned.corners);
  turned.through = {Vec3(135, 65, 0), std::nullopt};
  for (const HoleShape& shape :
       {HoleShape(kRound), HoleShape(kSlot), HoleShape(kHalf), HoleShape(turned)})
    EXPECT_LT(signed_area(hole_loop(shape, plane)), 0.0);
  EXPECT_NEAR(signed_area(hole_loop(kSlot, plane)), -(40 * 10 + pi * 25), 1e-9);
  EXPECT_NEAR(signed_area(hole_loop(kHalf, plane)), -0.5 * pi * 225, 1e-9);
}

TEST(HoleShapes, AreRefusedAsPolygonsAre) {
  const auto code_of = [](HoleShape shape) {
    const auto made = connect(with_shapes({std::move(shape)}));
    return made ? code::cancelled : made.error().code;
  };
  EXPECT_EQ(code_of(RoundHole{{40, 50, 0}, 60}), code::invalid_input);
  EXPECT_EQ(code_of(RoundHole{{40, 50, 0}, 0}), code::invalid_input);
  EXPECT_EQ(code_of(RoundHole{{40, 50, 3}, 12}), code::not_planar);
  // Tangent to the outline, and to each other.
  EXPECT_EQ(code_of(RoundHole{{77.3, 10, 0}, 10}), code::self_crossing);
  EXPECT_FALSE(connect(
      with_shapes({kRound, RoundHole{kRound.at + Vec3(17 * std::cos(0.3), 17 * std::sin(0.3), 0),
                                     17 - kRound.radius}})));
  const auto both = connect(with_shapes({kRound, RoundHole{{50, 50, 0}, 5}}));
  ASSERT_FALSE(both);
  EXPECT_EQ(both.error().code, code::self_crossing);
}

TEST(HoleShapes, CarryNoBends) {
  // The numbers of the polygons' edges go on without them.
  PlateStructure s = with_shapes({kRound});
  s.plates[0].holes.push_back({{80, 40, 0}, {100, 40, 0}, {100, 60, 0}});
  s.bends = {{.between = {"A", "B"}, .edges = {std::vector{7}, std::nullopt}}};
  const auto made = connect(s);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, code::unknown_edge);
}

}  // namespace
}  // namespace planish::test
