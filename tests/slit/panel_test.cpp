#include "panel.hpp"

#include <planish/slit/bezier.hpp>
#include <planish/slit/slit_sheet.hpp>

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace planish::test
