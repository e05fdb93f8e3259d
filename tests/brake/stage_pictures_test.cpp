#include "stroke_room.hpp"

#include <planish/brake/stage_pictures.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace planish::test {
namespace {

using std::numbers::pi;

double area_of(const std::vector<ToolProfile>& sections) {
  double area = 0.0;
  for (const ToolProfile& section : sections)
    area += std::abs(ring_area(section));
  return area;
}

struct Planned {
  Sheet sheet;
  FlatSheet flat;
  BrakeTools tools;
  Plan plan;
  std::vector<StrokePicture> pictures;
};

Planned planned(Sheet sheet) {
  Planned made{std::move(sheet), {}, plain_tools(), {}, {}};
  made.flat = *flat_sheet(made.sheet);
  auto plan = plan_bending(made.sheet, made.flat.layout, made.tools);
  EXPECT_TRUE(plan) << (plan ? "" : plan.error().message);
  if (!plan) return made;
  made.plan = std::move(*plan);
  made.pictures = stroke_pictures(made.sheet, made.flat.layout, made.tools, {}, made.plan);
  return made;
}

TEST(StrokePictures, ShowTheSheetBeforeAndAfter) {
  // Flanges of 50 and 30 to the bend of inside radius 3 in 2 mm at K = 0.44.
  const Planned made = planned(l_bracket());
  ASSERT_EQ(made.pictures.size(), 1u);
  const StrokePicture& picture = made.pictures[0];
  const double allowance = pi / 2 * (3.0 + 0.44 * 2.0);
  // Flat: the whole width times the thickness. Bent: the arc has its own area.
  EXPECT_NEAR(area_of(picture.lying), 2.0 * (80.0 + allowance), 1e-6);
  EXPECT_NEAR(area_of(picture.bent), 2.0 * (80.0 + pi / 2 * 4.0), 0.05);
  // Both sides rise at 45° from the middle of the bend, whose inside is lowest at the origin.
  double left = 0.0, right = 0.0, lowest = 0.0;
  for (const ToolProfile& section : picture.bent)
    for (const Vec2& p : section) {
      left = std::min(left, p.x());
      right = std::max(right, p.x());
      lowest = std::min(lowest, p.y());
    }
  const double across = 5.0 * std::sqrt(0.5);  // of the outer end of the arc
  const double longer = across + 50.0 * std::sqrt(0.5), shorter = across + 30.0 * std::sqrt(0.5);
  EXPECT_NEAR(std::max(-left, right), longer, 1e-6);
  EXPECT_NEAR(std::min(-left, right), shorter, 1e-6);
  EXPECT_NEAR(lowest, -2.0, 0.02);
}

TEST(StrokePictures, LeaveTheDieBelowTheSheet) {
  const Planned made = planned(l_bracket());
  ASSERT_EQ(made.pictures.size(), 1u);
  const StrokePicture& picture = made.pictures[0];
  double top = -HUGE_VAL;
  for (const Vec2& p : picture.die)
    top = std::max(top, p.y());
  // Before the stroke the sheet lies on the die, its lower skin at −2.
  EXPECT_NEAR(top + picture.die_drop, -2.0, 1e-6);
  EXPECT_GT(top, -2.0);  // the sheet sinks into the V
  for (const Vec2& p : picture.punch)
    EXPECT_GE(p.y(), -1e-9);
}

TEST(StrokePictures, ShowWhatTouchesTheSheet) {
  Planned made = planned(l_bracket());
  made.tools.machine.gauge = BackGauge{10, 300, 30, {{0, 0}, {0, -20}, {80, -20}, {80, 0}}};
  made.tools.machine.gauge->nose = GaugeNose{10, {{0, 0}, {0, -3}, {6, 2}}};
  Stroke& stroke = made.plan.strokes[0];
  const auto finger = [&] {
    return stroke_pictures(made.sheet, made.flat.layout, made.tools, {}, made.plan)[0].finger;
  };
  stroke.gauge = GaugeStop{25.0, {}, 4.0};
  EXPECT_EQ(finger(), (ToolProfile{{25, 4}, {25, -16}, {105, -16}, {105, 4}}));
  stroke.gauge = GaugeStop{25.0, {}};
  stroke.gauge->by_nose = true;
  EXPECT_EQ(finger(), (ToolProfile{{25, 0}, {25, -3}, {31, 2}}));
  stroke.gauge.reset();
  EXPECT_TRUE(finger().empty());
}

}  // namespace
}  // namespace planish::test
