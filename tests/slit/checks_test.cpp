#include "sample_sheets.hpp"
#include "support/error_data.hpp"

#include <planish/slit/codes.hpp>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

// Each refusal with its code, its place in the file, and numbers in its message.

namespace planish::test {
namespace {

void expect_refused(const SlitDesign& design, ErrorCode code, const std::string& where,
                    const std::string& in_message = "") {
  const auto session = SlitSession::start(design);
  ASSERT_FALSE(session) << "started, but " << code_name(code) << " was due at " << where;
  EXPECT_EQ(code_name(session.error().code), code_name(code)) << session.error().message;
  EXPECT_EQ(session.error().where, where) << session.error().message;
  EXPECT_NE(session.error().message.find(in_message), std::string::npos) << session.error().message;
  EXPECT_TRUE(is_told(session.error())) << session.error().message;
  EXPECT_FALSE(pointers_in(session.error()).empty()) << session.error().message;
}

template <typename Change>
void expect_chair_refused(const Change& change, ErrorCode code, const std::string& where,
                          const std::string& in_message = "") {
  SlitDesign design = chair();
  change(design);
  expect_refused(design, code, where, in_message);
}

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

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

TEST(SlitRefuses, AnchorsOnMissingStripsAndRidges) {
  const Vec3 at(180, 450, 30);
  expect_chair_refused(
      [&](SlitDesign& d) {
        d.anchors = {{0, 5, StripEdge::left, at}, {6, 5, StripEdge::left, at}};
      },
      code::unknown_strip, "/anchors/1/strip", "6");
  expect_chair_refused(
      [&](SlitDesign& d) {
        d.anchors = {{-1, 5, StripEdge::left, at}};
      },
      code::unknown_strip, "/anchors/0/strip");
  expect_chair_refused(
      [&](SlitDesign& d) {
        d.anchors = {{0, 11, StripEdge::left, at}};
      },
      code::unknown_ridge, "/anchors/0/ridge", "11");
  expect_chair_refused(
      [&](SlitDesign& d) {
        d.anchors = {{0, 5, StripEdge::left, {kNan, 0, 0}}};
      },
      code::invalid_input, "/anchors/0/at");
}

TEST(SlitRefuses, AnchorsOutOfReachSayingHowFar) {
  // From (360, 420, 0) up by 200 and on to the plane 360 away: 560 of 464 mm.
  expect_chair_refused(
      [](SlitDesign& d) {
        d.anchors = {{0, 5, StripEdge::left, {360, 620, 0}}};
      },
      code::out_of_reach, "/anchors/0/at", "96 mm");
  // The ridge on the panel does not move.
  expect_chair_refused(
      [](SlitDesign& d) {
        d.anchors = {{0, 0, StripEdge::left, {360, 423, 0}}};
      },
      code::out_of_reach, "/anchors/0/at", "3 mm");
  SlitSession session = started(chair());
  SlitDesign design = session.design();
  design.anchors = {{0, 5, StripEdge::left, {360, 620, 0}}};
  EXPECT_EQ(session.set_design(design).error().code, code::out_of_reach);
  EXPECT_TRUE(session.design().anchors.empty());
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

TEST(SlitRefuses, EndsThatCannotBePlaced) {
  SlitDesign design = chair();
  design.ends = {{.position = Vec3(0, 400, 30)}};
  expect_refused(design, code::bad_option, "/ends/0");
  design = asymmetric();
  design.ends[0].position = Vec3(-250, 200, 30);
  expect_refused(design, code::out_of_reach, "/ends/0/position");
  design = asymmetric();
  design.ends[2].direction = Vec3::Zero();
  expect_refused(design, code::invalid_input, "/ends/2/direction");
  design = asymmetric();
  design.ends[2].across = Vec3(1, 0, 1);
  expect_refused(design, code::invalid_input, "/ends/2/across", "135");
  design = asymmetric();
  design.ends.resize(7);
  design.ends[6].direction = Vec3(1, 0, 0);
  expect_refused(design, code::unknown_strip, "/ends/6");
}

TEST(SlitRefusesAsData, StripsAndRidgesFromZeroThatSentencesCountFromOne) {
  SlitDesign design = chair();
  design.anchors = {{2, 11, StripEdge::left, {180, 450, 30}}};
  const Error error = SlitSession::start(design).error();
  EXPECT_EQ(error.places[0], place::strip(2));
  EXPECT_EQ(error.places[1], place::ridge(11));
  EXPECT_EQ(pointers_in(error), std::vector<std::string>{"/anchors/0/ridge"});
  EXPECT_EQ(number_in(error, "last"), 10.0) << "as files count";
  EXPECT_EQ(number_in(error, "count"), 11.0);
  EXPECT_TRUE(error.message.starts_with("Strip 3 has no ridge 12:")) << error.message;
}

TEST(SlitRefusesAsData, AnAnchorOutOfReachWithItsPlaceAndDistances) {
  SlitDesign design = chair();
  design.anchors = {{0, 5, StripEdge::left, {360, 620, 0}}};
  const Error error = SlitSession::start(design).error();
  EXPECT_EQ(at_in(error, PlaceKind::point), (std::vector<double>{360, 620, 0}));
  EXPECT_NEAR(number_in(error, "missing"), 96.0, 1e-9);
  EXPECT_NEAR(number_in(error, "needed"), 560.0, 1e-9);
  EXPECT_NEAR(number_in(error, "available"), 464.0, 1e-9);
  EXPECT_EQ(unit_in(error, "missing"), "mm");
  EXPECT_EQ(ids_in(error, PlaceKind::strip), std::vector<std::string>{"1"});
  EXPECT_EQ(error.remedies.size(), 1u);
}

}  // namespace
}  // namespace planish::test
