#include "sample_plates.hpp"
#include "support/error_data.hpp"

#include <planish/connect/codes.hpp>
#include <planish/connect/connect.hpp>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>

// Each refusal with its code, its place in the file, and numbers in its message.

namespace planish::test {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;

void expect_refused(const PlateStructure& structure, ErrorCode code, const std::string& where,
                    const std::string& in_message = "") {
  const auto c = connect(structure);
  ASSERT_FALSE(c) << "joined, but " << code_name(code) << " was due";
  EXPECT_EQ(code_name(c.error().code), code_name(code)) << c.error().message;
  EXPECT_EQ(c.error().where, where) << c.error().message;
  EXPECT_NE(c.error().message.find(in_message), std::string::npos) << c.error().message;
  EXPECT_TRUE(is_told(c.error())) << c.error().message;
  EXPECT_THAT(pointers_in(c.error()), Contains(where)) << c.error().message;
}

Error refusal_of(const PlateStructure& structure) {
  const auto c = connect(structure);
  EXPECT_FALSE(c);
  return c ? Error{} : c.error();
}

TEST(ConnectRefuses, OutlinesThatAreNone) {
  PlateStructure s = angle_pair(14.0);
  s.plates[1].outline.resize(2);
  expect_refused(s, code::too_few_corners, "/plates/1/outline", "2");
  s = angle_pair(14.0);
  s.plates[0].outline[2] = s.plates[0].outline[1];
  expect_refused(s, code::repeated_corner, "/plates/0/outline/2", "corners 2 and 3");
  s = angle_pair(14.0);
  s.plates[0].outline[2].z() = 0.5;
  const auto c = connect(s);
  ASSERT_FALSE(c);
  EXPECT_EQ(c.error().code, code::not_planar);
  EXPECT_EQ(c.error().where.rfind("/plates/0/outline/", 0), 0u) << c.error().where;
  s = angle_pair(14.0);
  std::swap(s.plates[0].outline[1], s.plates[0].outline[2]);
  s.plates[0].outline[3] += Vec3(0, 5, 0);
  expect_refused(s, code::self_crossing, "/plates/0/outline");
  s = angle_pair(14.0);
  s.plates[0].holes = {{{10, 10, 0}, {300, 10, 0}, {20, 30, 0}}};
  expect_refused(s, code::invalid_input, "/plates/0/holes/0/1", "outside");
}

TEST(ConnectRefuses, NumbersThatMakeNoSense) {
  PlateStructure s = angle_pair(14.0);
  s.thickness = 0.0;
  expect_refused(s, code::invalid_input, "/thickness");
  s = angle_pair(14.0);
  s.bends = {{.between = {"A", "B"}, .trade_off = -1.0}};
  expect_refused(s, code::invalid_input, "/bends/0/trade_off");
  s.bends = {{.between = {"A", "B"}, .surface = SurfaceChoice::cylinder, .slope = 0.1}};
  expect_refused(s, code::invalid_input, "/bends/0/surface");
}

TEST(ConnectRefuses, PlatesAndEdgesThatDoNotExist) {
  PlateStructure s = angle_pair(14.0);
  s.bends = {{.between = {"A", "C"}}};
  expect_refused(s, code::unknown_plate, "/bends/0/between/1", "A and B");
  s.bends = {{.between = {"A", "B"}, .edges = {std::vector{2, 7}}}};
  expect_refused(s, code::unknown_edge, "/bends/0/edges/A/1", "0 to 3");
  s.bends = {{.between = {"A", "B"}, .edges = {std::vector{0, 2}}}};
  expect_refused(s, code::unknown_edge, "/bends/0");
  s = angle_pair(14.0);
  s.root = "X";
  expect_refused(s, code::unknown_plate, "/root");
}

TEST(ConnectRefuses, LoopsAndPlatesLeftAlone) {
  PlateStructure s = tray();
  s.bends = {{.between = {"floor", "front"}}, {.between = {"floor", "left"}}};
  PlateStructure corner = s;
  corner.plates = {s.plates[0], s.plates[1], s.plates[3]};
  corner.bends.push_back({.between = {"front", "left"}});
  expect_refused(corner, code::bend_loop, "/bends/2", "front");
  expect_refused(s, code::not_connected, "/bends", "back");
}

TEST(ConnectRefuses, PlatesThatPassThroughEachOther) {
  PlateStructure s = angle_pair(14.0);
  s.plates[1] = rectangle_plate("B", {50, 50, -30}, {100, 0, 0}, {0, 0, 100});
  expect_refused(s, code::plates_intersect, "/plates/1", "\"A\" and \"B\"");
  s.plates[1] = rectangle_plate("B", {50, 50, 0}, {300, 0, 0}, {0, 100, 0});
  expect_refused(s, code::plates_intersect, "/plates/1");
}

TEST(ConnectRefuses, PlatesThatTouchOrAreTooNear) {
  PlateStructure s = angle_pair(0.0);
  s.trim = false;
  expect_refused(s, code::plates_touch, "/plates/1", "gap");
  expect_refused(angle_pair(1.0), code::radius_too_small, "/plates/1", "4 mm");
  s = angle_pair(1.0);
  s.bends = {{.between = {"A", "B"}}};
  expect_refused(s, code::radius_too_small, "/bends/0");
}

TEST(ConnectRefuses, PlatesInOnePlaneOrBesideEachOther) {
  PlateStructure s = angle_pair(14.0);
  s.plates[1] = rectangle_plate("B", {0, 120, 0}, {200, 0, 0}, {0, 100, 0});
  s.bends = {{.between = {"A", "B"}}};
  expect_refused(s, code::plates_coplanar, "/bends/0");
  s.plates[1] = rectangle_plate("B", {250, 120, 30}, {200, 0, 0}, {0, 100, 0});
  expect_refused(s, code::plates_offset, "/bends/0", "30 mm");
}

TEST(ConnectRefuses, ValuesThatDoNotFitAndSaysWhichDo) {
  PlateStructure s = cone_pair(0.2, 200, 500);
  s.bends = {{.between = {"A", "B"}, .slope = 0.5}};
  // From half the thickness and the smallest radius above the line at x = 200 to the edge at x =
  // 500, y = 100.
  expect_refused(s, code::no_bend_fits, "/bends/0/slope",
                 fmt::format("{:.6g}", (100.0 - 1.501) / 300.0));
  s.bends = {{.between = {"A", "B"}, .aperture = Angle::degrees(80)}};
  expect_refused(s, code::no_bend_fits, "/bends/0/aperture", "up to");
  s.bends = {{.between = {"A", "B"}, .inside_radii = std::array{10.0, 400.0}}};
  expect_refused(s, code::no_bend_fits, "/bends/0/inside_radii");
  s.bends = {{.between = {"A", "B"}, .inside_radius = 200.0}};
  expect_refused(s, code::no_bend_fits, "/bends/0/inside_radius", "38.5");
}

TEST(ConnectRefuses, AnApexWithinTheEdges) {
  PlateStructure s = cone_pair(0.2, 200, 500);
  const auto free = connect(s);
  ASSERT_TRUE(free);
  const BendFrame& frame = free->bends[0].frame;
  const double inside = frame.local(0, {350, 0, 0}).x();
  s.bends = {{.between = {"A", "B"}, .apex = inside}};
  expect_refused(s, code::apex_in_span, "/bends/0/apex");
}

TEST(ConnectRefuses, SectionsThatSayTooLittle) {
  PlateStructure s;
  s.thickness = 2.0;
  s.bends = {{.inside_radius = 20.0, .length = 100.0}};
  expect_refused(s, code::invalid_input, "/bends/0/angle");
  s.bends = {{.inside_radius = 20.0, .angle = Angle::degrees(90)}};
  expect_refused(s, code::invalid_input, "/bends/0/length");
  s.plates = {rectangle_plate("A", {0, 0, 0}, {200, 0, 0}, {0, 100, 0})};
  s.bends = {{.between = {"A"}, .inside_radius = 20.0, .angle = Angle::degrees(90)}};
  expect_refused(s, code::invalid_input, "/bends/0/edges");
}

TEST(ConnectRefuses, HolesThatMeetTheOutlineOrEachOther) {
  const auto square = [](double x0, double x1, double y0, double y1) {
    return std::vector<Vec3>{{x0, y0, 0}, {x1, y0, 0}, {x1, y1, 0}, {x0, y1, 0}};
  };
  PlateStructure s = angle_pair(14.0);
  s.plates[0].holes = {square(20, 50, 0, 30)};
  expect_refused(s, code::self_crossing, "/plates/0/holes/0", "outline");
  for (const auto& second : {square(40, 60, 40, 60), square(30, 40, 35, 45), square(20, 50, 30, 50),
                             square(50, 80, 30, 50)}) {
    s.plates[0].holes = {square(20, 50, 30, 50), second};
    expect_refused(s, code::self_crossing, "/plates/0/holes/1", "hole 1");
  }
  s.plates[0].holes[1] = square(51, 80, 30, 50);
  EXPECT_TRUE(connect(s));
}

TEST(ConnectRefuses, AnEdgeThatTwoSectionsBegin) {
  PlateStructure s;
  s.thickness = 2.0;
  s.plates = {rectangle_plate("A", {0, 0, 0}, {200, 0, 0}, {0, 100, 0})};
  s.bends = {{.between = {"A"},
              .edges = {std::vector{0}},
              .inside_radius = 10.0,
              .angle = Angle::degrees(90)}};
  s.bends.push_back(s.bends[0]);
  expect_refused(s, code::unknown_edge, "/bends/1/edges", "another bend");
}

TEST(ConnectRefuses, ConesOfParallelPlatesAndOfSectionsWithOneRadius) {
  PlateStructure s = u_pair();
  s.bends = {{.between = {"A", "B"}, .surface = SurfaceChoice::cone}};
  expect_refused(s, code::no_bend_fits, "/bends/0/surface", "half a cylinder");
  s.bends = {{.between = {"A", "B"}, .slope = 0.1}};
  expect_refused(s, code::no_bend_fits, "/bends/0/surface");
  s.bends = {{.between = {"A", "B"}, .inside_radius = 5.0}};
  expect_refused(s, code::no_bend_fits, "/bends/0/inside_radius", "18.5");
  PlateStructure pipe;
  pipe.thickness = 2.0;
  pipe.bends = {{.surface = SurfaceChoice::cone,
                 .inside_radius = 50.0,
                 .angle = Angle::degrees(90),
                 .length = 100.0}};
  expect_refused(pipe, code::invalid_input, "/bends/0/surface", "inside_radii");
}

TEST(ConnectRefuses, PlatesWithinEachOthersThickness) {
  PlateStructure s;
  s.thickness = 2.0;
  s.plates = {rectangle_plate("A", {0, -50, 0}, {200, 0, 0}, {0, 150, 0}),
              rectangle_plate("B", {0, 0, 0.5}, {200, 0, 0}, {0, 0, 100})};
  expect_refused(s, code::plates_touch, "/plates/1", "0.5 mm apart");
}

TEST(ConnectRefuses, ARadiusOfAConeAndNamesTheNearestThatFits) {
  PlateStructure s = cone_pair();
  s.bends = {{.between = {"A", "B"}, .surface = SurfaceChoice::cone, .inside_radius = 1e4}};
  const Error refused = refusal_of(s);
  EXPECT_EQ(number_in(refused, "asked"), 1e4);
  s.bends[0].inside_radius = number_in(refused, "nearest");
  const auto fits = connect(s);
  EXPECT_TRUE(fits) << fits.error().message;
}

TEST(ConnectRefuses, ADefaultRadiusThatIsTooLarge) {
  PlateStructure s = angle_pair(14.0);  // the largest bend there has an inside radius of 12
  s.bends.clear();
  s.defaults.inside_radius = 12.5;
  expect_refused(s, code::no_bend_fits, "/defaults/inside_radius", "12.5 mm");
  s.defaults.inside_radius = 5.0;
  const auto fits = connect(s);
  ASSERT_TRUE(fits) << fits.error().message;
  EXPECT_NEAR(fits->bends.front().inside_radius, 5.0, 1e-9);
}

TEST(ConnectRefusesAsData, PlatesThatAreTooNearWithThePlaceAndTheDistances) {
  PlateStructure s;
  s.thickness = 2.0;
  s.plates = {rectangle_plate("A", {0, -50, 0}, {200, 0, 0}, {0, 150, 0}),
              rectangle_plate("B", {0, 0, 0.5}, {200, 0, 0}, {0, 0, 100})};
  const Error error = refusal_of(s);
  EXPECT_THAT(ids_in(error, PlaceKind::plate), ElementsAre("\"A\"", "\"B\""));
  EXPECT_THAT(pointers_in(error), ElementsAre("/plates/1"));
  const std::vector<double> at = at_in(error, PlaceKind::plate);
  ASSERT_EQ(at.size(), 3u);
  EXPECT_EQ(at, at_in(error, PlaceKind::point));
  EXPECT_NEAR(at[1], 0.0, 1e-9) << "on the border of B";
  EXPECT_NEAR(at[2], 0.5, 1e-9);
  EXPECT_NEAR(number_in(error, "gap"), 0.5, 1e-9);
  EXPECT_EQ(unit_in(error, "gap"), "mm");
  EXPECT_EQ(number_in(error, "thickness"), 2.0);
  ASSERT_EQ(error.remedies.size(), 1u);
  EXPECT_FALSE(error.remedies[0].change.empty());
}

TEST(ConnectRefusesAsData, CornersOfAPolygonFromOneAndTheirPlacesInTheFile) {
  PlateStructure s = angle_pair(14.0);
  s.plates[0].outline[2] = s.plates[0].outline[1];
  Error error = refusal_of(s);
  EXPECT_THAT(pointers_in(error), ElementsAre("/plates/0/outline/1", "/plates/0/outline/2"));
  EXPECT_EQ(number_in(error, "corner"), 2.0);
  EXPECT_EQ(number_in(error, "next"), 3.0);
  EXPECT_THAT(ids_in(error, PlaceKind::plate), ElementsAre("\"A\""));
  s = angle_pair(14.0);
  s.plates[0].outline[2].z() = 0.5;
  error = refusal_of(s);
  EXPECT_EQ(unit_in(error, "off"), "mm");
  EXPECT_EQ(number_in(error, "allowed"), ConnectOptions{}.planarity);
}

TEST(ConnectRefusesAsData, ARadiusWithThoseThatFit) {
  PlateStructure s = angle_pair(14.0);  // the thickness is 4, so the inside radius is 12 at most
  s.bends = {{.between = {"A", "B"}, .inside_radius = 20.0}};
  const Error error = refusal_of(s);
  EXPECT_EQ(number_in(error, "asked"), 20.0);
  EXPECT_NEAR(number_in(error, "largest"), 12.0, 1e-9);
  EXPECT_THAT(ids_in(error, PlaceKind::plate), ElementsAre("\"A\"", "\"B\""));
  EXPECT_THAT(pointers_in(error), ElementsAre("/bends/0/inside_radius"));
  ASSERT_EQ(error.remedies.size(), 1u);
  EXPECT_NE(error.remedies[0].change.find("12 mm or less"), std::string::npos);
}

TEST(ConnectRefusesAsData, ABendThatIsFoundByThePlateThatStaysAlone) {
  const Error error = refusal_of(angle_pair(1.0));
  EXPECT_EQ(error.where, "/plates/1");
  EXPECT_THAT(ids_in(error, PlaceKind::plate), ElementsAre("\"B\"", "\"A\""));
  EXPECT_THAT(pointers_in(error), ElementsAre("/plates/1"))
      << "no field of a bend nobody asked for";
  EXPECT_EQ(number_in(error, "thickness"), 4.0);
  EXPECT_FALSE(error.remedies.empty());
}

TEST(ConnectRefuses, OptionsThatMeanNothing) {
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  for (const ConnectOptions& options :
       {ConnectOptions{.k_factor = nan}, ConnectOptions{.k_factor = -1.0},
        ConnectOptions{.k_factor = inf}, ConnectOptions{.smallest_slope = nan},
        ConnectOptions{.alternatives = -1}, ConnectOptions{.planarity = inf}}) {
    const auto result = connect(angle_pair(14.0), options);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, code::bad_option);
  }
}

}  // namespace
}  // namespace planish::test
