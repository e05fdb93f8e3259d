#include "sample_plates.hpp"

#include <planish/connect/codes.hpp>
#include <planish/connect/connect.hpp>
#include <planish/geometry/region.hpp>
#include <planish/sheet/flat_pattern.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

// Bends and edges that do not go one to one: a bend in several stretches, several bends on one
// edge, bends on the edges of openings. Right angles at D = 10 from the line of the planes, so that
// bends of a mid-surface radius of 10 need no extension; flat areas follow by hand.

namespace planish::test {
namespace {

using std::numbers::pi;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr double kGap = 10.0, kThickness = 2.0, kK = 0.44;
// Along the neutral surface, across a right angle of that radius.
constexpr double kAllowance = pi / 2 * (kGap - kThickness / 2 + kK * kThickness);

/// A floor in z = 0 whose outline is given by (x, y), y ≤ −gap beside the line y = z = 0, and an
/// upright plate in y = 0 whose outline is given by (x, z).
Plate lying(const std::string& id, const std::vector<Vec2>& outline) {
  Plate plate{id, {}, {}};
  for (const Vec2& p : outline)
    plate.outline.emplace_back(p.x(), p.y(), 0.0);
  return plate;
}
Plate upright(const std::string& id, const std::vector<Vec2>& outline) {
  Plate plate{id, {}, {}};
  for (const Vec2& p : outline)
    plate.outline.emplace_back(p.x(), 0.0, p.y());
  return plate;
}
Plate wall(const std::string& id, double from, double to) {
  return upright(id, {{from, kGap}, {to, kGap}, {to, 60}, {from, 60}});
}
std::vector<Vec2> floor_outline(double to = 200) {
  return {{0, -100}, {to, -100}, {to, -kGap}, {0, -kGap}};
}

/// A floor of 200 and a wall as wide, each with a recess 8 deep between x = 80 and 120 of its edge.
PlateStructure interrupted() {
  PlateStructure s;
  s.thickness = kThickness;
  s.plates = {
      lying("floor", {{0, -100},
                      {200, -100},
                      {200, -10},
                      {120, -10},
                      {120, -18},
                      {80, -18},
                      {80, -10},
                      {0, -10}}),
      upright("wall",
              {{0, 10}, {80, 10}, {80, 18}, {120, 18}, {120, 10}, {200, 10}, {200, 60}, {0, 60}})};
  return s;
}
constexpr double kInterruptedArea = 200 * 90 + 200 * 50 - 2 * 40 * 8;

Connection connection_of(const PlateStructure& structure) {
  auto connection = connect(structure);
  EXPECT_TRUE(connection) << (connection ? "" : connection.error().message);
  return connection ? *connection : Connection{};
}

double flat_area(const Connection& connection) {
  const auto pattern = flatten(connection.sheet, {.allowance = ConstantK{kK, "test"}});
  EXPECT_TRUE(pattern) << (pattern ? "" : pattern.error().message);
  return pattern ? pattern->area : 0.0;
}

TEST(InterruptedBend, IsOneBendWithAllItsStretches) {
  for (const PlateStructure& s : {interrupted(), mirrored(interrupted())}) {
    const Connection c = connection_of(s);
    ASSERT_EQ(c.bends.size(), 1u);
    const FittedBend& bend = c.bends[0];
    EXPECT_NEAR(bend.inside_radius, kGap - kThickness / 2, 1e-9);
    ASSERT_EQ(bend.stretches.size(), 1u);
    EXPECT_NEAR(bend.stretches[0].width, 80.0, 1e-9);
    EXPECT_NEAR(bend.joined, 160.0, 1e-9);
    EXPECT_NEAR(bend.unused[0] + bend.unused[1], 0.0, 1e-9);
    EXPECT_EQ(c.sheet.bends.size(), 1u);
    EXPECT_EQ(c.sheet[bend.bend].faces.size(), 2u);
    EXPECT_NEAR(flat_area(c), kInterruptedArea + 160 * kAllowance, 1e-6);
  }
}

TEST(InterruptedBend, KeepsItsStretchesWithASmallerRadiusThanIsDrawn) {
  // Both edges are extended by 3 mm, on both stretches.
  constexpr double kInside = kGap - kThickness / 2 - 3.0;
  for (PlateStructure s : {interrupted(), mirrored(interrupted())}) {
    s.bends = {{.between = {"floor", "wall"}, .inside_radius = kInside}};
    const Connection c = connection_of(s);
    ASSERT_EQ(c.bends.size(), 1u);
    EXPECT_NEAR(c.bends[0].joined, 160.0, 1e-9);
    const double allowance = pi / 2 * (kInside + kK * kThickness);
    EXPECT_NEAR(flat_area(c), kInterruptedArea + 160 * (2 * 3.0 + allowance), 1e-6);
  }
}

TEST(InterruptedBend, KeepsItsRecessWhereARunCouldCloseIt) {
  // The sides of the recess lean, so the edges on both sides of it are one chain.
  PlateStructure s = interrupted();
  for (Plate& plate : s.plates)
    for (Vec3& p : plate.outline)
      if (std::max(-p.y(), p.z()) == 18.0) p.x() += p.x() < 100 ? 4 : -4;
  const Connection c = connection_of(s);
  ASSERT_EQ(c.bends.size(), 1u);
  EXPECT_EQ(c.bends[0].stretches.size(), 1u);
  EXPECT_NEAR(flat_area(c), kInterruptedArea + 2 * 4 * 8 + 160 * kAllowance, 1e-6);
}

TEST(InterruptedBend, HasStretchesWhereCoordinatesAreRounded) {
  PlateStructure s = interrupted();
  s.plates[0].outline[2].y() -= 1e-6;
  s.plates[0].outline[7].y() += 1e-6;
  s.plates[1].outline[0].z() -= 1e-6;
  const Connection c = connection_of(s);
  ASSERT_EQ(c.bends.size(), 1u);
  EXPECT_NEAR(c.bends[0].joined, 160.0, 1e-3);
  EXPECT_NEAR(flat_area(c), kInterruptedArea + 160 * kAllowance, 1e-2);
}

/// A floor whose front edge has teeth, recesses of `depth` between them, and an unbroken wall that
/// is drawn up to the bend of inside radius 1.
PlateStructure toothed(double thickness, double depth, const std::vector<double>& sides) {
  PlateStructure s;
  s.thickness = thickness;
  Plate floor{"floor", {{sides.back(), -100, 0}}, {}};
  for (std::size_t i = sides.size(); i-- > 0;) {
    const bool tooth_begins = i % 2 == 1;  // from the right
    const bool outermost = i + 1 == sides.size() || i == 0;
    const Vec3 front(sides[i], 0, 0), back(sides[i], -depth, 0);
    if (outermost)
      floor.outline.push_back(front);
    else
      floor.outline.insert(floor.outline.end(),
                           {tooth_begins ? back : front, tooth_begins ? front : back});
  }
  floor.outline.push_back({sides.front(), -100, 0});
  const double gap = 1.0 + 0.5 * thickness;
  s.plates = {floor, rectangle_plate("wall", {sides.front(), gap, gap},
                                     {sides.back() - sides.front(), 0, 0}, {0, 0, 40})};
  return s;
}

/// Turned in space, its coordinates rounded to that digit.
PlateStructure rounded(PlateStructure s, double digit) {
  const Eigen::Quaterniond turn = Eigen::Quaterniond(0.3, -0.5, 0.7, 0.2).normalized();
  const auto place = [&](Vec3& p) {
    p = digit * ((turn * p + Vec3(123.4, -56.7, 211.9)) / digit).array().round().matrix();
  };
  for (Plate& plate : s.plates) {
    std::ranges::for_each(plate.outline, place);
    for (auto& hole : plate.holes)
      std::ranges::for_each(hole, place);
  }
  return s;
}

TEST(InterruptedBend, JoinsAllTeethOfAnEdge) {
  // The floor's back edge is wider than each tooth, and so is a deep recess between two teeth.
  for (const auto& [depth, sides] : {std::pair{3.0, std::vector{0.0, 13.0, 54.0, 144.0, 191.0,
                                                                282.0, 310.0, 387.0, 405.0, 437.0}},
                                     std::pair{15.0, std::vector{0.0, 41.0, 93.0, 134.0}}}) {
    const Connection c = connection_of(toothed(1.5, depth, sides));
    ASSERT_EQ(c.bends.size(), 1u);
    EXPECT_EQ(c.bends[0].edge_kind, EdgeKind::facing);
    EXPECT_NEAR(c.bends[0].inside_radius, 1.0, 1e-9);
    EXPECT_NEAR(c.bends[0].joined, sides.back(), 1e-9);
    EXPECT_NEAR(c.bends[0].extension_area, 0.0, 1e-9);
  }
}

TEST(InterruptedBend, JoinsAllTeethWhereCoordinatesAreRounded) {
  const std::vector<double> sides{0.0, 41.38, 93.32, 134.7};
  for (const double digit : {1e-6, 1e-5, 1e-4}) {
    const Connection c = connection_of(rounded(toothed(1.5, 15.18, sides), digit));
    ASSERT_EQ(c.bends.size(), 1u);
    EXPECT_NEAR(c.bends[0].joined, 134.7, 10 * digit);
    EXPECT_NEAR(c.bends[0].inside_radius, 1.0, 10 * digit);
  }
}

TEST(InterruptedBend, HasOnlyTheStretchWhoseEdgesAreGiven) {
  PlateStructure s = interrupted();
  s.bends = {{.between = {"floor", "wall"}, .edges = {std::vector{2}, std::vector{4}}}};
  const Connection c = connection_of(s);
  ASSERT_EQ(c.bends.size(), 1u);
  EXPECT_TRUE(c.bends[0].stretches.empty());
  EXPECT_NEAR(c.bends[0].joined, 80.0, 1e-9);
  EXPECT_NEAR(c.bends[0].unused[0], 80.0, 1e-9);
  EXPECT_NEAR(c.bends[0].unused[1], 80.0, 1e-9);
}

TEST(InterruptedBend, GoesOnPastARecessOfOnePlate) {
  // The floor's edge is unbroken: the bend is as long, and joins the wall on both sides of its
  // recess.
  for (const bool mirror : {false, true}) {
    PlateStructure s = interrupted();
    s.plates[0] = lying("floor", floor_outline());
    if (mirror) s = mirrored(s);
    const Connection c = connection_of(s);
    ASSERT_EQ(c.bends.size(), 1u);
    const FittedBend& bend = c.bends[0];
    EXPECT_NEAR(bend.joined, 200.0, 1e-9);
    ASSERT_EQ(bend.stretches.size(), 1u);
    EXPECT_NEAR(bend.stretches[0].width, 80.0, 1e-9);
    EXPECT_EQ(c.sheet[bend.bend].faces.size(), 1u);
    EXPECT_NEAR(bend.unused[0] + bend.unused[1], 0.0, 1e-9);
    EXPECT_NEAR(flat_area(c), 200 * 90 + 200 * 50 - 40 * 8 + 200 * kAllowance, 1e-6);
  }
}

TEST(DrawnEdges, EndABendWhereBothPlatesHaveACorner) {
  // The edges go on beside the bend, flush with it, by different lengths.
  PlateStructure s;
  s.thickness = kThickness;
  s.plates = {lying("floor", {{0, -100}, {200, -100}, {200, -10}, {150, -10}, {50, -10}, {0, -10}}),
              upright("wall", {{10, 10}, {50, 10}, {150, 10}, {195, 10}, {195, 60}, {10, 60}})};
  const Connection c = connection_of(s);
  ASSERT_EQ(c.bends.size(), 1u);
  EXPECT_NEAR(c.bends[0].joined, 100.0, 1e-9);
  EXPECT_TRUE(c.bends[0].stretches.empty());
  EXPECT_NEAR(flat_area(c), 200 * 90 + 185 * 50 + 100 * kAllowance, 1e-6);
}

TEST(DrawnEdges, OfOneLengthAreUsedWhole) {
  // Corners in the middle of edges that end opposite each other mean nothing.
  PlateStructure s;
  s.thickness = kThickness;
  s.plates = {lying("floor", {{0, -100}, {200, -100}, {200, -10}, {90, -10}, {0, -10}}),
              upright("wall", {{0, 10}, {90, 10}, {200, 10}, {200, 60}, {0, 60}})};
  const Connection c = connection_of(s);
  ASSERT_EQ(c.bends.size(), 1u);
  EXPECT_NEAR(c.bends[0].joined, 200.0, 1e-9);
}

PlateStructure two_walls() {
  PlateStructure s;
  s.thickness = kThickness;
  s.plates = {lying("floor", floor_outline()), wall("left", 0, 70), wall("right", 110, 195)};
  return s;
}
constexpr double kTwoWallsArea = 200 * 90 + 70 * 50 + 85 * 50 + (70 + 85) * kAllowance;

TEST(OneEdge, CarriesSeveralBends) {
  for (const PlateStructure& s : {two_walls(), mirrored(two_walls())}) {
    const Connection c = connection_of(s);
    ASSERT_EQ(c.bends.size(), 2u);
    for (const FittedBend& bend : c.bends) {
      EXPECT_EQ(bend.edges[0], std::vector{2});
      EXPECT_EQ(bend.edge_kind, EdgeKind::facing);
      EXPECT_NEAR(bend.inside_radius, kGap - kThickness / 2, 1e-9);
    }
    EXPECT_NEAR(c.bends[0].joined, 70.0, 1e-9);
    EXPECT_NEAR(c.bends[1].joined, 85.0, 1e-9);
    EXPECT_NEAR(flat_area(c), kTwoWallsArea, 1e-6);
  }
}

TEST(OneEdge, CarriesSeveralBendsThatAreGiven) {
  PlateStructure s = two_walls();
  s.bends = {{.between = {"floor", "right"}, .edges = {std::vector{2}, std::nullopt}},
             {.between = {"floor", "left"}, .edges = {std::vector{2}, std::vector{0}}}};
  EXPECT_NEAR(flat_area(connection_of(s)), kTwoWallsArea, 1e-6);
}

TEST(OneEdge, CarriesThirtyWallsWithoutRelief) {
  PlateStructure s;
  s.thickness = kThickness;
  const int walls = 30;
  s.plates = {lying("floor", floor_outline(20.0 * walls))};
  for (int i = 0; i < walls; ++i)
    s.plates.push_back(wall("wall " + std::to_string(i), 20.0 * i + 0.5, 20.0 * i + 19.5));
  const Connection c = connection_of(s);
  ASSERT_EQ(c.bends.size(), 30u);
  for (const FittedBend& bend : c.bends) {
    EXPECT_EQ(bend.plates[0], 0);
    EXPECT_NEAR(bend.joined, 19.0, 0.5);
  }
}

/// A floor with a window 60 × 40, given either way round, and a tab upright on one of its edges.
PlateStructure window_tab(bool turned) {
  PlateStructure s;
  s.thickness = kThickness;
  s.plates = {lying("floor", {{-100, -100}, {100, -100}, {100, 100}, {-100, 100}}),
              upright("tab", {{-30, kGap}, {30, kGap}, {30, 30}, {-30, 30}})};
  std::vector<Vec3> window{{-30, -10, 0}, {30, -10, 0}, {30, 30, 0}, {-30, 30, 0}};
  if (turned) std::ranges::reverse(window);
  s.plates[0].holes = {window};
  return s;
}

// A floor of 100 and walls `gap` behind its front edge, one radius of 10 above it: the floor has to
// be extended by gap − 10 as far as a wall goes.
PlateStructure walls_behind(double gap, std::vector<std::pair<double, double>> walls) {
  PlateStructure s;
  s.thickness = 2.0;
  s.plates = {rectangle_plate("floor", {0, -50, 0}, {100, 0, 0}, {0, 50, 0})};
  for (const auto& [from, width] : walls)
    s.plates.push_back(rectangle_plate("wall" + std::to_string(s.plates.size()), {from, gap, 10},
                                       {width, 0, 0}, {0, 0, 30}));
  return s;
}

TEST(OneEdge, ExtendsALongEdgeOnlyWhereAWallIs) {
  const auto c = connect(walls_behind(12.0, {{30, 30}}));
  ASSERT_TRUE(c) << c.error().message;
  EXPECT_EQ(c->bends[0].kind, BendKind::cylinder);
  EXPECT_NEAR(c->bends[0].inside_radius, 9.0, 1e-9);
  EXPECT_NEAR(c->bends[0].extension_area, 2.0 * 30.0, 1e-6);
}

TEST(OneEdge, SharesAnEdgeBetweenWallsThatItHasToBeExtendedTo) {
  // The first wall alone would take all of the edge, by an extension that runs slanted to its ends.
  PlateStructure s = walls_behind(20.0, {{0, 60}, {65, 30}});
  for (const bool given : {false, true}) {
    if (given) s.bends = {{.between = {"floor", "wall1"}}, {.between = {"floor", "wall2"}}};
    const auto c = connect(s);
    ASSERT_TRUE(c) << c.error().message;
    for (std::size_t b = 0; b < 2; ++b) {
      const double width = b == 0 ? 60.0 : 30.0;
      EXPECT_EQ(c->bends[b].edge_kind, EdgeKind::facing);
      EXPECT_NEAR(c->bends[b].inside_radius, 9.0, 1e-9);
      EXPECT_NEAR(c->bends[b].joined, width, 1e-6);
      EXPECT_NEAR(c->bends[b].extension_area, 10.0 * width, 1e-6);
    }
  }
}

TEST(OneEdge, PrefersTheEdgeOppositeAWallToAStubBesideIt) {
  // Wall 1 has taken the edge up to a stub of 5 mm, whose ends are nearer to those of wall 2 than
  // the ends of the 700 mm that lie opposite; the side wall is not nearer.
  PlateStructure s;
  s.thickness = 2.0;
  s.plates = {rectangle_plate("floor", {0, 0, 0}, {750, 0, 0}, {0, 200, 0}),
              rectangle_plate("wall1", {5, -10, 10}, {40, 0, 0}, {0, 0, 30}),
              rectangle_plate("wall2", {55, -10, 10}, {40, 0, 0}, {0, 0, 30}),
              rectangle_plate("side", {-10, 0, 10}, {0, 200, 0}, {0, 0, 30})};
  const auto c = connect(s);
  ASSERT_TRUE(c) << c.error().message;
  for (const FittedBend& bend : c->bends)
    EXPECT_EQ(bend.plates[0], 0);
}

TEST(EdgeOfAnOpening, CarriesABend) {
  for (const bool turned : {false, true}) {
    const Connection c = connection_of(window_tab(turned));
    ASSERT_EQ(c.bends.size(), 1u);
    const FittedBend& bend = c.bends[0];
    // The window's edges follow those of the outline, in the order of the file.
    EXPECT_EQ(bend.edges[0], std::vector{turned ? 6 : 4});
    EXPECT_EQ(bend.edge_kind, EdgeKind::facing);
    EXPECT_NEAR(bend.angle.degrees(), 90.0, 1e-9);
    EXPECT_NEAR(flat_area(c), 200 * 200 - 60 * 40 + 60 * 20 + 60 * kAllowance, 1e-6);
  }
}

TEST(EdgeOfAnOpening, CarriesATabAsWideAsItWhereCoordinatesAreRounded) {
  // The bend then ends at corners of the opening, to within the rounding; a wall is near as well.
  for (const double digit : {1e-6, 1e-5, 1e-4}) {
    PlateStructure s;
    s.thickness = 2.0;
    s.plates = {rectangle_plate("floor", {0, 0, 0}, {200, 0, 0}, {0, 120, 0}),
                rectangle_plate("tab", {60, 44, 4}, {50, 0, 0}, {0, 0, 25}),
                rectangle_plate("wall", {0, 124, 4}, {200, 0, 0}, {0, 0, 60})};
    s.plates[0].holes = {{{60, 40, 0}, {60, 80, 0}, {110, 80, 0}, {110, 40, 0}}};
    const Connection c = connection_of(rounded(s, digit));
    ASSERT_EQ(c.bends.size(), 2u);
    for (const FittedBend& bend : c.bends) {
      EXPECT_EQ(bend.plates[0], 0);
      EXPECT_NEAR(bend.inside_radius, 3.0, 10 * digit);
      EXPECT_NEAR(bend.joined, bend.plates[1] == 1 ? 50.0 : 200.0, 10 * digit);
    }
  }
}

TEST(DrawnEdges, LeaveChamfersBesideThemAsTheyAre) {
  // Both plates have chamfers of 10 × 10 at the ends of the edges that are drawn up to the bend.
  PlateStructure s;
  s.thickness = 2.0;
  s.plates = {
      {"floor",
       {{0, -100, 0}, {200, -100, 0}, {200, -10, 0}, {190, 0, 0}, {10, 0, 0}, {0, -10, 0}},
       {}},
      {"wall", {{0, 3, 63}, {0, 3, 13}, {10, 3, 3}, {190, 3, 3}, {200, 3, 13}, {200, 3, 63}}, {}}};
  const Connection c = connection_of(s);
  ASSERT_EQ(c.bends.size(), 1u);
  EXPECT_NEAR(c.bends[0].joined, 180.0, 1e-9);
  EXPECT_NEAR(c.bends[0].extension_area, 0.0, 1e-9);
}

TEST(EdgeOfAnOpening, CanBeGiven) {
  PlateStructure s = window_tab(false);
  s.bends = {{.between = {"floor", "tab"}, .edges = {std::vector{4}, std::vector{0}}}};
  EXPECT_EQ(connection_of(s).bends[0].edges[0], std::vector{4});
  s.bends[0].edges[0] = std::vector{8};
  const auto beyond = connect(s);
  ASSERT_FALSE(beyond);
  EXPECT_EQ(beyond.error().code, code::unknown_edge);
  EXPECT_THAT(beyond.error().message, HasSubstr("0 to 7"));
}

TEST(EdgeOfAnOpening, CarriesACurvedSectionWithAFreeEnd) {
  PlateStructure s = window_tab(false);
  s.plates.pop_back();
  s.bends = {{.between = {"floor"},
              .edges = {std::vector{4}, std::nullopt},
              .inside_radius = 5.0,
              .angle = Angle::degrees(90)}};
  const double section = pi / 2 * (5.0 + kK * kThickness);
  EXPECT_NEAR(flat_area(connection_of(s)), 200 * 200 - 60 * 40 + 60 * section, 1e-6);
}

}  // namespace
}  // namespace planish::test
