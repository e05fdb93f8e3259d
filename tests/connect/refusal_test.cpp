#include "sample_plates.hpp"

#include <planish/connect/connect.hpp>

#include <gtest/gtest.h>

#include <string>

// Each refusal with its code, its place in the file, and numbers in its message.

namespace planish::test {
namespace {

void expect_refused(const PlateStructure& structure, ErrorCode code, const std::string& where,
                    const std::string& in_message = "") {
  const auto c = connect(structure);
  ASSERT_FALSE(c) << "joined, but " << code_name(code) << " was due";
  EXPECT_EQ(code_name(c.error().code), code_name(code)) << c.error().message;
  EXPECT_EQ(c.error().where, where) << c.error().message;
  EXPECT_NE(c.error().message.find(in_message), std::string::npos) << c.error().message;
}

TEST(ConnectRefuses, OutlinesThatAreNone) {
  PlateStructure s = angle_pair(14.0);
  s.plates[1].outline.resize(2);
  expect_refused(s, ErrorCode::too_few_corners, "/plates/1/outline", "2");
  s = angle_pair(14.0);
  s.plates[0].outline[2] = s.plates[0].outline[1];
  expect_refused(s, ErrorCode::repeated_corner, "/plates/0/outline/2", "corners 1 and 2");
  s = angle_pair(14.0);
  s.plates[0].outline[2].z() = 0.5;
  const auto c = connect(s);
  ASSERT_FALSE(c);
  EXPECT_EQ(c.error().code, ErrorCode::not_planar);
  EXPECT_EQ(c.error().where.rfind("/plates/0/outline/", 0), 0u) << c.error().where;
  s = angle_pair(14.0);
  std::swap(s.plates[0].outline[1], s.plates[0].outline[2]);
  s.plates[0].outline[3] += Vec3(0, 5, 0);
  expect_refused(s, ErrorCode::self_crossing, "/plates/0/outline");
  s = angle_pair(14.0);
  s.plates[0].holes = {{{10, 10, 0}, {300, 10, 0}, {20, 30, 0}}};
  expect_refused(s, ErrorCode::invalid_input, "/plates/0/holes/0/1", "outside");
}

TEST(ConnectRefuses, NumbersThatMakeNoSense) {
  PlateStructure s = angle_pair(14.0);
  s.thickness = 0.0;
  expect_refused(s, ErrorCode::invalid_input, "/thickness");
  s = angle_pair(14.0);
  s.bends = {{.between = {"A", "B"}, .trade_off = -1.0}};
  expect_refused(s, ErrorCode::invalid_input, "/bends/0/trade_off");
  s.bends = {{.between = {"A", "B"}, .surface = SurfaceChoice::cylinder, .slope = 0.1}};
  expect_refused(s, ErrorCode::invalid_input, "/bends/0/surface");
}

TEST(ConnectRefuses, PlatesAndEdgesThatDoNotExist) {
  PlateStructure s = angle_pair(14.0);
  s.bends = {{.between = {"A", "C"}}};
  expect_refused(s, ErrorCode::unknown_plate, "/bends/0/between/1", "A, B");
  s.bends = {{.between = {"A", "B"}, .edges = {std::vector{2, 7}}}};
  expect_refused(s, ErrorCode::unknown_edge, "/bends/0/edges/A/1", "0 to 3");
  s.bends = {{.between = {"A", "B"}, .edges = {std::vector{0, 2}}}};
  expect_refused(s, ErrorCode::unknown_edge, "/bends/0");
  s = angle_pair(14.0);
  s.root = "X";
  expect_refused(s, ErrorCode::unknown_plate, "/root");
}

TEST(ConnectRefuses, LoopsAndPlatesLeftAlone) {
  PlateStructure s = tray();
  s.bends = {{.between = {"floor", "front"}}, {.between = {"floor", "left"}}, {.between = {"front", "left"}}};
  expect_refused(s, ErrorCode::bend_loop, "/bends/2", "front");
  s.bends.pop_back();
  expect_refused(s, ErrorCode::not_connected, "/bends", "back");
}

TEST(ConnectRefuses, PlatesThatPassThroughEachOther) {
  PlateStructure s = angle_pair(14.0);
  s.plates[1] = rectangle_plate("B", {50, 50, -30}, {100, 0, 0}, {0, 0, 100});
  expect_refused(s, ErrorCode::plates_intersect, "/plates/1", "\"A\" and \"B\"");
  s.plates[1] = rectangle_plate("B", {50, 50, 0}, {300, 0, 0}, {0, 100, 0});
  expect_refused(s, ErrorCode::plates_intersect, "/plates/1");
}

TEST(ConnectRefuses, PlatesThatTouchOrAreTooNear) {
  expect_refused(angle_pair(0.0), ErrorCode::plates_touch, "/plates/1", "gap");
  expect_refused(angle_pair(1.0), ErrorCode::radius_too_small, "/plates/1", "4 mm");
  PlateStructure s = angle_pair(1.0);
  s.bends = {{.between = {"A", "B"}}};
  expect_refused(s, ErrorCode::radius_too_small, "/bends/0");
}

TEST(ConnectRefuses, PlatesInOnePlaneOrBesideEachOther) {
  PlateStructure s = angle_pair(14.0);
  s.plates[1] = rectangle_plate("B", {0, 120, 0}, {200, 0, 0}, {0, 100, 0});
  s.bends = {{.between = {"A", "B"}}};
  expect_refused(s, ErrorCode::plates_coplanar, "/bends/0");
  s.plates[1] = rectangle_plate("B", {250, 120, 30}, {200, 0, 0}, {0, 100, 0});
  expect_refused(s, ErrorCode::plates_offset, "/bends/0", "30 mm");
}

TEST(ConnectRefuses, ValuesThatDoNotFitAndSaysWhichDo) {
  PlateStructure s = cone_pair(0.2, 200, 500);
  s.bends = {{.between = {"A", "B"}, .slope = 0.5}};
  expect_refused(s, ErrorCode::no_bend_fits, "/bends/0/slope", "0.333333");
  s.bends = {{.between = {"A", "B"}, .aperture = Angle::degrees(80)}};
  expect_refused(s, ErrorCode::no_bend_fits, "/bends/0/aperture", "up to");
  s.bends = {{.between = {"A", "B"}, .inside_radii = std::array{10.0, 400.0}}};
  expect_refused(s, ErrorCode::no_bend_fits, "/bends/0/inside_radii");
  s.bends = {{.between = {"A", "B"}, .inside_radius = 200.0}};
  expect_refused(s, ErrorCode::no_bend_fits, "/bends/0/inside_radius", "38.5");
}

TEST(ConnectRefuses, AnApexWithinTheEdges) {
  PlateStructure s = cone_pair(0.2, 200, 500);
  const auto free = connect(s);
  ASSERT_TRUE(free);
  const BendFrame& frame = free->bends[0].frame;
  const double inside = frame.local(0, {350, 0, 0}).x();
  s.bends = {{.between = {"A", "B"}, .apex = inside}};
  expect_refused(s, ErrorCode::apex_in_span, "/bends/0/apex");
}

TEST(ConnectRefuses, SectionsThatSayTooLittle) {
  PlateStructure s;
  s.thickness = 2.0;
  s.bends = {{.inside_radius = 20.0, .length = 100.0}};
  expect_refused(s, ErrorCode::invalid_input, "/bends/0/angle");
  s.bends = {{.inside_radius = 20.0, .angle = Angle::degrees(90)}};
  expect_refused(s, ErrorCode::invalid_input, "/bends/0/length");
  s.plates = {rectangle_plate("A", {0, 0, 0}, {200, 0, 0}, {0, 100, 0})};
  s.bends = {{.between = {"A"}, .inside_radius = 20.0, .angle = Angle::degrees(90)}};
  expect_refused(s, ErrorCode::invalid_input, "/bends/0/edges");
}

}  // namespace
}  // namespace planish::test
