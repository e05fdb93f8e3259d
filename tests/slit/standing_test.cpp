#include "equilibrium.hpp"
#include "sample_sheets.hpp"

#include <cmath>

// Sheets on the ground against closed forms.

namespace planish::test {
namespace {

/// A box without lid or bottom: panels of 200 × 300 over the sides of a rectangle.
FoldedSlitSheet box(double wide, double deep, double high) {
  FoldedSlitSheet folded{2.0, high, false, {}, {}, {}};
  const std::array<Vec3, 4> corners{Vec3(0, 0, 0), Vec3(wide, 0, 0), Vec3(wide, 0, deep),
                                    Vec3(0, 0, deep)};
  for (int i = 0; i < 4; ++i) {
    const Vec3 from = corners[i], along = corners[(i + 1) % 4] - from;
    // Flat coordinates are along (up) and across.
    folded.panel.push_back(
        {{Vec2(0, 0), Vec2(high, 0), Vec2(high, along.norm()), Vec2(0, along.norm())},
         frame_from_axes(from, Vec3::UnitY().cross(along).normalized(), Vec3::UnitY()),
         -1});
  }
  return folded;
}

SlitDesign of_steel() {
  SlitDesign design;
  design.sheet.thickness = 2.0;
  design.sheet.symmetric = false;
  design.material = SlitMaterial{210000.0, 0.3, 7.85, {}};
  design.gravity = true;
  return design;
}

TEST(Standing, BoxMayBeTiltedUntilItsCentreIsAboveAnEdge) {
  const auto standing = standing_of(box(200, 300, 500), of_steel());
  ASSERT_TRUE(standing);
  EXPECT_TRUE(standing->stands);
  EXPECT_LT((standing->centre_of_mass - Vec3(100, 250, 150)).norm(), 1e-9);
  EXPECT_NEAR(standing->margin.degrees(), Angle::radians(std::atan2(100, 250)).degrees(), 1e-9);
  EXPECT_EQ(standing->support.size(), 4u);
}

/// Tilted about its longer edge by α: what is left is the angle to the edge less α; its foot is
/// then that edge alone.
TEST(Standing, TiltedBoxStandsOnItsEdgeOnly) {
  FoldedSlitSheet tilted = box(200, 300, 500);
  const Eigen::AngleAxisd turn(Angle::degrees(10).radians(), Vec3::UnitZ());
  for (PanelFacet& facet : tilted.panel)
    facet.frame = frame_from_axes(turn * facet.frame.origin, turn * facet.frame.z,
                                  turn * facet.frame.x);
  const auto standing = standing_of(tilted, of_steel());
  EXPECT_FALSE(standing->stands);
  EXPECT_EQ(standing->support.size(), 2u);
}

/// Two arms lean apart: the weight is that of both, and the mirror image counts.
TEST(Standing, SymmetricSheetStandsOnBothHalves) {
  FoldedSlitSheet half = box(200, 300, 500);
  half.symmetric = true;
  for (PanelFacet& facet : half.panel)
    facet.frame.origin += Vec3(100, 0, 0);
  SlitDesign design = of_steel();
  design.sheet.symmetric = true;
  const auto standing = standing_of(half, design);
  EXPECT_NEAR(standing->centre_of_mass.x(), 0.0, 1e-9);
  EXPECT_NEAR(standing->margin.degrees(), Angle::radians(std::atan2(150, 250)).degrees(), 1e-9);
}

/// A strip of no weight worth speaking of, 400 beyond the box, with a load at its end: it tips as
/// soon as W · 100 = F · 400.
TEST(Standing, LoadBeyondTheEdgeTipsIt) {
  FoldedSlitSheet folded = box(200, 300, 500);
  FoldedStrip arm;
  arm.quads.push_back(frame_from_axes({200, 500, 150}, Vec3::UnitY(), Vec3::UnitX()));
  for (const double along : {0.0, 400.0})
    arm.ridges.push_back({{Vec2(along, -1e-6), Vec2(along, 1e-6)},
                          {Vec3(200 + along, 500, 150 + 1e-6), Vec3(200 + along, 500, 150 - 1e-6)},
                          Angle()});
  folded.strips.push_back(arm);
  SlitDesign design = of_steel();
  design.sheet.strips = equal_strips(1, 2e-6);
  const double weight = 7.85e-6 * 9.80665 * 2.0 * 500.0 * 1000.0;
  for (const double share : {0.9, 1.1}) {
    design.loads = {{0, 1.0, Vec3(0, -share * weight / 4.0, 0)}};
    const auto standing = standing_of(folded, design);
    EXPECT_EQ(standing->stands, share < 1.0);
    // Moments about the edge, and heights of what weighs.
    const double f = share / 4.0;
    EXPECT_NEAR(standing->margin.degrees(),
                Angle::radians(std::atan2(100.0 - f * 400.0, 250.0 + f * 500.0)).degrees(), 1e-6);
  }
}

/// A push at half its height tips a box that weighs too little.
TEST(Standing, SidewaysPushTipsIt) {
  FoldedSlitSheet folded = box(200, 300, 500);
  FoldedStrip plate;
  plate.quads.push_back(frame_from_axes({200, 500, 0}, Vec3::UnitX(), Vec3::UnitY()));
  for (const double along : {0.0, 1e-6})
    plate.ridges.push_back({{Vec2(along, 0), Vec2(along, 300)},
                            {Vec3(200, 500 + along, 0), Vec3(200, 500 + along, 300)},
                            Angle()});
  folded.strips.push_back(plate);
  SlitDesign design = of_steel();
  design.sheet.strips = equal_strips(1, 300);
  const double weight = 7.85e-6 * 9.80665 * 2.0 * 500.0 * 1000.0;
  for (const double share : {0.9, 1.1}) {
    design.loads = {{0, std::nullopt, Vec3(share * weight / 5.0, 0, 0)}};
    EXPECT_EQ(standing_of(folded, design)->stands, share < 1.0) << share;
  }
}

TEST(Standing, OfNothingThatPullsDownIsNothing) {
  SlitDesign design = of_steel();
  design.gravity = false;
  EXPECT_FALSE(standing_of(box(200, 300, 500), design));
}

}  // namespace
}  // namespace planish::test
