#include <planish/slit/slit_sheet.hpp>

#include <gtest/gtest.h>

namespace planish::test {
namespace {

SlitSheet three_strips() {
  SlitSheet sheet;
  sheet.thickness = 2.0;
  sheet.min_inside_radius = 3.0;
  sheet.panel_height = 100.0;
  sheet.half_length = 50.0;
  sheet.strips = {{.width = 20, .gap = 5},
                  {.width = 10, .left_start = 90, .end = 170},
                  {.width = 15, .gap = 7, .right_start = 110}};
  sheet.margin = 3.0;
  return sheet;
}

TEST(SlitSheet, AddsUpItsStripsGapsAndMargin) {
  const SlitSheet sheet = three_strips();
  EXPECT_DOUBLE_EQ(sheet.width(), 5 + 20 + 10 + 7 + 15 + 3.0);
  EXPECT_DOUBLE_EQ(sheet.left_of(0), 5.0);
  EXPECT_DOUBLE_EQ(sheet.left_of(1), 25.0);
  EXPECT_DOUBLE_EQ(sheet.left_of(2), 42.0);
}

TEST(SlitSheet, BeginsAndEndsStripsByDefaultAtThePanelAndTheHalfLength) {
  const SlitSheet sheet = three_strips();
  EXPECT_EQ(sheet.start_of(0), (std::array{100.0, 100.0}));
  EXPECT_EQ(sheet.start_of(1), (std::array{90.0, 100.0}));
  EXPECT_EQ(sheet.start_of(2), (std::array{100.0, 110.0}));
  EXPECT_DOUBLE_EQ(sheet.end_of(0), 150.0);
  EXPECT_DOUBLE_EQ(sheet.end_of(1), 170.0);
  EXPECT_DOUBLE_EQ(sheet.reach(), 170.0);
}

TEST(SlitSheet, CountsRadiiInTheMiddleOfTheThickness) {
  EXPECT_DOUBLE_EQ(three_strips().min_radius(), 4.0);
}

TEST(EqualStrips, LieSideBySide) {
  const std::vector<SlitStrip> strips = equal_strips(3, 12.5);
  ASSERT_EQ(strips.size(), 3u);
  for (const SlitStrip& strip : strips)
    EXPECT_EQ(strip, SlitStrip{.width = 12.5});
  EXPECT_TRUE(equal_strips(-1, 10.0).empty());
}

TEST(SlitSheet, StopsAtStripsThatItDoesNotHave) {
  const SlitSheet sheet = three_strips();
  for (const int strip : {-1, 3, 99}) {
    EXPECT_DEATH((void)sheet.left_of(strip), "has_strip");
    EXPECT_DEATH((void)sheet.start_of(strip), "has_strip");
    EXPECT_DEATH((void)sheet.end_of(strip), "has_strip");
  }
}

}  // namespace
}  // namespace planish::test
