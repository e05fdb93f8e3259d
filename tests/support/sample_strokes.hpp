#pragma once

#include <planish/brake/plan.hpp>

namespace planish::test {

/// A stroke that presses B1 of `planned_report`, its gauge on the edge at x = 100.
inline Stroke stroke_at_40() {
  Stroke stroke;
  stroke.bends = {BendId{0}};
  stroke.angle = Angle::degrees(90);
  stroke.punch = "P88";
  stroke.die = "V16";
  stroke.punch_rows = {{5.08, {40.0, 15.0}}};
  stroke.die_rows = {{0.0, {55.0}}};
  stroke.to_gauge = FlangeId{1};
  stroke.gauge_direction = Vec2::UnitX();
  stroke.gauge = GaugeStop{60.0, {{100, 0}, {100, 60}}};
  stroke.gauge->touched = stroke.gauge->line = 60.0;
  stroke.force = 12.34;
  stroke.clearance = 2.54;
  return stroke;
}

/// One that presses B2 with the sheet turned over and about, its gauge on the edge at x = 0.
inline Stroke stroke_at_20() {
  Stroke stroke = stroke_at_40();
  stroke.bends = {BendId{1}};
  stroke.angle = Angle::degrees(30);
  stroke.reference_up = false;
  stroke.to_gauge = FlangeId{2};
  stroke.gauge_direction = -Vec2::UnitX();
  stroke.gauge = GaugeStop{20.0, {{0, 60}, {0, 0}}};
  return stroke;
}

}  // namespace planish::test
