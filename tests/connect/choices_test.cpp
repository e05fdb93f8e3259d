#include "sample_plates.hpp"

#include <planish/connect/connect.hpp>
#include <planish/sheet/flat_pattern.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

// Where the first choice of a bend does not work, another does.

namespace planish::test {
namespace {

double flat_area(const Connection& c, double k) {
  FlattenOptions options;
  options.allowance = ConstantK{k};
  const auto flat = flat_sheet(c.sheet, options);
  EXPECT_TRUE(flat) << (flat ? "" : flat.error().message);
  return flat ? flat->pattern.area : 0.0;
}

TEST(ConnectGoesOn, RoundTheBackWhereTheFrontHasNoRoomForTheThickness) {
  // At a right angle an inside radius above 0 needs t/2 = 2 mm to the line where the planes meet.
  // Here it is 1.9 mm, and the sheets do not run into each other.
  PlateStructure s = angle_pair(2.0, 200.0, 4.0);
  s.plates[1] = rectangle_plate("B", {0, 102, 1.9}, {200, 0, 0}, {0, 0, 100});
  const auto c = connect(s);
  ASSERT_TRUE(c) << c.error().message;
  EXPECT_EQ(c->bends[0].edge_kind, EdgeKind::averted);
}

TEST(ConnectGoesOn, ButNotWhereTheSheetsRunIntoEachOtherInFront) {
  const auto c = connect(angle_pair(1.0, 200.0, 4.0));
  ASSERT_FALSE(c);
  EXPECT_EQ(c.error().code, ErrorCode::radius_too_small);
  EXPECT_NE(c.error().message.find("choices of edges"), std::string::npos) << c.error().message;
}

TEST(ConnectGoesOn, KeepsGivenConesOnTheirEdges) {
  PlateStructure s = cone_pair(0.2, 200, 500);
  s.bends = {{.between = {"A", "B"}, .aperture = Angle::degrees(80)}};
  const auto c = connect(s);
  ASSERT_FALSE(c);
  EXPECT_EQ(c.error().code, ErrorCode::no_bend_fits);
}

TEST(ConnectFolds, PlatesThatShareAnEdge) {
  // Cut back by t/2 · tan(α/2) each, with the allowance α·K·t between.
  const double t = 2.0, k = 0.3;
  for (const double degrees : {30.0, 90.0, 140.0}) {
    const double turn = degrees * std::numbers::pi / 180.0;
    PlateStructure s;
    s.thickness = t;
    s.plates = {rectangle_plate("A", {0, 0, 0}, {100, 0, 0}, {0, 50, 0}),
                rectangle_plate("B", {0, 0, 0}, {100, 0, 0},
                                {0, -40 * std::cos(turn), 40 * std::sin(turn)})};
    s.bends = {{.between = {"A", "B"}, .inside_radius = 0.0}};
    const auto c = connect(s);
    ASSERT_TRUE(c) << c.error().message;
    EXPECT_EQ(c->bends[0].kind, BendKind::sharp);
    EXPECT_NEAR(c->bends[0].angle.degrees(), degrees, 1e-9);
    EXPECT_NEAR(flat_area(*c, k), 100.0 * (90.0 - t * std::tan(0.5 * turn) + turn * k * t), 1e-6);
  }
}

TEST(ConnectFolds, PartOfAnEdge) {
  PlateStructure s;
  s.thickness = 2.0;
  s.plates = {rectangle_plate("A", {0, 0, 0}, {100, 0, 0}, {0, 50, 0}),
              rectangle_plate("B", {20, 0, 0}, {50, 0, 0}, {0, 0, 40})};
  s.bends = {{.between = {"A", "B"}, .inside_radius = 0.0}};
  const auto c = connect(s);
  ASSERT_TRUE(c) << c.error().message;
  const double allowance = 0.5 * std::numbers::pi * 0.5 * 2.0;
  EXPECT_NEAR(c->bends[0].width, 50.0, 1e-9);
  EXPECT_NEAR(c->bends[0].joined, 50.0, 1e-9);
  EXPECT_NEAR(flat_area(*c, 0.5), 100.0 * 50.0 + 50.0 * (40.0 - 2.0 + allowance), 1e-6);
}

TEST(ConnectFolds, BothWaysFromCornerToCorner) {
  PlateStructure s;
  s.thickness = 2.0;
  s.defaults.inside_radius = 0.0;
  s.plates = {rectangle_plate("A", {0, 0, 0}, {100, 0, 0}, {0, 50, 0}),
              rectangle_plate("B", {0, 0, 0}, {100, 0, 0}, {0, 0, 40}),
              rectangle_plate("C", {0, 50, 0}, {100, 0, 0}, {0, 0, -30})};
  const auto c = connect(s);
  ASSERT_TRUE(c) << c.error().message;
  const double allowance = 0.5 * std::numbers::pi * 0.5 * 2.0;
  EXPECT_NEAR(flat_area(*c, 0.5), 100.0 * (120.0 + 2.0 * (allowance - 2.0)), 1e-6);
}

TEST(ConnectFolds, RefusesPlatesWithoutACommonEdge) {
  PlateStructure s = angle_pair(14.0);
  s.bends = {{.between = {"A", "B"}, .inside_radius = 0.0}};
  const auto c = connect(s);
  ASSERT_FALSE(c);
  EXPECT_EQ(c.error().code, ErrorCode::no_bend_fits);
  EXPECT_EQ(c.error().where, "/bends/0/inside_radius");
}

/// Two U-shaped plates whose legs meet on one axis.
PlateStructure window() {
  PlateStructure s;
  s.thickness = 2.0;
  Plate a{"A", {}, {}}, b{"B", {}, {}};
  for (const Vec2& p : std::vector<Vec2>{
           {0, 10}, {30, 10}, {30, 60}, {70, 60}, {70, 10}, {100, 10}, {100, 90}, {0, 90}}) {
    a.outline.emplace_back(p.x(), p.y(), 0.0);
    b.outline.emplace_back(p.x(), 0.0, p.y());
  }
  s.plates = {a, b};
  s.bends = {{.between = {"A", "B"}, .edges = {std::vector{0}, std::vector{0}}},
             {.between = {"A", "B"}, .edges = {std::vector{4}, std::vector{4}}}};
  return s;
}

TEST(ConnectLoops, ThatLieFlatAreKept) {
  const auto c = connect(window());
  ASSERT_TRUE(c) << c.error().message;
  EXPECT_EQ(c->bends.size(), 2u);
  // Legs 30 wide, webs 30 deep, quarter cylinders of mid radius 10 under both pairs of legs.
  const double plate = 100.0 * 80.0 - 40.0 * 50.0, bend = 30.0 * 0.5 * std::numbers::pi * 10.0;
  EXPECT_NEAR(flat_area(*c, 0.5), 2.0 * (plate + bend), 1e-6);
  FlattenOptions options;
  const auto flat = flat_sheet(c->sheet, options);
  ASSERT_TRUE(flat);
  EXPECT_EQ(flat->pattern.openings.size(), 1u);
}

TEST(ConnectLoops, ThatDoNotLieFlatAreRefused) {
  PlateStructure s = window();
  s.bends[1].inside_radius = 5.0;  // its legs are longer when flat
  const auto c = connect(s);
  ASSERT_FALSE(c);
  EXPECT_EQ(c.error().code, ErrorCode::bend_loop);
  EXPECT_EQ(c.error().where, "/bends/1");
}

}  // namespace
}  // namespace planish::test
