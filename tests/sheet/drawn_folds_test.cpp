#include "support/sheets.hpp"

#include <planish/sheet/drawn_folds.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace planish {
namespace {

using namespace planish::test;

const double kTurn60 = std::tan(std::numbers::pi / 6);  // of half the angle

/// 50 | folded sharply by 60° | 30, width 40, t 2.
Sheet folded_angle(BendDirection direction) {
  return strip({Straight{50}, Crease{Angle::degrees(60), direction}, Straight{30}}, 40, 2.0);
}

TEST(DrawnFolds, AreSharpOrOfARadiusThatNobodySees) {
  Bend bend;
  bend.kind = BendKind::sharp;
  bend.inside_radius = 5.0;
  EXPECT_TRUE(is_fold(bend));
  bend.kind = BendKind::cylinder;
  EXPECT_FALSE(is_fold(bend));
  bend.inside_radius = 0.0005;
  EXPECT_TRUE(is_fold(bend));
  bend.kind = BendKind::cone;
  EXPECT_FALSE(is_fold(bend));
}

TEST(DrawnFolds, LieWhereTheMiddleSurfacesMeet) {
  // The reference skin is sharp; the middle is half a thickness outside or inside of it.
  for (const auto& [direction, sign] :
       {std::pair{BendDirection::up, 1.0}, {BendDirection::down, -1.0}}) {
    const Sheet sheet = folded_angle(direction);
    const ToFoldLines found = distances_to_fold_lines(sheet);
    ASSERT_EQ(found.size(), 2u) << "a border of each flange";
    for (const auto& [border, distance] : found)
      EXPECT_NEAR(distance, sign * (0.5 * sheet.thickness - sheet.reference_depth) * kTurn60,
                  1e-12);
  }
  EXPECT_TRUE(distances_to_fold_lines(l_bracket()).empty()) << "a bend with a radius";
}

TEST(DrawnFolds, OfATinyRadiusLieBehindIt) {
  const Sheet sheet = strip({Straight{50}, Turn{Angle::degrees(60), 0.0005}, Straight{30}}, 40,
                            2.0);
  const ToFoldLines found = distances_to_fold_lines(sheet);
  ASSERT_EQ(found.size(), 2u);
  for (const auto& [border, distance] : found)
    EXPECT_NEAR(distance, (0.0005 + 1.0) * kTurn60, 1e-12);
}

Box2 box_around(const std::vector<Curve2>& loop) {
  Box2 box;
  for (const Curve2& curve : loop)
    for (const Vec2& p : {start_of(curve), end_of(curve)})
      box.add(p);
  return box;
}

TEST(DrawnFolds, MoveTheBordersOfFlangesToThem) {
  const Sheet sheet = folded_angle(BendDirection::up);
  ToFoldLines found = distances_to_fold_lines(sheet);
  for (auto& [border, distance] : found)
    distance = 3.0;
  const auto drawn = drawn_to_fold_lines(sheet, FaceId{0}, 0, found);
  EXPECT_EQ(drawn.size(), 6u) << "three in place of one";
  const Box2 box = box_around(drawn);
  EXPECT_NEAR(box.size().x(), 53.0, 1e-12);
  EXPECT_NEAR(box.size().y(), 40.0, 1e-12);
  for (std::size_t i = 0; i < drawn.size(); ++i)
    EXPECT_LT((end_of(drawn[i]) - start_of(drawn[(i + 1) % drawn.size()])).norm(), 1e-12)
        << "it stays closed";
  EXPECT_EQ(drawn_to_fold_lines(sheet, FaceId{0}, 0, {}).size(), 4u);
}

TEST(DrawnFolds, EndOnTheBordersBesideThem) {
  // Sides that lean by 30° go on to the line; those that run along it end in a step.
  test::SheetBuilder builder(2.0);
  const double lean = std::tan(std::numbers::pi / 6);
  const FaceId first = builder.flange(
      Frame{}, {polygon({{0, 0}, {40, 0}, {40 + 30 * lean, 30}, {-30 * lean, 30}})});
  const Rim rim = builder.crease(builder.rim(first, 0), {Angle::degrees(90), BendDirection::up});
  builder.flange_behind(rim, {rectangle(40, 20)});
  const Sheet sheet = builder.finish();
  const auto drawn = drawn_to_fold_lines(sheet, first, 0, {{{0, 0, 0}, 6.0}});
  Box2 low;
  for (const Curve2& curve : drawn)
    for (const Vec2& p : {start_of(curve), end_of(curve)})
      if (p.y() < -1.0) low.add(p);
  EXPECT_NEAR(low.lo.y(), -6.0, 1e-12);
  EXPECT_NEAR(low.size().x(), 40.0 - 2 * 6.0 * lean, 1e-12);
}

TEST(DrawnFolds, HaveNoCornersWhereTheOutlineRunsOn) {
  const std::vector<Vec2> square{{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  EXPECT_EQ(without_runs(square, 0.01), square);
  EXPECT_EQ(without_runs({{0, 0}, {4, 0}, {10, 0}, {10, 10}, {0, 10}}, 0.01), square);
  EXPECT_EQ(without_runs({{0, 0}, {10, 0}, {10, 12}, {10, 10}, {0, 10}}, 0.01), square)
      << "or runs back over itself";
  EXPECT_EQ(without_runs({{0, 0}, {5, 1}, {10, 0}, {10, 10}}, 0.01).size(), 4u);
  EXPECT_EQ(without_runs({{0, 0}, {5, 0}, {10, 0}}, 0.01).size(), 3u) << "never fewer than three";
}

}  // namespace
}  // namespace planish
