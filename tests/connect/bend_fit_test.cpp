#include "sample_fits.hpp"

#include <planish/connect/codes.hpp>

#include <gtest/gtest.h>

#include <numbers>

namespace planish::test {
namespace {

using namespace connect_detail;

using std::numbers::pi;

BendFit fit(const PairTask& pair) {
  auto made = fit_between(pair.task, {});
  EXPECT_TRUE(made) << (made ? "" : made.error().message);
  return made ? std::move(*made) : BendFit{};
}

TEST(FitBetween, ReportsWhatItChose) {
  const BendFit made = fit(PairTask(angle_pair(14.0, 200, 4.0)));
  const FittedBend& report = made.report;
  EXPECT_EQ(report.kind, BendKind::cylinder);
  EXPECT_NEAR(report.inside_radius, 12.0, 1e-9);
  EXPECT_NEAR(report.inside_radii[0], 12.0, 1e-9);
  EXPECT_NEAR(report.angle.degrees(), 90.0, 1e-9);
  EXPECT_NEAR(report.width, 200.0, 1e-9);
  EXPECT_NEAR(report.extension_area, 0.0, 1e-6);
  EXPECT_EQ(report.edges[0], std::vector{2});
  EXPECT_EQ(made.runs[0].first, 2);
  EXPECT_EQ(made.runs[0].count, 1);
  EXPECT_FALSE(report.apex);
}

TEST(FitBetween, ReportsTheRadiiOfAConeFromLeftToRight) {
  for (const auto& radii : {std::array{4.0, 10.0}, {10.0, 4.0}}) {
    const BendFit made = fit(PairTask(angle_pair(14.0, 200, 4.0),
                                      {.inside_radii = radii, .lateral = LateralBoundary::arc}));
    ASSERT_EQ(made.report.kind, BendKind::cone);
    EXPECT_GT((made.report.inside_radii[1] - made.report.inside_radii[0]) * (radii[1] - radii[0]),
              0.0);
    EXPECT_NEAR(made.report.inside_radius,
                0.5 * (made.report.inside_radii[0] + made.report.inside_radii[1]), 1e-9);
    ASSERT_TRUE(made.report.apex);
    EXPECT_NEAR(made.report.line.at(*made.report.apex), 0.0, 1e-9);
  }
}

TEST(FitBetween, NumbersARunThatGoesOverCornerZero) {
  PlateStructure s = angle_pair(14.0);
  std::rotate(s.plates[0].outline.begin(), s.plates[0].outline.begin() + 2,
              s.plates[0].outline.end());
  // Edge 0 is that which faces; divide it in its middle, so that edges 4 and 0 do.
  auto& outline = s.plates[0].outline;
  outline.insert(outline.begin() + 1, 0.5 * (outline[0] + outline[1]));
  std::rotate(outline.begin(), outline.begin() + 1, outline.end());
  const BendFit made = fit(PairTask(s));
  EXPECT_EQ(made.report.edges[0], (std::vector{0, 4}));
  EXPECT_EQ(made.runs[0].first, 4);
  EXPECT_EQ(made.runs[0].count, 2);
}

TEST(FitBetween, RefusesAConeOfParallelPlates) {
  const auto refused = fit_between(PairTask(u_pair(), {.surface = SurfaceChoice::general}).task,
                                   {});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, code::no_bend_fits);
  EXPECT_EQ(refused.error().where, "/bends/0/surface");
}

TEST(FitBetween, PutsThePlaceOfTheRequestBeforeTheKeyAtFault) {
  PairTask pair(angle_pair(14.0), {.inside_radius = 1e-4});
  pair.task.pointer = "/bends/3";
  EXPECT_EQ(fit_between(pair.task, {}).error().where, "/bends/3/inside_radius");
}

TEST(NearnessOf, PlatesIsTheSpanOfTheBestBendAndItsWidth) {
  const auto near = nearness(PairTask(angle_pair(14.0)).task, {});
  ASSERT_TRUE(near);
  EXPECT_NEAR(near->width, 200.0, 1e-9);
  // Edges 14 from the line on both sides: Ψ at the slope at which it is linearised.
  const double psi = arc_factor(Angle::degrees(90), EdgeKind::facing, kLinearisedSlope);
  EXPECT_NEAR(near->span, psi * 14.0, 1e-9);
}

TEST(NearnessOf, ParallelPlatesCountsTheHalfTurn) {
  const auto near = nearness(PairTask(u_pair(40.0)).task, {});
  ASSERT_TRUE(near);
  EXPECT_GT(near->span, 0.5 * pi * 40.0 - 1e-9);
  PlateStructure coplanar = angle_pair(14.0);
  coplanar.plates[1] = rectangle_plate("B", {0, 120, 0}, {200, 0, 0}, {0, 100, 0});
  EXPECT_FALSE(nearness(PairTask(coplanar).task, {}));
}

}  // namespace
}  // namespace planish::test
