#include "sample_plates.hpp"

#include <planish/connect/codes.hpp>
#include <planish/connect/connect.hpp>
#include <planish/geometry/mesh.hpp>
#include <planish/geometry/region.hpp>
#include <planish/sheet/flat_pattern.hpp>
#include <planish/sheet/layout.hpp>

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

/// What faces of the pattern share beyond a hundredth of a millimetre, mm².
double covered_twice(const Connection& c) {
  const auto layout = lay_out(c.sheet);
  EXPECT_TRUE(layout) << (layout ? "" : layout.error().message);
  if (!layout) return HUGE_VAL;
  std::vector<Polygon> faces;
  for (const FaceId face : c.sheet.faces.ids())
    faces.push_back(polygon_of(layout->region(face), 1e-3));
  double area = 0.0;
  for (const Overlap& overlap : overlaps(faces, 5e-3, 0.0))
    area += overlap.area;
  return area;
}

double diagonal(const Plate& plate) {
  Box3 box;
  for (const Vec3& p : plate.outline)
    box.extend(p);
  return box.diagonal().norm();
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
  EXPECT_EQ(c.error().code, code::radius_too_small);
  EXPECT_NE(c.error().message.find("choices of edges"), std::string::npos) << c.error().message;
}

TEST(ConnectGoesOn, KeepsGivenConesOnTheirEdges) {
  PlateStructure s = cone_pair(0.2, 200, 500);
  s.bends = {{.between = {"A", "B"}, .aperture = Angle::degrees(80)}};
  const auto c = connect(s);
  ASSERT_FALSE(c);
  EXPECT_EQ(c.error().code, code::no_bend_fits);
}

TEST(ConnectGoesOn, RoundTheBackWhereThePatternOverlapsInFront) {
  // Plates in nearly crossing planes: every bend in front overlaps a plate when laid flat.
  PlateStructure s;
  s.thickness = 5.995344;
  s.plates = {{"A",
               {{-349.37609, -12.30630, 306.97700},
                {-357.28486, 11.41283, 387.11836},
                {-337.93815, -3.98021, 460.56182},
                {-297.34586, -73.77881, 377.58544},
                {-310.50192, -66.02759, 310.47145}},
               {}},
              {"B",
               {{-409.62660, -34.05879, 513.23205},
                {-243.43931, -70.52972, 563.55914},
                {-247.71147, -101.94006, 554.90403},
                {-320.93964, -85.86964, 532.72808},
                {-319.15077, -72.71731, 536.35220},
                {-369.40400, -61.68890, 521.13384},
                {-371.19287, -74.84122, 517.50972},
                {-413.89875, -65.46913, 504.57694}},
               {}}};
  const auto c = connect(s);
  ASSERT_TRUE(c) << c.error().message;
  EXPECT_EQ(c->bends[0].edge_kind, EdgeKind::averted);
  EXPECT_EQ(covered_twice(*c), 0.0);
}

TEST(ConnectGoesOn, ToAShorterBendWhereTheFirstIsTooLong) {
  // The first bend is 843 mm long, a shorter one between other edges less than 816 mm.
  PlateStructure s;
  s.thickness = 3.031292;
  s.plates = {{"A",
               {{252.00972, -336.69492, 481.12984},
                {236.02195, -312.93434, 492.10337},
                {179.75474, -310.64934, 500.49444},
                {153.77848, -372.61968, 480.94500},
                {175.46440, -430.40878, 456.56105},
                {212.75180, -443.09114, 446.84980},
                {247.26633, -416.35427, 452.16032}},
               {}},
              {"B",
               {{360.17820, -395.67009, 459.85724},
                {340.46632, -454.75584, 581.83357},
                {308.20251, -466.29015, 608.53440},
                {214.87103, -462.63356, 610.60018},
                {215.12925, -409.46130, 502.60916},
                {286.65588, -384.94578, 445.55792}},
               {}}};
  const auto c = connect(s);
  ASSERT_TRUE(c) << c.error().message;
  EXPECT_LT(c->bends[0].reach, 2.0 * (diagonal(s.plates[0]) + diagonal(s.plates[1])));
  EXPECT_EQ(covered_twice(*c), 0.0);
}

TEST(ConnectGoesOn, ToAPatternThatLiesFlatThoughTheSheetsMeetAtACorner) {
  // They share a corner, so that sheets of this thickness run into each other there whatever
  // joins them; most bends make a pattern that covers itself as well.
  PlateStructure s;
  s.thickness = 3.001906;
  s.plates = {{"A",
               {{471.16266, -102.44977, -395.86489},
                {548.90403, -156.33416, -304.87991},
                {579.31746, -214.05283, -297.37352},
                {468.37862, -142.89552, -431.60951}},
               {}},
              {"B",
               {{550.75294, -72.40908, -469.56550},
                {631.67461, -43.74797, -370.49470},
                {552.08433, -73.78866, -296.79409},
                {538.68726, -78.53368, -313.19586},
                {589.04393, -59.52697, -359.82615},
                {534.66079, -78.78857, -426.40635},
                {484.30412, -97.79528, -379.77606},
                {471.16266, -102.44977, -395.86489}},
               {}}};
  const auto c = connect(s);
  ASSERT_TRUE(c) << c.error().message;
  EXPECT_EQ(covered_twice(*c), 0.0);
}

TEST(ConnectGoesOn, WithoutAFurtherStretchThatCrossesItsPlate) {
  // Another stretch of the bend would need an extension over plate B.
  PlateStructure s;
  s.thickness = 2.943798;
  s.plates = {{"A",
               {{-513.65559, -114.54925, 229.95992},
                {-396.43421, 2.76720, 167.86710},
                {-409.49800, 65.13562, 261.04191},
                {-526.71938, -52.18083, 323.13472}},
               {}},
              {"B",
               {{-568.63892, -24.87981, 277.11468},
                {-459.98879, 83.85845, 219.56211},
                {-426.44673, 72.09312, 260.65512},
                {-448.43029, 50.09172, 272.29994},
                {-460.87752, 54.45775, 257.05061},
                {-525.85776, -10.57519, 291.47100},
                {-513.41053, -14.94122, 306.72033},
                {-535.09686, -36.64514, 318.20769}},
               {}}};
  const auto c = connect(s);
  ASSERT_TRUE(c) << c.error().message;
  EXPECT_TRUE(c->bends[0].stretches.empty());
  EXPECT_EQ(c->bends[0].edge_kind, EdgeKind::facing);
  EXPECT_EQ(covered_twice(*c), 0.0);
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

TEST(ConnectFolds, SeveralOnOneEdge) {
  PlateStructure s;
  s.thickness = 1.0;
  s.plates = {rectangle_plate("A", {0, 0, 0}, {100, 0, 0}, {0, 60, 0}),
              rectangle_plate("B", {5, 0, 0}, {35, 0, 0}, {0, 0, 30}),
              rectangle_plate("C", {60, 0, 0}, {35, 0, 0}, {0, 0, 30})};
  s.defaults.inside_radius = 0.0;
  for (const bool given : {false, true}) {
    if (given)
      s.bends = {{.between = {"A", "B"}, .inside_radius = 0.0},
                 {.between = {"A", "C"}, .inside_radius = 0.0}};
    const auto c = connect(s);
    ASSERT_TRUE(c) << c.error().message;
    const double allowance = 0.5 * std::numbers::pi * 0.5 * 1.0;
    EXPECT_NEAR(flat_area(*c, 0.5), 100.0 * 60.0 + 2 * 35.0 * (30.0 - 1.0 + allowance), 1e-6);
  }
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
  EXPECT_EQ(c.error().code, code::no_bend_fits);
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
  EXPECT_EQ(c.error().code, code::bend_loop);
  EXPECT_EQ(c.error().where, "/bends/1");
}

struct FreePair {
  double thickness, trade_off;
  std::vector<Plate> plates;
};

// Pairs on whose best edges a cylinder or cone holds and no general cone.
std::vector<FreePair> free_pairs() {
  return {{1,
           0,
           {{"A",
             {{0.0, 22.56291, 0.0},
              {39.91835, 25.2121, 0.0},
              {111.28677, 23.5025, 0.0},
              {111.28677, 164.08194, 0.0},
              {0.0, 164.08194, 0.0}},
             {}},
            {"B",
             {{-2.17634, 12.87149, 45.51427},
              {66.09361, 11.81876, 41.79177},
              {61.77414, 52.06972, 184.12132},
              {-0.66919, 63.74296, 225.3985}},
             {}}}},
          {1,
           0,
           {{"A",
             {{0.0, 14.52093, 0.0},
              {86.63825, 14.52093, 0.0},
              {79.54876, 177.9155, 0.0},
              {7.08949, 177.9155, 0.0}},
             {}},
            {"B",
             {{0.0, 39.8735, 50.71225},
              {43.23657, 31.33434, 39.85189},
              {70.54876, 56.23523, 71.52155},
              {70.54876, 123.424, 156.97412},
              {0.0, 123.424, 156.97412}},
             {}}}},
          {1.5,
           1,
           {{"A",
             {{-0.25107, 5.44945, 6.43998},
              {30.90909, -42.99212, 46.70912},
              {79.92025, -111.2813, 120.61524},
              {76.5667, -38.49294, 206.63404},
              {-3.88321, 84.28442, 99.60445}},
             {}},
            {"B",
             {{-7.35486, -47.89671, -58.61656},
              {67.47352, -154.86669, 46.90441},
              {62.04634, -260.68351, -54.55738},
              {-11.82725, -130.07914, -138.0835}},
             {}}}}};
}

TEST(AnyChoice, TakesNoGeneralConeElsewhereThatIsLongerAndNoWider) {
  for (const FreePair& pair : free_pairs()) {
    PlateStructure s;
    s.thickness = pair.thickness;
    s.plates = pair.plates;
    s.bends = {{.between = {"A", "B"}, .trade_off = pair.trade_off}};
    const auto made = connect(s);
    ASSERT_TRUE(made) << made.error().message;
    const FittedBend& bend = made->bends[0];
    EXPECT_NE(bend.kind, BendKind::general);
    EXPECT_FALSE(bend.passed_over);
    for (const BendAlternative& other : bend.alternatives)
      EXPECT_FALSE(other.width >= bend.width && other.span < bend.span - 1e-6)
          << other.width << " " << other.span;
  }
}

}  // namespace
}  // namespace planish::test
