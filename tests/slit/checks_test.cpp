#include "refused_designs.hpp"

#include <planish/slit/codes.hpp>

#include <vector>

// Each refusal with its code, its place in the file, and numbers in its message.

namespace planish::test {
namespace {

TEST(SlitRefuses, UnsoundSheets) {
  using D = SlitDesign;
  expect_chair_refused([](D& d) { d.sheet.thickness = 0; }, code::invalid_input, "/thickness");
  expect_chair_refused([](D& d) { d.sheet.panel_height = -1; }, code::invalid_input,
                       "/sheet/panel_height", "-1");
  expect_chair_refused([](D& d) { d.sheet.half_length = kNan; }, code::invalid_input,
                       "/sheet/half_length");
  expect_chair_refused([](D& d) { d.sheet.strips.clear(); }, code::invalid_input, "/sheet/strips",
                       "0 strips");
  expect_chair_refused([](D& d) { d.sheet.strips[3].width = 0; }, code::invalid_input,
                       "/sheet/strips/3/width");
  expect_chair_refused([](D& d) { d.sheet.strips[3].gap = -2; }, code::invalid_input,
                       "/sheet/strips/3/gap");
  expect_chair_refused([](D& d) { d.sheet.strips[1].end = 700; }, code::invalid_input,
                       "/sheet/strips/1/end");
  expect_chair_refused([](D& d) { d.sheet.strips[1].left_start = 900; }, code::invalid_input,
                       "/sheet/strips/1", "884");
  expect_chair_refused([](D& d) { d.ridges = 2; }, code::invalid_input, "/ridges", "2");
  expect_chair_refused([](D& d) { d.sheet.min_inside_radius = -1; }, code::invalid_input,
                       "/min_inside_radius");
}

TEST(SlitRefuses, CurvesTooShortOrTooLong) {
  using D = SlitDesign;
  expect_chair_refused(
      [](D& d) {
        d.leg_curve = {{{360, 0}, {360, 340}}};
      },
      code::curve_too_short, "/leg_curve", "20 mm too short");
  expect_chair_refused(
      [](D& d) {
        d.leg_curve = {{{360, 0}, {360, 375}}};
      },
      code::curve_too_long, "/leg_curve", "15 mm too long");
  expect_chair_refused(
      [](D& d) {
        d.seat_curve = BezierCurve{{{330, 0}, {330, 300}}};
      },
      code::curve_too_short, "/seat_curve", "300");
  expect_chair_refused([](D& d) { d.leg_curve.poles.resize(1); }, code::invalid_input,
                       "/leg_curve");
  expect_chair_refused([](D& d) { d.leg_curve.poles[2].x() = kNan; }, code::invalid_input,
                       "/leg_curve/bezier/2");
  expect_chair_refused([](D& d) { d.seat_curve->poles.assign(3, Vec2(1, 2)); }, code::invalid_input,
                       "/seat_curve");
  SlitDesign within = chair();
  within.leg_curve = {{{360, 0}, {360, 363}}};
  EXPECT_TRUE(SlitSession::start(within));
  within.leg_curve = {{{360, 0}, {360, 357}}};
  EXPECT_TRUE(SlitSession::start(within));
}

TEST(SlitRefuses, LegCurvesThatCannotStand) {
  using D = SlitDesign;
  expect_chair_refused(
      [](D& d) {
        d.leg_curve = {{{100, 0}, {-100, 300}}};
      },
      code::invalid_input, "/leg_curve", "symmetry plane");
  // A parabola x = s²/(2·1.5) has a radius of 1.5 mm at its vertex; 4 mm of thickness need 2.
  const auto tight = [](D& d) {
    d.leg_curve = {{{360 + 900 / 3.0, -30}, {360 - 900 / 3.0, 0}, {360 + 900 / 3.0, 30}}};
  };
  expect_chair_refused(tight, code::radius_too_small, "/leg_curve", "1.5 mm");
}

TEST(SlitRefuses, NegativeWeights) {
  using D = SlitDesign;
  expect_chair_refused([](D& d) { d.weights.smooth = -0.1; }, code::invalid_input,
                       "/weights/smooth", "-0.1");
  expect_chair_refused([](D& d) { d.weights.seat = kNan; }, code::invalid_input, "/weights/seat");
  SlitSession session = started(chair());
  SlitDesign design = session.design();
  design.weights.scan = -1;
  EXPECT_EQ(session.set_design(design).error().where, "/weights/scan");
}

TEST(SlitRefuses, ScansEmptyOrHuge) {
  expect_chair_refused(
      [](SlitDesign& d) {
        d.scans = {{0, {}}};
      },
      code::empty_scan, "/scan/0/points");
  expect_chair_refused(
      [](SlitDesign& d) {
        d.scans = {{9, {Vec3::Zero()}}};
      },
      code::unknown_strip, "/scan/0/strip");
  expect_chair_refused(
      [](SlitDesign& d) {
        d.scans = {{0, std::vector<Vec3>(2'000'001, Vec3::Zero())}};
      },
      code::scan_too_large, "/scan/0/points", "2000001");
  expect_chair_refused(
      [](SlitDesign& d) {
        d.scans = {{0, {Vec3(0, kNan, 0)}}};
      },
      code::invalid_input, "/scan/0/points");
  SlitSession session = started(chair());
  EXPECT_EQ(session.align_scans().error().code, code::empty_scan);
}

}  // namespace
}  // namespace planish::test
