#include "surface_choice.hpp"

#include "sample_fits.hpp"

#include <planish/connect/connect.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

// Which surface the program takes by itself, and the lofted bends of the thesis's failed case: four
// triangles between a rectangle and a round end.

namespace planish::test {
namespace {

using namespace connect_detail;

constexpr double kRadius = 120.0, kHeight = 300.0;

/// A triangle from an edge of the base to a tip, the base's corners cut off at `cut` mm.
Plate side_of(const std::string& id, const Vec3& from, const Vec3& to, const Vec3& tip,
              double cut) {
  const auto towards = [&](const Vec3& corner, const Vec3& other) -> Vec3 {
    return corner + cut * (other - corner).normalized();
  };
  return {
      id, {towards(from, to), towards(to, from), towards(to, tip), tip, towards(from, tip)}, {}};
}

/// The four triangles between the rectangle 2a × 2b and a circle 300 above it.
PlateStructure four_sides(double a, double b, double cut) {
  const std::array<Vec3, 4> corners{Vec3(a, -b, 0), Vec3(a, b, 0), Vec3(-a, b, 0), Vec3(-a, -b, 0)};
  const std::array<Vec3, 4> tips{Vec3(kRadius, 0, kHeight), Vec3(0, kRadius, kHeight),
                                 Vec3(-kRadius, 0, kHeight), Vec3(0, -kRadius, kHeight)};
  PlateStructure structure;
  structure.thickness = 2.0;
  for (std::size_t i = 0; i < 4; ++i)
    structure.plates.push_back(side_of(std::string(1, static_cast<char>('A' + i)), corners[i],
                                       corners[(i + 1) % 4], tips[i], cut));
  return structure;
}

/// The ends of all rulings of a bend's middle surface on the border farthest from the base.
std::vector<Vec3> upper_end(const Sheet& sheet, const Face& face) {
  std::vector<Vec3> end;
  for (const Border& border : face.loops.front()) {
    std::vector<Vec3> points;
    for (const double t : {0.0, 0.1, 0.35, 0.5, 0.8, 1.0}) {
      const Vec2 uv = point_at(border.curve, t);
      points.push_back(skin_point(face, uv) - 0.5 * sheet.thickness * outward_normal(face, uv));
    }
    if (end.empty() || points[2].z() > end[2].z()) end = points;
  }
  return end;
}

void expect_round_end(const PlateStructure& structure) {
  const auto joined = connect(structure);
  ASSERT_TRUE(joined) << joined.error().message;
  ASSERT_EQ(joined->bends.size(), 3u);
  for (const FittedBend& bend : joined->bends)
    EXPECT_EQ(bend.kind, BendKind::general);
  for (const Face& face : joined->sheet.faces) {
    if (!std::holds_alternative<BendId>(face.part_of)) continue;
    for (const Vec3& p : upper_end(joined->sheet, face)) {
      EXPECT_NEAR(p.z(), kHeight, 1e-5);
      EXPECT_NEAR(p.head<2>().norm(), kRadius, 1e-5);
    }
  }
}

TEST(SurfaceChoice, LoftsFourTrianglesToARoundEndByItself) {
  // Over a rectangle no right cone suits both plates; over a square it needs as little extension,
  // but its end is not round.
  expect_round_end(four_sides(200, 140, 10));
  expect_round_end(four_sides(300, 200, 30));
  expect_round_end(four_sides(200, 200, 30));
}

/// Between a rectangle 2a × 2b and a circle of radius r beside its middle, in another plane.
struct SquareToRound {
  double a, b, r, height;
  Vec2 beside;
  double thickness;
};

TEST(SurfaceChoice, LoftsTrianglesThatAreDrawnToTheirCorners) {
  for (const SquareToRound& size : {SquareToRound{169, 194, 188, 276, {0, 0}, 1},
                                    {74, 106, 79, 93, {0, 0}, 0.5},
                                    {299, 65, 76, 498, {0, 5}, 0.5},
                                    {78, 110, 117, 87, {17, 7}, 1},
                                    {130, 175, 145, 339, {0, 0}, 1},
                                    {240, 77, 79, 185, {0, -13}, 1}}) {
    const auto& [a, b, r, height, beside, thickness] = size;
    const std::array<Vec3, 4> corners{Vec3(a, -b, 0), Vec3(a, b, 0), Vec3(-a, b, 0),
                                      Vec3(-a, -b, 0)};
    const Vec3 middle(beside.x(), beside.y(), height);
    PlateStructure structure;
    structure.thickness = thickness;
    for (std::size_t i = 0; i < 4; ++i) {
      const double turn = 0.5 * std::numbers::pi * static_cast<double>(i);
      const Vec3 tip = middle + r * Vec3(std::cos(turn), std::sin(turn), 0);
      structure.plates.push_back({std::string(1, static_cast<char>('A' + i)),
                                  {corners[i], corners[(i + 1) % 4], tip},
                                  {}});
    }
    const auto joined = connect(structure);
    ASSERT_TRUE(joined) << a << ": " << joined.error().message;
    ASSERT_EQ(joined->bends.size(), 3u);
    EXPECT_EQ(joined->left_open.size(), 1u);
    for (const FittedBend& bend : joined->bends) {
      // At a corner of the rectangle, along the sides of both triangles, which they follow but for
      // what is cut back.
      EXPECT_NE(bend.plates[1] - bend.plates[0], 2) << a;
      EXPECT_EQ(bend.kind, BendKind::general) << a;
      EXPECT_GT(bend.width, 0.5 * height) << a;
      EXPECT_LT(bend.extension_area, 20.0) << a;
    }
  }
}

TEST(SurfaceChoice, IsTheOneOfLeastExtension) {
  for (const PlateStructure& free : {four_sides(300, 200, 10), four_sides(200, 140, 30),
                                     four_sides(200, 200, 10), cone_pair()}) {
    PlateStructure pair = free;
    pair.plates.resize(2);
    BendRequest request{.between = {pair.plates[0].id, pair.plates[1].id}};
    pair.bends = {request};
    const auto chosen = connect(pair);
    ASSERT_TRUE(chosen) << chosen.error().message;
    for (const auto surface :
         {SurfaceChoice::cylinder, SurfaceChoice::cone, SurfaceChoice::general}) {
      pair.bends[0].surface = surface;
      const auto named = connect(pair);
      if (!named || named->bends[0].edges != chosen->bends[0].edges) continue;
      // A slope of 0.001 counts as none, over all of the width.
      EXPECT_LE(chosen->bends[0].extension_area,
                named->bends[0].extension_area + 1e-3 * std::pow(named->bends[0].width, 2));
    }
  }
}

TEST(SurfaceChoice, IsGeneralOnEdgesWhereThatNeedsLessExtension) {
  // Edges of unequal slope, of plates without tips.
  PlateStructure s = cone_pair(0.2);
  s.plates[1].outline = {{200, 0, 10}, {500, 0, 25}, {500, 0, 300}, {200, 0, 300}};
  const PairTask pair(s);
  const auto choice = search_pair(pair.task, {});
  ASSERT_TRUE(choice);
  const auto chosen = chosen_surface(pair.task, *choice, {});
  ASSERT_TRUE(chosen) << chosen.error().message;
  EXPECT_EQ(chosen->surface.kind, BendKind::general);
  FitTask right_only = pair.task;
  right_only.right_only = true;
  const auto right = chosen_surface(right_only, *choice, {});
  ASSERT_TRUE(right);
  EXPECT_EQ(right->surface.kind, BendKind::cone);
  EXPECT_LT(chosen->extension_area, 0.5 * right->extension_area);
}

TEST(SurfaceChoice, StaysWithCylindersAndConesThatNeedNoExtension) {
  // Parallel edges, and edges of one slope.
  const auto cylinder = connect(angle_pair(20.0));
  ASSERT_TRUE(cylinder) << cylinder.error().message;
  EXPECT_EQ(cylinder->bends[0].kind, BendKind::cylinder);
  const auto cone = connect(cone_pair());
  ASSERT_TRUE(cone) << cone.error().message;
  EXPECT_EQ(cone->bends[0].kind, BendKind::cone);
}

}  // namespace
}  // namespace planish::test
