#include "drawing/planned_pages.hpp"

#include <planish/geometry/plane.hpp>
#include <planish/geometry/region.hpp>
#include <planish/schema/units.hpp>

#include <cmath>
#include <numbers>

namespace planish::drawing {
namespace {

using namespace planish::test;
using schema::Units;

using BendFlat = PlannedPages;

TEST_F(BendFlat, NameEachFlangeInItsMiddle) {
  const Sheet channel = u_channel();
  const FlatSheet flat = *flat_sheet(channel);
  const auto names = flange_names(channel, flat.layout);
  ASSERT_EQ(names.size(), 3U);
  for (std::size_t i = 0; i < names.size(); ++i) {
    EXPECT_EQ(names[i].name, "F" + std::to_string(i + 1));
    const FaceId face = channel[FlangeId{static_cast<int>(i)}].faces.front();
    const auto ring = sampled(flat.layout.outline(face), 0.1);
    // Rectangles of 30 and 40 by 25: half the shorter side is the most that goes.
    EXPECT_TRUE(inside({ring}, names[i].at));
    EXPECT_NEAR(distance_to_ring(ring, names[i].at), 12.5, 1e-6);
  }
  take(channel);
  flanges_ = names;
  for (const char* name : {"F1", "F2", "F3"})
    EXPECT_EQ(times(pages(), name), 1) << name;
}

TEST_F(BendFlat, DimensionLinesThatAreToBeMarked) {
  take(l_bracket());
  const FlatBend& bend = flat_.pattern.bends[0];
  const Box2 box = bounds(flat_.pattern.outer.loop);
  const Segment& line = bend.lines.front();
  const bool level = std::abs(line.b.y() - line.a.y()) < 1e-9;
  const double away = level ? line.a.y() - box.lo.y() : line.a.x() - box.lo.x();
  const std::string distance = Units(LengthUnit::mm).short_text(away);
  EXPECT_EQ(times(pages(), distance), 1) << "there is no gauge";
  plan_.strokes[0].gauge = GaugeStop{20.0, line};
  EXPECT_EQ(times(pages(), distance), 0);
}

/// Of a line that lies askew the two ends are told, from the corner of what is drawn.
TEST_F(BendFlat, TellTheEndsOfLinesAskew) {
  take(l_bracket());
  FlatBend& bend = flat_.pattern.bends[0];
  const Vec2 corner = bounds(flat_.pattern.outer.loop).lo;
  bend.lines = {{corner + Vec2(10.0, 0.0), corner + Vec2(20.5, 25.0)}};
  EXPECT_EQ(times(pages(), "1: from (10.0, 0.0) to (20.5, 25.0)"), 1);
  EXPECT_EQ(times(pages(LengthUnit::inch), "1: from (0.394, 0.000) to (0.807, 0.984)"), 1);
  plan_.strokes[0].gauge = GaugeStop{20.0, bend.lines.front()};
  EXPECT_EQ(times(pages(), "1: from (10.0, 0.0) to (20.5, 25.0)"), 0);
}

/// A square stands on its corner: it is a blank of 10 by 10, and √2 times as wide as it is drawn.
TEST_F(BendFlat, TellExtentsAsDrawnFromTheBlank) {
  const auto drawn = [](double degrees) {
    FlatPattern flat;
    const double turn = degrees * std::numbers::pi / 180.0;
    std::vector<Vec2> corners;
    for (int i = 0; i < 4; ++i) {
      const double at = turn + i * 0.5 * std::numbers::pi;
      corners.push_back(std::sqrt(50.0) * Vec2(std::cos(at), std::sin(at)));
    }
    flat.outer.loop = polygon(corners);
    const Layout layout;
    return bend_pages({.title = "square",
                       .metal = "steel",
                       .thickness = 1.0,
                       .size = {10.0, 10.0},
                       .mass = {},
                       .flat = flat,
                       .layout = layout,
                       .blocked = {},
                       .obstacles = {},
                       .proposals = {}},
                      {});
  };
  EXPECT_EQ(times(drawn(45.0), "10.0"), 2);
  EXPECT_EQ(times(drawn(0.0), "14.1 as drawn"), 2);
}

TEST_F(BendFlat, ShowBendsThatTakeNoStroke) {
  take(u_channel());
  plan_.strokes.pop_back();
  EXPECT_EQ(times(pages(), flat_.pattern.bends[1].id), 1);
  EXPECT_EQ(times(pages(), flat_.pattern.bends[0].id), 0);
}

}  // namespace
}  // namespace planish::drawing
