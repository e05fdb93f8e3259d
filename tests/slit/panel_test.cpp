#include "panel.hpp"

#include <planish/slit/bezier.hpp>
#include <planish/slit/slit_sheet.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace planish::test {
namespace {

TEST(Panel, StandsOnChordsOfTheStripsWidths) {
  SlitSheet sheet;
  sheet.thickness = 1;
  sheet.panel_height = 50;
  sheet.half_length = 100;
  sheet.strips = {{.width = 20, .gap = 5}, {.width = 10}, {.width = 15, .gap = 7}};
  sheet.margin = 3;
  const BezierCurve curve{{{40, 0}, {60, 20}, {50, 49}, {40, 54}}};
  const auto panel = slit_detail::panel_of(sheet, curve);
  ASSERT_TRUE(panel) << panel.error().message;
  ASSERT_EQ(panel->size(), 6u);
  const BezierSearch search(curve);
  double across = 0.0;
  for (std::size_t i = 0; i < panel->size(); ++i) {
    const PanelFacet& facet = (*panel)[i];
    EXPECT_DOUBLE_EQ(facet.corners[0].y(), across);
    across = facet.corners[3].y();
    const Vec3 left = facet.frame.point(facet.corners[0]),
               right = facet.frame.point(facet.corners[3]);
    EXPECT_NEAR((right - left).norm(), facet.corners[3].y() - facet.corners[0].y(), 1e-13 * 60);
    EXPECT_NEAR((search.nearest({left.x(), left.z()}).point - Vec2(left.x(), left.z())).norm(), 0.0,
                1e-10);
    if (i > 0) {
      EXPECT_NEAR(((*panel)[i - 1].frame.point((*panel)[i - 1].corners[2]) -
                   facet.frame.point(facet.corners[1]))
                      .norm(),
                  0.0, 1e-12 * 60);
    }
  }
  EXPECT_NEAR(across, 60.0, 1e-12);
}

TEST(Panel, GoesOnStraightBeyondALegCurveThatEndsALittleBeforeIt) {
  // Half a millimetre of 60 is missing: the last strip and the margin stand beyond the end.
  SlitSheet sheet;
  sheet.thickness = 1;
  sheet.panel_height = 50;
  sheet.half_length = 100;
  for (const double margin : {0.1, 0.3, 0.45, 0.8}) {
    sheet.strips = {{.width = 20}, {.width = 25}, {.width = 15 - margin}};
    sheet.margin = margin;
    const auto panel = slit_detail::panel_of(sheet, {{{40, 5}, {40, 64.5}}});
    ASSERT_TRUE(panel) << panel.error().message;
    for (const PanelFacet& facet : *panel)
      for (const Vec2& p : facet.corners)
        EXPECT_NEAR((facet.frame.point(p) - Vec3(40, p.x(), 5 + p.y())).norm(), 0.0, 1e-9)
            << margin;
  }
  // However it is divided, no more than 2 % may be missing: 1.2 mm of 60.
  for (const double margin : {0.05, 0.3, 1.0, 3.0}) {
    sheet.strips = {{.width = 20}, {.width = 25}, {.width = 15 - margin}};
    sheet.margin = margin;
    EXPECT_TRUE(slit_detail::panel_of(sheet, {{{40, 5}, {40, 63.9}}})) << margin;
    EXPECT_FALSE(slit_detail::panel_of(sheet, {{{40, 5}, {40, 63.7}}})) << margin;
    EXPECT_TRUE(slit_detail::panel_of(sheet, {{{40, 5}, {40, 66.1}}})) << margin;
    EXPECT_FALSE(slit_detail::panel_of(sheet, {{{40, 5}, {40, 66.3}}})) << margin;
  }
}

/// Of 50 by 60 in three strips, one of which begins higher.
SlitSheet small_sheet() {
  SlitSheet sheet;
  sheet.thickness = 1;
  sheet.panel_height = 50;
  sheet.half_length = 100;
  sheet.symmetric = false;
  sheet.strips = {{.width = 20}, {.width = 25, .end = 130}, {.width = 15}};
  return sheet;
}

TEST(Panel, LeansAboutTheLineThroughTheEndsOfItsLegCurve) {
  const BezierCurve straight{{{40, 5}, {40, 65}}};
  for (const double degrees : {0.0, 30.0, 90.0, -90.0}) {
    const Angle lean = Angle::degrees(degrees);
    const auto panel = slit_detail::panel_of(small_sheet(), straight, lean);
    ASSERT_TRUE(panel) << panel.error().message;
    for (const PanelFacet& facet : *panel)
      for (const Vec2& p : facet.corners) {
        const Vec3 expected(40 - p.x() * std::sin(lean.radians()), p.x() * std::cos(lean.radians()),
                            5 + p.y());
        EXPECT_NEAR((facet.frame.point(p) - expected).norm(), 0.0, 1e-12 * 60) << degrees;
      }
  }
}

TEST(Panel, ThatLeansOverACurveKeepsItsForm) {
  const BezierCurve curve{{{40, 0}, {60, 20}, {50, 49}, {40, 54.5}}};
  const auto upright = slit_detail::panel_of(small_sheet(), curve),
             leans = slit_detail::panel_of(small_sheet(), curve, Angle::degrees(25));
  ASSERT_TRUE(upright && leans);
  std::vector<Vec3> before, after;
  for (std::size_t i = 0; i < upright->size(); ++i)
    for (const Vec2& p : (*upright)[i].corners) {
      before.push_back((*upright)[i].frame.point(p));
      after.push_back((*leans)[i].frame.point(p));
    }
  for (std::size_t i = 0; i < before.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_NEAR((before[i] - before[j]).norm(), (after[i] - after[j]).norm(), 1e-12 * 60);
    // The curve's ends lie on z from (40, 0) to (40, 54.5): the turn keeps z.
    EXPECT_NEAR(before[i].z(), after[i].z(), 1e-12 * 60);
  }
}

TEST(Panel, AtTheFarEndHasItsFreeEdgeOnTheGround) {
  const SecondPanel second{{{{-70, 5}, {-70, 65}}}, 80, Angle::degrees(30), false};
  const auto panel = slit_detail::second_panel_of(small_sheet(), second);
  ASSERT_TRUE(panel) << panel.error().message;
  for (const PanelFacet& facet : *panel) {
    EXPECT_EQ(facet.corners[1].x(), facet.strip == 1 ? 130.0 : 150.0);
    for (const Vec2& p : facet.corners) {
      const double up = 230 - p.x();  // from the free edge, at 50 + 100 + 80
      // Away from its front, which faces −x.
      const Vec3 expected(-70 + up * std::sin(second.lean.radians()),
                          up * std::cos(second.lean.radians()), 5 + p.y());
      EXPECT_NEAR((facet.frame.point(p) - expected).norm(), 0.0, 1e-12 * 230);
    }
  }
}

TEST(Panel, FitsItsLegCurveToTheSheet) {
  const auto straight = slit_detail::fitted(small_sheet(), {{{10, 5}, {10, 25}}},
                                            slit_detail::PanelAt::start, "");
  ASSERT_TRUE(straight) << straight.error().message;
  EXPECT_NEAR((straight->poles[0] - Vec2(10, 5)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((straight->poles[1] - Vec2(10, 65)).norm(), 0.0, 1e-10);

  const BezierCurve curve{{{4, 1}, {9, 3}, {5, 8}, {4, 11}}};
  const auto scaled = slit_detail::fitted(small_sheet(), curve, slit_detail::PanelAt::start, "");
  ASSERT_TRUE(scaled) << scaled.error().message;
  const double scale = (scaled->poles[3] - scaled->poles[0]).norm() / 10.0;
  for (std::size_t i = 0; i < curve.poles.size(); ++i)
    EXPECT_NEAR((scaled->poles[i] - (Vec2(4, 1) + scale * (curve.poles[i] - Vec2(4, 1)))).norm(),
                0.0, 1e-12 * 60);
  const auto panel = slit_detail::panel_of(small_sheet(), *scaled);
  ASSERT_TRUE(panel) << panel.error().message;
  const Vec3 last = panel->back().frame.point(panel->back().corners[3]);
  EXPECT_NEAR((Vec2(last.x(), last.z()) - scaled->poles[3]).norm(), 0.0, 1e-8);
  const auto again = slit_detail::fitted(small_sheet(), *scaled, slit_detail::PanelAt::start, "");
  ASSERT_TRUE(again);
  EXPECT_EQ(again->poles, scaled->poles);
}

}  // namespace
}  // namespace planish::test
