#pragma once

#include <planish/slit/session.hpp>

#include <gtest/gtest.h>

namespace planish::test {

/// The chair of formats.md#slits: six strips, a straight leg, a seat that rises to a back.
inline SlitDesign chair() {
  SlitDesign design;
  design.sheet.thickness = 4.0;
  design.sheet.panel_height = 420.0;
  design.sheet.half_length = 464.0;
  design.sheet.strips = equal_strips(6, 60.0);
  design.leg_curve = {{{360, 0}, {360, 120}, {360, 240}, {360, 360}}};
  design.seat_curve = BezierCurve{{{330, 0}, {300, 120}, {310, 240}, {640, 360}}};
  return design;
}

/// Strips of different widths, lengths and starts over a curved leg, with free ends: one placed and
/// directed, one placed, one directed, one left alone.
inline SlitDesign asymmetric() {
  SlitDesign design;
  design.sheet.thickness = 1.5;
  design.sheet.panel_height = 200.0;
  design.sheet.half_length = 300.0;
  design.sheet.symmetric = false;
  design.sheet.strips = {{.width = 40, .gap = 10},
                         {.width = 30, .left_start = 200, .right_start = 230, .end = 560},
                         {.width = 25, .gap = 5, .left_start = 230, .right_start = 215},
                         {.width = 35, .end = 480}};
  design.sheet.margin = 12.0;
  design.leg_curve = {{{100, 0}, {125, 55}, {118, 110}, {92, 150}}};
  design.ends.resize(3);
  design.ends[0].position = Vec3(-110, 240, 30);
  design.ends[0].direction = Vec3(-1, -0.2, 0.1);
  design.ends[1].position = Vec3(-120, 330, 70);
  design.ends[2].direction = Vec3(-1, 0, 0);
  return design;
}

inline SlitSession started(const SlitDesign& design) {
  auto session = SlitSession::start(design);
  if (!session) throw std::runtime_error(session.error().message + " at " + session.error().where);
  return std::move(*session);
}

inline SlitSession solved(const SlitDesign& design, int subdivisions = 0) {
  auto session = solved_slit_sheet(design, subdivisions);
  if (!session) throw std::runtime_error(session.error().message + " at " + session.error().where);
  return std::move(*session);
}

/// Two equal panels 600 apart, strips of 1000 between them.
inline SlitDesign arcade() {
  SlitDesign design;
  design.sheet.thickness = 2.0;
  design.sheet.panel_height = 200.0;
  design.sheet.half_length = 1000.0;
  design.sheet.symmetric = false;
  design.sheet.strips = equal_strips(3, 60.0);
  design.leg_curve = {{{300, 0}, {300, 180}}};
  design.second_panel = SecondPanel{{{{-300, 0}, {-300, 180}}}, 200.0, {}, false};
  return design;
}

/// Two strips on a straight leg that end at the symmetry plane.
inline SlitDesign small_chair() {
  SlitDesign design = chair();
  design.sheet.strips = equal_strips(2, 60.0);
  design.leg_curve = {{{360, 0}, {360, 120}}};
  design.seat_curve.reset();
  return design;
}

}  // namespace planish::test
