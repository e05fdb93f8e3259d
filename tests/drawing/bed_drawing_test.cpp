#include "bend_drawing.hpp"
#include "drawing/planned_pages.hpp"

#include <planish/geometry/interval.hpp>
#include <planish/geometry/plane.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace planish::drawing {
namespace {

class BedDrawing : public PlannedPages {
 protected:
  void SetUp() override {
    take(test::u_channel());
    plan_.stations = {{0, "P88", "V16", {{100.0, {40.0, 15.0}}}, {{90.0, {60.0}}}, {0}},
                      {1, "F180", "F180", {{200.0, {100.0}}}, {{200.0, {100.0}}}, {1}}};
    bed_ = 1860.0;  // ten times the width of a page
  }
};

TEST_F(BedDrawing, SaysWhatStandsWhereInEachSetUp) {
  const auto drawn = pages();
  EXPECT_EQ(
      times(drawn, "Set-up 1 on the bed of 1860 mm, from your left (drawn where tools stand)"), 1);
  EXPECT_EQ(
      times(drawn, "Set-up 2 on the bed of 1860 mm, from your left (drawn where tools stand)"), 1);
  EXPECT_EQ(times(drawn, "A  punch P88: 40 + 15 from 100.0; die V16: 60 from 90.0; stroke 1"), 1);
  EXPECT_EQ(times(drawn, "B  punch F180: 100 from 200.0; die F180: 100 from 200.0; stroke 2"), 1);
}

/// 30 segments take more than one line, in letters that can be read.
TEST_F(BedDrawing, WrapsALongListOfSegments) {
  plan_.stations[0].punch_rows[0].segments.assign(30, 100.0);
  bed_ = 4000.0;
  std::size_t found = 0;
  for (const Page& page : pages())
    for (const Page::Text& text : page.texts())
      for (std::size_t at = 0; (at = text.text.find("100", at)) != std::string::npos; ++at) {
        ++found;
        EXPECT_GT(text.style.size, 2.5) << text.text;
      }
  EXPECT_GE(found, 30u);
}

/// Segments are drawn to scale, 12 mm from the edge of the page: of the bed a fifth about the
/// tools, half as large here, from its end and from 64 mm on.
TEST_F(BedDrawing, DrawsSegmentsToScale) {
  std::vector<Interval> found;
  for (const Page& page : pages())
    for (const Page::Shape& shape : page.shapes())
      for (const auto& ring : shape.lines)
        if (const Box2 box = box_of(ring); std::abs(box.hi.y() - box.lo.y() - 4.0) < 1e-9)
          found.push_back({box.lo.x(), box.hi.x()});
  const auto has = [&](double lo, double hi) {
    return std::ranges::any_of(found, [&](const Interval& one) {
      return std::abs(one.lo - lo) < 1e-9 && std::abs(one.hi - hi) < 1e-9;
    });
  };
  EXPECT_TRUE(has(62.0, 82.0) && has(82.0, 89.5)) << "the punch's segments";
  EXPECT_TRUE(has(57.0, 87.0)) << "the die's";
  EXPECT_TRUE(has(80.0, 130.0)) << "of the second set-up";
}

TEST(StationName, IsALetter) {
  EXPECT_EQ(station_name(0), "A");
  EXPECT_EQ(station_name(25), "Z");
  EXPECT_EQ(station_name(26), "A1");
}

}  // namespace
}  // namespace planish::drawing
