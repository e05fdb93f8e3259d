#include "sharp_fit.hpp"

#include "sample_fits.hpp"
#include "support/error_data.hpp"

#include <planish/connect/codes.hpp>
#include <planish/sheet/codes.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace planish::test {
namespace {

using namespace connect_detail;

/// Two plates that have an edge on the x axis, at an angle of `degrees` between them, the second
/// from `from` to `to`.
PlateStructure hinged_plates(double degrees, double from = 0.0, double to = 200.0) {
  const double a = degrees * std::numbers::pi / 180;
  const Vec3 up(0, std::cos(a), std::sin(a));
  PlateStructure s;
  s.thickness = 3;
  s.plates = {rectangle_plate("A", {0, 0, 0}, {200, 0, 0}, {0, 100, 0}),
              rectangle_plate("B", {from, 0, 0}, {to - from, 0, 0}, 80 * up)};
  return s;
}

BendRequest fold_request() {
  BendRequest request;
  request.inside_radius = 0.0;
  return request;
}

TEST(AsksForFold, IsAnInsideRadiusOfZeroBetweenTwoPlates) {
  BendRequest request = fold_request();
  EXPECT_FALSE(asks_for_fold(request));
  request.between = {"A"};
  EXPECT_FALSE(asks_for_fold(request));
  request.between = {"A", "B"};
  EXPECT_TRUE(asks_for_fold(request));
  request.inside_radius = 0.1;
  EXPECT_FALSE(asks_for_fold(request));
  request.inside_radius.reset();
  EXPECT_FALSE(asks_for_fold(request));
}

TEST(FitFold, CutsBothPlatesBackToWhereTheirInnerSkinsMeet) {
  for (const double degrees : {60.0, 90.0, 120.0}) {
    const PairTask pair(hinged_plates(degrees), fold_request());
    const auto fit = fit_fold(pair.task, {});
    ASSERT_TRUE(fit) << fit.error().message;
    ASSERT_TRUE(fit->fold);
    // t / 2 over the tangent of half the angle between the plates.
    const double reach = 1.5 / std::tan(degrees * std::numbers::pi / 360);
    EXPECT_NEAR(fit->fold->reach, reach, 1e-9);
    EXPECT_NEAR(fit->report.line.offset, -reach, 1e-9);
    EXPECT_NEAR(fit->fold->high - fit->fold->low, 200, 1e-9);
    for (const auto& ends : fit->fold->at_corner)
      EXPECT_TRUE(ends[0] && ends[1]);
    EXPECT_NEAR(fit->report.angle.degrees(), 180 - degrees, 1e-9);
    // The surface's tangents lie on that line in both planes.
    for (int side = 0; side < 2; ++side) {
      const Vec3 at = fit->surface.tangents[side].origin;
      EXPECT_NEAR(fit->report.frame.local(side, at).y(), reach, 1e-9);
    }
  }
}

TEST(FitFold, TakesTheStretchThatBothEdgesHave) {
  const PairTask pair(hinged_plates(90, 50, 150), fold_request());
  const auto fit = fit_fold(pair.task, {});
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->fold->high - fit->fold->low, 100, 1e-9);
  EXPECT_EQ(fit->report.edges[0], std::vector<int>{0});
  EXPECT_NEAR(fit->runs[0].start, 0.25, 1e-9);
  EXPECT_NEAR(fit->runs[0].end, 0.75, 1e-9);
  EXPECT_FALSE(fit->fold->at_corner[0][0] || fit->fold->at_corner[0][1]);
  EXPECT_TRUE(fit->fold->at_corner[1][0] && fit->fold->at_corner[1][1]);
}

TEST(FitFold, IsShorterWhereThePlatesNarrowFromTheirCorners) {
  // B's sides lean inwards by 0.5 and 0.25 a millimetre: at the reach of 1.5 it is that much less.
  PlateStructure s = hinged_plates(90);
  s.plates[1].outline = {{0, 0, 0}, {200, 0, 0}, {180, 0, 80}, {40, 0, 80}};
  const PairTask pair(s, fold_request());
  const auto fit = fit_fold(pair.task, {});
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->fold->high - fit->fold->low, 200 - 1.5 * (0.25 + 0.5), 1e-9);
}

TEST(FitFold, TakesTheLongestStretchOrTheEdgeThatIsGiven) {
  // B stands on two feet, 60 and 90 wide.
  PlateStructure s = hinged_plates(90);
  s.plates[1].outline = {{0, 0, 0},   {60, 0, 0},  {60, 0, 20},  {110, 0, 20},
                         {110, 0, 0}, {200, 0, 0}, {200, 0, 80}, {0, 0, 80}};
  const PairTask pair(s, fold_request());
  EXPECT_NEAR(fit_fold(pair.task, {})->fold->high - fit_fold(pair.task, {})->fold->low, 90, 1e-9);
  BendRequest given = fold_request();
  given.edges[1] = std::vector<int>{0};
  const PairTask first(s, given);
  const auto fit = fit_fold(first.task, {});
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->fold->high - fit->fold->low, 60, 1e-9);
  EXPECT_EQ(fit->report.edges[1], std::vector<int>{0});
}

TEST(FitFold, RefusesPlatesWithoutACommonEdgeAndPlatesWithoutRoom) {
  PlateStructure apart = hinged_plates(90);
  for (Vec3& p : apart.plates[1].outline)
    p.z() += 1;
  const PairTask away(apart, fold_request());
  const auto none = fit_fold(away.task, {});
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code, code::no_bend_fits);
  // A plate of 1 mm ends before the inner skins meet, 1.5 from the line.
  PlateStructure narrow = hinged_plates(90);
  narrow.plates[1] = rectangle_plate("B", {0, 0, 0}, {200, 0, 0}, {0, 0, 1});
  const PairTask short_of(narrow, fold_request());
  const auto no_room = fit_fold(short_of.task, {});
  ASSERT_FALSE(no_room);
  EXPECT_EQ(no_room.error().code, code::overlap);
  EXPECT_NEAR(number_in(no_room.error(), "reach"), 1.5, 1e-9);
}

}  // namespace
}  // namespace planish::test
