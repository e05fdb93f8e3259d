#include "set_back.hpp"

#include "support/sheets.hpp"

#include <planish/sheet/codes.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace planish::test {
namespace {

using sheet_detail::needs_setback;
using sheet_detail::with_setback;

constexpr double kSetBackT = 2.0;

/// A base with a sharp fold along its border `at` and a wall of 30 behind it.
Sheet folded_at(const Loop& base, int at, double degrees,
                BendDirection direction = BendDirection::down) {
  SheetBuilder builder(kSetBackT);
  const FaceId face = builder.flange({}, {base});
  const Rim rim = builder.crease(builder.rim(face, at), {Angle::degrees(degrees), direction});
  builder.flange_behind(rim, {rectangle(rim.length, 30)});
  return builder.finish();
}

Loop loop_of(const Sheet& sheet, FaceId face) {
  Loop loop;
  for (const Border& border : sheet[face].loops.front())
    loop.push_back(border.curve);
  return loop;
}

TEST(SetBack, IsNeededOnlyForTheOutsideOfASharpBend) {
  EXPECT_TRUE(needs_setback(folded_at(rectangle(50, 40), 1, 90)));
  EXPECT_FALSE(needs_setback(folded_at(rectangle(50, 40), 1, 90, BendDirection::up)));
  EXPECT_FALSE(needs_setback(l_bracket_down()));
  Sheet between = folded_at(rectangle(50, 40), 1, 90);
  between.reference_depth = 1.0;
  EXPECT_FALSE(needs_setback(between));
}

TEST(SetBack, MovesBothBordersByTheThicknessTimesTheTangentOfHalfTheAngle) {
  for (const double degrees : {30.0, 90.0, 120.0}) {
    const double by = kSetBackT * std::tan(degrees * std::acos(-1.0) / 360);
    const Sheet sheet = folded_at(rectangle(50, 40), 1, degrees);
    const auto moved = with_setback(sheet);
    ASSERT_TRUE(moved);
    const Loop base = loop_of(*moved, FaceId{0}), wall = loop_of(*moved, FaceId{1});
    EXPECT_LT((start_of(base[1]) - Vec2(50 - by, 0)).norm(), 1e-9);
    EXPECT_LT((end_of(base[1]) - Vec2(50 - by, 40)).norm(), 1e-9);
    EXPECT_NEAR(signed_area(base), (50 - by) * 40, 1e-9);
    EXPECT_NEAR(signed_area(wall), (30 - by) * 40, 1e-9);
    // What was cut has no measured length any more; what was not keeps its own.
    const auto measured = [](const Sheet& of, int border) {
      return of[BorderRef{FaceId{0}, 0, border}].edge_length;
    };
    for (const int cut : {0, 1, 2})
      EXPECT_FALSE(measured(*moved, cut)) << cut;
    EXPECT_EQ(measured(*moved, 3), measured(sheet, 3));
  }
}

TEST(SetBack, LeavesFoldsTheOtherWayAlone) {
  const Sheet sheet = folded_at(rectangle(50, 40), 1, 90, BendDirection::up);
  EXPECT_NEAR(signed_area(loop_of(*with_setback(sheet), FaceId{0})), 2000.0, 1e-12);
}

TEST(SetBack, ShrinksToAPointWhatLiesWithinIt) {
  // Chamfers of 1 × 1 at both ends of the fold, which moves by 2: beyond them.
  const Loop base = polygon({{0, 0}, {49, 0}, {50, 1}, {50, 39}, {49, 40}, {0, 40}});
  const auto moved = with_setback(folded_at(base, 2, 90));
  ASSERT_TRUE(moved);
  const Loop loop = loop_of(*moved, FaceId{0});
  ASSERT_EQ(loop.size(), 6u);
  EXPECT_LT((start_of(loop[2]) - Vec2(48, 0)).norm(), 1e-9);
  EXPECT_LT((end_of(loop[2]) - Vec2(48, 40)).norm(), 1e-9);
  for (const int chamfer : {1, 3})
    EXPECT_LT(length(loop[chamfer]), 1e-9);
  EXPECT_LT((start_of(loop[1]) - Vec2(48, 0)).norm(), 1e-9);
  EXPECT_LT((start_of(loop[3]) - Vec2(48, 40)).norm(), 1e-9);
  EXPECT_NEAR(signed_area(loop), 48.0 * 40, 1e-9);
}

TEST(SetBack, CutsChamfersThatReachFurther) {
  // Chamfers of 5 × 5: the fold becomes 2 longer at both ends.
  const Loop base = polygon({{0, 0}, {45, 0}, {50, 5}, {50, 35}, {45, 40}, {0, 40}});
  const auto moved = with_setback(folded_at(base, 2, 90));
  ASSERT_TRUE(moved);
  const Loop loop = loop_of(*moved, FaceId{0});
  EXPECT_LT((start_of(loop[2]) - Vec2(48, 3)).norm(), 1e-9);
  EXPECT_LT((end_of(loop[2]) - Vec2(48, 37)).norm(), 1e-9);
  EXPECT_LT((start_of(loop[1]) - Vec2(45, 0)).norm(), 1e-9);
  EXPECT_LT((end_of(loop[3]) - Vec2(45, 40)).norm(), 1e-9);
}

TEST(SetBack, CutsRoundedCornersWhereTheyCross) {
  // A quarter circle of radius 5 about (45, 5) at the start of the fold.
  Loop base{Segment{{0, 0}, {45, 0}}, Arc{{45, 5}, 5, -std::acos(0.0), std::acos(0.0)},
            Segment{{50, 5}, {50, 40}}, Segment{{50, 40}, {0, 40}}, Segment{{0, 40}, {0, 0}}};
  const auto moved = with_setback(folded_at(base, 2, 90));
  ASSERT_TRUE(moved);
  const Loop loop = loop_of(*moved, FaceId{0});
  // At x = 48: 3 right of the centre, 4 below it.
  EXPECT_LT((start_of(loop[2]) - Vec2(48, 1)).norm(), 1e-9);
  EXPECT_LT((end_of(loop[1]) - Vec2(48, 1)).norm(), 1e-9);
  EXPECT_LT((start_of(loop[1]) - Vec2(45, 0)).norm(), 1e-9);
}

TEST(SetBack, NeedsRoom) {
  for (const double width : {1.5, 2.5}) {
    const auto moved = with_setback(folded_at(rectangle(width, 40), 1, 90));
    EXPECT_EQ(moved.has_value(), width > kSetBackT) << width;
    if (!moved) {
      EXPECT_EQ(moved.error().code, code::unsupported_shape);
      EXPECT_NE(moved.error().message.find("2 mm"), std::string::npos) << moved.error().message;
    }
  }
  // A triangle comes to its tip before the border has moved far enough.
  EXPECT_FALSE(with_setback(folded_at(polygon({{0, 0}, {1, -20}, {1, 20}}), 1, 90)));
}

}  // namespace
}  // namespace planish::test
