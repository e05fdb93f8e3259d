#include "rim_volume.hpp"

#include "recognised.hpp"
#include "support/bent_bracket.hpp"
#include "support/unfolded_shape.hpp"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeWedge.hxx>
#include <TopLoc_Location.hxx>
#include <gtest/gtest.h>

#include <numbers>

namespace planish::brep::test {
namespace {

TEST(ClosedRim, GoesRoundBendsOnBothSkins) {
  const Recognised seen = recognised(
      prism({strip_profile(2, {{40, std::numbers::pi / 2, 3}, {30, 0, 0}})}, 50), 2, 2);
  ASSERT_EQ(seen.rim.parts.size(), 1u);
  const auto rim = closed_rim(seen.view(), {0});
  ASSERT_TRUE(rim);
  EXPECT_EQ(rim->parts.size(), 1u);
  EXPECT_EQ(rim->loops.size(), 6u) << "two flanges and a bend, each on either skin";
}

TEST(ClosedRim, OfAnOpeningIsItsOwn) {
  const Recognised seen = recognised(plate(2, {100, 60}, {{{30, 30}, {{5, 2}, {5, 0}}}}), 2, 1);
  const int hole = seen.rim.part_of.at(6);
  const auto rim = closed_rim(seen.view(), {hole});
  ASSERT_TRUE(rim);
  EXPECT_EQ(rim->parts, std::set<int>{hole});
  EXPECT_EQ(rim->loops, (std::set<LoopRef>{{kBottom, 1}, {kTop, 1}}));
}

/// With a window of 14 × 8 mm, its middle over the bend, sunk from the outside by 0.5 mm.
TopoDS_Shape with_window(const TopoDS_Shape& sheet, double x) {
  const gp_Ax2 corner(gp_Pnt(x - 9.5, 31.5, -2), gp_Dir(0, -1, 0), gp_Dir(1, 0, 0));
  TopoDS_Shape window = BRepPrimAPI_MakeBox(gp_Pnt(x - 7, 21, -9), gp_Pnt(x + 7, 29, 9));
  TopoDS_Shape sink = BRepPrimAPI_MakeWedge(corner, 19, 2.5, 13, 2.5, 2.5, 16.5, 10.5);
  return BRepAlgoAPI_Cut(BRepAlgoAPI_Cut(sheet, window), sink);
}

TEST(RimVolume, CountsWhatASinkTakesOffOnBothSidesOfASilhouette) {
  // Upright to one of the flanges, so that this has a silhouette along the window.
  for (const double turn : {-std::numbers::pi / 18, std::numbers::pi / 18})
    for (const double x : {0.0, 2.0, -4.0}) {
      gp_Trsf level;
      level.SetRotation(gp_Ax1(gp_Pnt(0, 0, 4), gp_Dir(0, 1, 0)), turn);
      const auto made = planish::test::unfolded_shape(
          with_window(planish::test::gently_bent().Moved(TopLoc_Location(level)), x));
      ASSERT_TRUE(made) << made.error().message;
      EXPECT_NEAR(made->certificate.explained_ratio.value_or(0), 1, 1e-6) << turn << ' ' << x;
    }
}
}  // namespace
}  // namespace planish::brep::test
