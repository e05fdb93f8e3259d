#pragma once

#include "brake/stroke_room.hpp"
#include "describe.hpp"
#include "gauge.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <vector>

namespace planish::test {

inline BrakeTools gauged_tools() {
  BrakeTools tools = plain_tools();
  tools.machine.gauge = BackGauge{10, 300, 30, {{0, 0}, {0, -20}, {80, -20}, {80, 0}}};
  return tools;
}

inline constexpr double kHalfZone = 0.25 * std::numbers::pi * (2.0 + 0.44 * 1.5);

/// The strokes of both ways to press the only bend, or of two with other tools.
inline std::vector<Stroke> strokes_of(const Sheet& sheet, const BrakeTools& tools,
                                      const std::vector<int>& formed = {}, int bend = 1) {
  Room room(sheet, tools);
  std::vector<Stroke> strokes;
  for (const StrokeChoice& choice : room.ways(bend, formed)) {
    strokes.push_back(describe(room.cache(), room.lines(formed), choice));
    EXPECT_EQ(strokes.back().gauge.has_value(), choice.gauged);
  }
  return strokes;
}

/// A web of 150 by 80 with a rectangular opening, and a flange of 50 to 60; where `slope` is above
/// 0 no outer edge is parallel to the bend between them. `raised`: a second flange stands on the
/// far edge of the web.
struct OpenedPart {
  double from = 40.0, deep = 30.0, wide = 40.0;  ///< of the opening
  double slope = 10.0;
  double cut = 0.0;  ///< off the far edge of the web
  bool raised = false;

  Sheet sheet() const {
    SheetBuilder builder(1.5);
    const Loop opening = reversed(
        polygon({{20, from}, {20 + wide, from}, {20 + wide, from + deep}, {20, from + deep}}));
    std::vector<Vec2> outer{{0, 0}, {80, 0}, {80 - cut, 150}, {0, 150 - slope}};
    if (cut > 0.0) outer.insert(outer.begin() + 2, {80, 140});
    const FaceId web = builder.flange(Frame{}, {polygon(outer), opening});
    const Turn turn{Angle::degrees(90), 2, BendDirection::up};
    builder.flange_behind(builder.bend(builder.rim(web, 0), turn),
                          {polygon({{0, 0}, {80, 0}, {80, 60}, {0, 50}})});
    if (raised) builder.flange_behind(builder.bend(builder.rim(web, 2), turn), {rectangle(80, 40)});
    return builder.finish();
  }
};

/// Fingers as wide as the web, whose nose dips 6 into the sheet and lies above it behind.
inline BrakeTools tools_with_nose() {
  BrakeTools tools = gauged_tools();
  tools.machine.gauge->finger_width = 60.0;
  tools.machine.gauge->nose = GaugeNose{
      10.0, {{0, 0}, {0, -3}, {6, -3}, {6, 2}, {80, 2}, {80, 20}, {0, 20}}};
  return tools;
}

}  // namespace planish::test
