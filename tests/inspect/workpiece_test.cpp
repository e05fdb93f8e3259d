#include "workpiece.hpp"

#include "flat_plates.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace planish::test {
namespace {

using namespace inspect_detail;

TEST(Workpiece, HasTwoSidesOfABendThatLookAwayFromIt) {
  const FlatPattern pattern = flat_l(30, 50);
  const Workpiece workpiece({}, pattern);
  ASSERT_EQ(workpiece.sides.size(), 2u);
  for (const BendSide& side : workpiece.sides) {
    EXPECT_NEAR(side.length(), 40.0, 1e-12);
    EXPECT_NEAR(std::abs(side.start.x()), 0.5 * zone_width(), 1e-12);
    EXPECT_NEAR((side.outward - Vec2(side.start.x() > 0 ? 1 : -1, 0)).norm(), 0.0, 1e-12);
  }
  EXPECT_EQ(workpiece.tangent_lines.size(), 2u);
}

TEST(Workpiece, TellsWindowsFromOpeningsInTheBend) {
  FlatPattern pattern = flat_l(30, 50);
  open(pattern, rectangular_opening({0, 38}, 8, 8));  // the bend ends at its edge
  open(pattern, circular_opening({0.5 * zone_width(), 20}, 3));
  open(pattern, circular_opening({20, 20}, 3));
  pattern.bends[0].lines = {{Vec2(0, 0), Vec2(0, 34)}};
  pattern.bends[0].tangent_lines = {{Vec2(-0.5 * zone_width(), 0), Vec2(-0.5 * zone_width(), 34)},
                                    {Vec2(0.5 * zone_width(), 0), Vec2(0.5 * zone_width(), 17)},
                                    {Vec2(0.5 * zone_width(), 23), Vec2(0.5 * zone_width(), 34)}};
  const Workpiece workpiece({}, pattern);
  ASSERT_EQ(workpiece.openings.size(), 3u);
  EXPECT_TRUE(workpiece.openings[0].bounds.contains(0));
  EXPECT_TRUE(workpiece.openings[0].reaches_in.empty());
  EXPECT_TRUE(workpiece.openings[1].reaches_in.contains(0));
  EXPECT_TRUE(workpiece.openings[2].bounds.empty() && workpiece.openings[2].reaches_in.empty());
  EXPECT_EQ(workpiece.openings[0].size.sentence, "8 × 8 mm");
  EXPECT_EQ(workpiece.openings[1].size.sentence, "Ø 6 mm");
}

TEST(Workpiece, IsJoinedByMaterialOnlyWhereNothingIsCutOut) {
  FlatPattern pattern = flat_plate(rectangle(100, 60));
  open(pattern, rectangular_opening({50, 30}, 2, 20));
  const Workpiece workpiece({}, pattern);
  EXPECT_FALSE(workpiece.joined_by_material({40, 30}, {60, 30}));
  EXPECT_TRUE(workpiece.joined_by_material({40, 5}, {60, 5}));
  EXPECT_FALSE(workpiece.openings[0].is_cut);
}

/// Sides of the first bend, that to smaller x first.
std::vector<BendSide> sides_by_x(const Workpiece& workpiece) {
  const auto sides = workpiece.sides_of(0);
  std::vector<BendSide> sorted(sides.begin(), sides.end());
  std::ranges::sort(sorted, [](const BendSide& a, const BendSide& b) {
    return a.start.x() + a.end.x() < b.start.x() + b.end.x();
  });
  return sorted;
}

TEST(Workpiece, PutsLimitsHalfTheAllowanceBesideABendWithoutTangentLines) {
  FlatPattern pattern = flat_l(30, 50);
  pattern.bends[0].lines = {{Vec2(0, 0), Vec2(0, 15)}, {Vec2(0, 25), Vec2(0, 40)}};
  pattern.bends[0].tangent_lines.clear();
  const Workpiece workpiece({}, pattern);
  const auto sides = sides_by_x(workpiece);
  ASSERT_EQ(sides.size(), 2u);
  for (const int i : {0, 1}) {
    const double x = (i == 0 ? -0.5 : 0.5) * zone_width();
    EXPECT_LT((sides[i].outward - Vec2(i == 0 ? -1 : 1, 0)).norm(), 1e-12);
    ASSERT_EQ(sides[i].segments.size(), 2u);
    EXPECT_LT((sides[i].segments[0].a - Vec2(x, 0)).norm(), 1e-12);
    EXPECT_LT((sides[i].segments[0].b - Vec2(x, 15)).norm(), 1e-12);
    EXPECT_LT((sides[i].segments[1].a - Vec2(x, 25)).norm(), 1e-12);
    EXPECT_LT((sides[i].start - Vec2(x, 0)).norm(), 1e-12);
    EXPECT_LT((sides[i].end - Vec2(x, 40)).norm(), 1e-12);
  }
  EXPECT_EQ(workpiece.tangent_lines.size(), 4u);
  // Wherever the bend lies.
  const Isometry2 away = Eigen::Translation2d(70, 30) * Eigen::Rotation2Dd(0.3);
  const FlatPattern elsewhere = moved(pattern, away);
  for (const BendSide& side : Workpiece({}, elsewhere).sides) {
    const Vec2 start = away.inverse() * side.start, end = away.inverse() * side.end;
    EXPECT_NEAR(std::abs(start.x()), 0.5 * zone_width(), 1e-12);
    EXPECT_NEAR(end.x(), start.x(), 1e-12);
  }
}

TEST(Workpiece, TellsTheSidesOfABendFromWhereItsLinesAreNotFromTheirOrder) {
  // Lines and limits in pieces that run this way and that, in any order and at any angle.
  for (const double turned : {0.0, 0.8, 2.0, -2.5}) {
    const Isometry2 turn(Eigen::Rotation2Dd{turned});
    FlatPattern pattern = flat_l(30, 50);
    const double half = 0.5 * zone_width();
    FlatBend& bend = pattern.bends[0];
    bend.lines = {{Vec2(0, 40), Vec2(0, 28)}, {Vec2(0, 0), Vec2(0, 12)}};
    bend.tangent_lines = {{Vec2(half, 10), Vec2(half, 0)},
                          {Vec2(-half, 26), Vec2(-half, 40)},
                          {Vec2(half, 30), Vec2(half, 40)},
                          {Vec2(-half, 14), Vec2(-half, 0)}};
    pattern = moved(pattern, turn);
    const Workpiece workpiece({}, pattern);
    ASSERT_EQ(workpiece.sides.size(), 2u);
    for (const BendSide& side : workpiece.sides) {
      const double sign = (turn.inverse() * side.start).x() < 0.0 ? -1.0 : 1.0;
      EXPECT_EQ(side.bend, 0u);
      EXPECT_EQ(side.segments.size(), 2u);
      EXPECT_NEAR(side.length(), 40.0, 1e-12);
      EXPECT_LT((side.outward - turn * Vec2(sign, 0)).norm(), 1e-12) << turned;
      for (const Segment& segment : side.segments)
        EXPECT_NEAR((turn.inverse() * segment.a).x(), sign * half, 1e-12);
    }
    ASSERT_TRUE(workpiece.spans[0]);
    EXPECT_LT((workpiece.spans[0]->start - turn * Vec2(0, 40)).norm(), 1e-12);
    EXPECT_LT((workpiece.spans[0]->end - turn * Vec2(0, 0)).norm(), 1e-12);
    EXPECT_LT((Vec2(workpiece.place_of(0).at[0], workpiece.place_of(0).at[1]) - turn * Vec2(0, 20))
                  .norm(),
              1e-9);
  }
}

TEST(Workpiece, SpansABendFromItsShortestPieceOn) {
  FlatPattern pattern = flat_l(30, 50);
  for (const bool last : {false, true}) {
    pattern.bends[0].lines = {{Vec2(0, 0), Vec2(0, 0.4)}, {Vec2(0, 0.7), Vec2(0, 40)}};
    if (last) pattern.bends[0].lines = {{Vec2(0, 39.6), Vec2(0, 40)}, {Vec2(0, 0), Vec2(0, 39.3)}};
    const Workpiece workpiece({}, pattern);
    ASSERT_TRUE(workpiece.spans[0]);
    EXPECT_LT((workpiece.spans[0]->start - Vec2(0, 0)).norm(), 1e-12);
    EXPECT_LT((workpiece.spans[0]->end - Vec2(0, 40)).norm(), 1e-12);
  }
}

TEST(Workpiece, HasBothLimitsOfABendWithoutWidthOnItsLine) {
  FlatPattern pattern = flat_plate(shifted(rectangle(60, 40), Vec2(-30, 0)));
  FlatBend& bend = add_bend(pattern, {Vec2(0, 0), Vec2(0, 40)}, {90, 0.0, 0.0});
  bend.tangent_lines = {bend.lines.front()};
  const Workpiece workpiece({}, pattern);
  ASSERT_EQ(workpiece.sides.size(), 2u);
  EXPECT_LT((workpiece.sides[0].outward + workpiece.sides[1].outward).norm(), 1e-12);
  EXPECT_NEAR(std::abs(workpiece.sides[0].outward.x()), 1.0, 1e-12);
}

TEST(Workpiece, KeepsTheSidesOfEachBendTogether) {
  FlatPattern pattern = flat_plate(shifted(rectangle(300, 40), Vec2(-150, 0)));
  for (const double x : {-60.0, 0.0, 60.0})
    add_bend(pattern, {Vec2(x, 0), Vec2(x, 40)});
  pattern.bends[1].lines.clear();  // it takes no part
  const Workpiece workpiece({}, pattern);
  EXPECT_EQ(workpiece.sides_of(0).size(), 2u);
  EXPECT_TRUE(workpiece.sides_of(1).empty());
  ASSERT_EQ(workpiece.sides_of(2).size(), 2u);
  for (const BendSide& side : workpiece.sides_of(2))
    EXPECT_NEAR(side.start.x(), 60.0, zone_width());
  EXPECT_FALSE(workpiece.spans[1]);
  EXPECT_EQ(workpiece.place_of(1), place::bend("B2"));
  EXPECT_EQ(workpiece.place_of(2), place::at(place::bend("B3"), Vec2(60, 20)));
  EXPECT_LT((workpiece.zones[0].lo - Vec2(-60 - 0.5 * zone_width(), 0)).norm(), 1e-12);
  EXPECT_LT((workpiece.zones[0].hi - Vec2(-60 + 0.5 * zone_width(), 40)).norm(), 1e-12);
}

/// The first opening of a plate of 200 × 120, as it is prepared.
std::string size_of(const Loop& loop) {
  FlatPattern pattern = flat_plate(rectangle(200, 120));
  open(pattern, loop);
  return Workpiece({}, pattern).openings.at(0).size.sentence;
}

TEST(Workpiece, NamesSizesOfOpeningsTheLongerSideFirstAtAnyAngle) {
  const Isometry2 turn(Eigen::Rotation2Dd{0.6});
  EXPECT_EQ(size_of(circular_opening({60, 60}, 4.5)), "Ø 9 mm");
  EXPECT_EQ(size_of(rectangular_opening({60, 60}, 5, 12)), "12 × 5 mm");
  EXPECT_EQ(size_of(transformed(rectangular_opening({90, 10}, 5, 12), turn)), "12 × 5 mm");
  EXPECT_EQ(size_of(obround_opening({60, 60}, 20, 4, Angle::degrees(33))), "28 × 8 mm");
  // A half disc is no circle.
  EXPECT_EQ(size_of({Arc{Vec2(60, 60), 10, std::numbers::pi, -std::numbers::pi},
                     Segment{Vec2(70, 60), Vec2(50, 60)}}),
            "20 × 10 mm");
}

TEST(Workpiece, NamesEachSizeAlthoughEqualOnesAreMeasuredOnce) {
  FlatPattern pattern = flat_plate(rectangle(200, 120));
  open(pattern, rectangular_opening({20, 60}, 10, 12));
  open(pattern, rectangular_opening({50, 60}, 12, 10));
  open(pattern, rectangular_opening({80, 60}, 9, 13));   // as long around
  open(pattern, rectangular_opening({110, 60}, 8, 15));  // as large
  open(pattern, obround_opening({150, 60}, 6, 3, Angle::degrees(0)));
  const Workpiece workpiece({}, pattern);
  std::vector<std::string> texts;
  for (const Opening& opening : workpiece.openings)
    texts.push_back(opening.size.sentence);
  EXPECT_EQ(texts, (std::vector<std::string>{"12 × 10 mm", "12 × 10 mm", "13 × 9 mm", "15 × 8 mm",
                                             "12 × 6 mm"}));
  EXPECT_LT((workpiece.openings[3].center - Vec2(110, 60)).norm(), 1e-12);
}

TEST(Workpiece, KnowsASlitByItsLackOfWidth) {
  // Twice the area by the perimeter is its mean width: of 20 by w, nearly w.
  for (const auto& [width, is_cut] :
       {std::pair{0.0, true}, {9e-6, true}, {1.2e-5, false}, {0.001, false}}) {
    FlatPattern pattern = flat_plate(rectangle(100, 60));
    open(pattern, rectangular_opening({50, 30}, 20, width));
    EXPECT_EQ(Workpiece({}, pattern).openings[0].is_cut, is_cut) << width;
  }
}

/// A bend face and the flanges beside it, so that openings can say what they were cut from.
Sheet one_bend_face() {
  Sheet sheet;
  sheet.faces.resize(1);
  sheet.faces.front().part_of = BendId{0};
  sheet.bends.resize(1);
  return sheet;
}

TEST(Workpiece, AnOpeningReachesIntoABendByItsLinesItsLimitsOrItsOrigin) {
  const double half = 0.5 * zone_width();
  const auto reaches = [&](const Loop& loop, const std::vector<Segment>& lines,
                           const std::vector<Segment>& limits, bool from_bend = false,
                           bool gap = false) {
    FlatPattern pattern = flat_l(30, 50);
    open(pattern, loop);
    if (!lines.empty()) pattern.bends[0].lines = lines;
    if (!limits.empty()) pattern.bends[0].tangent_lines = limits;
    if (from_bend)
      pattern.openings[0].origins[0] = {
          Origin{{FaceId{0}, 1, 0}, gap, pattern.openings[0].loop[0]}};
    const Sheet sheet = one_bend_face();
    const Workpiece workpiece(sheet, pattern);
    return workpiece.openings[0].reaches_in.contains(0);
  };
  const Loop over_line = rectangular_opening({0, 20}, 2, 8);
  EXPECT_TRUE(reaches(over_line, {{Vec2(0, 0), Vec2(0, 16)}, {Vec2(0, 24), Vec2(0, 40)}}, {}));
  EXPECT_FALSE(reaches(over_line, {}, {})) << "no line ends at it";
  const Loop over_limit = rectangular_opening({half, 20}, 2, 8);
  EXPECT_TRUE(reaches(over_limit, {},
                      {{Vec2(-half, 0), Vec2(-half, 40)},
                       {Vec2(half, 0), Vec2(half, 16)},
                       {Vec2(half, 24), Vec2(half, 40)}}));
  const Loop between = rectangular_opening({0.5 * half, 20}, 0.5, 8);
  EXPECT_TRUE(reaches(between, {}, {}, true));
  EXPECT_FALSE(reaches(between, {}, {}, true, true)) << "a gap comes from no face";
  EXPECT_FALSE(reaches(between, {}, {}));
  EXPECT_FALSE(reaches(rectangular_opening({40, 20}, 4, 8), {}, {}, true)) << "beside the zone";
}

TEST(Workpiece, LetsABendEndAtAnOpeningAtEitherEnd) {
  for (const double y : {2.0, 38.0}) {
    FlatPattern pattern = flat_l(30, 50);
    open(pattern, rectangular_opening({0, y}, 8, 8));
    pattern.bends[0].lines = {y < 20 ? Segment{Vec2(0, 6), Vec2(0, 40)}
                                     : Segment{Vec2(0, 0), Vec2(0, 34)}};
    const Workpiece workpiece({}, pattern);
    EXPECT_TRUE(workpiece.openings[0].bounds.contains(0)) << y;
    EXPECT_TRUE(workpiece.openings[0].reaches_in.empty()) << y;
  }
}

TEST(Workpiece, JoinsByMaterialWhatIsNearerThanTheContoursAreDrawnAndAsksOtherwise) {
  FlatPattern pattern = flat_plate(rectangle(100, 60));
  open(pattern, rectangular_opening({50, 30}, 10, 20));
  const Workpiece workpiece({}, pattern);
  EXPECT_TRUE(workpiece.joined_by_material({0, 30}, {45, 30})) << "from contour to contour";
  EXPECT_FALSE(workpiece.joined_by_material({45, 30}, {55, 30})) << "over the opening";
  EXPECT_FALSE(workpiece.joined_by_material({100, 10}, {120, 10})) << "outside";
  EXPECT_FALSE(workpiece.joined_by_material({30, 30}, {90, 30})) << "its middle is in the opening";
  EXPECT_FALSE(workpiece.joined_by_material({0, 25}, {56, 25})) << "the opening is near its end";
  EXPECT_TRUE(workpiece.joined_by_material({45, 30}, {45.05, 30})) << "as near as drawings are";
  EXPECT_TRUE(workpiece.material({20, 20}));
  EXPECT_FALSE(workpiece.material({50, 30}));
}

TEST(BendKinds, BeginAtTenThicknessesAndAt170Degrees) {
  FlatBend bend;
  bend.inside_radius = 20.0;
  EXPECT_FALSE(is_rolled(bend, 2.0));
  EXPECT_TRUE(is_rolled(bend, 1.99));
  bend.angle = Angle::degrees(169.9);
  EXPECT_FALSE(is_hem(bend));
  bend.angle = Angle::degrees(170);
  EXPECT_TRUE(is_hem(bend));
}

}  // namespace
}  // namespace planish::test
