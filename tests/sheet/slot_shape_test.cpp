#include "slot_shape.hpp"

#include "support/sheet_builder.hpp"

#include <planish/sheet/codes.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace planish::test {
namespace {

using sheet_detail::Slot;
using std::numbers::pi;

TEST(SlotChain, KeepsTheEndsAndAThousandthOfTheLength) {
  EXPECT_EQ(sheet_detail::chain_of(Segment{{1, 2}, {3, 4}}).size(), 2u);
  for (const double radius : {0.2, 20.0, 2000.0}) {
    const Arc arc{{5, 5}, radius, 0.3, 2.0};
    const std::vector<Vec2> points = sheet_detail::chain_of(arc);
    EXPECT_LT((points.front() - start_of(arc)).norm(), 1e-12 * radius);
    EXPECT_LT((points.back() - end_of(arc)).norm(), 1e-12 * radius);
    // A chord over an angle δ is δ²/8 of the radius off: 2 / √(8·0.002) = 16 of them are enough.
    EXPECT_LE(points.size(), 20u) << radius;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const Vec2 middle = 0.5 * (points[i - 1] + points[i]);
      EXPECT_LE(radius - (middle - arc.center).norm(), 1e-3 * 2 * radius + 1e-9);
    }
  }
}

void expect_closed(const Loop& loop) {
  for (std::size_t i = 0; i < loop.size(); ++i)
    EXPECT_LT((end_of(loop[i]) - start_of(loop[(i + 1) % loop.size()])).norm(), 1e-9) << i;
}

TEST(ClosedSlot, HasRoundEndsClockwise) {
  const Slot slot{.axis = {{10, 10}, {40, 50}}, .half_width = 2.0};
  const Loop loop = sheet_detail::closed_slot(slot);
  expect_closed(loop);
  EXPECT_NEAR(signed_area(loop), -(50 * 4 + 4 * pi), 1e-9);
  EXPECT_NEAR(length(loop), 100 + 4 * pi, 1e-9);
  // Round beyond the ends of the axis.
  const Vec2 tip(41.2, 51.6);
  double off = 1e9;
  for (const Curve2& curve : loop)
    off = std::min(off, nearest(curve, tip).distance);
  EXPECT_LT(off, 1e-9);
}

TEST(ClosedSlot, HasHolesAboutTheEndsOfItsAxis) {
  const double w = 2.0, r = 5.0;
  const Slot slot{.axis = {{10, 10}, {60, 10}}, .half_width = w, .hole = r};
  EXPECT_EQ(slot.end_radius(), r);
  EXPECT_EQ(slot.holes().size(), 2u);
  const Loop loop = sheet_detail::closed_slot(slot);
  expect_closed(loop);
  const double back = std::sqrt(r * r - w * w), half = std::asin(w / r);
  // Two discs less the segments within the band, and the band between its chords.
  const double disc = pi * r * r - (half * r * r - w * back);
  EXPECT_NEAR(signed_area(loop), -(2 * disc + 2 * w * (50 - 2 * back)), 1e-9);
  EXPECT_NEAR(length(loop), 2 * (50 - 2 * back) + 2 * (2 * pi - 2 * half) * r, 1e-9);
  const Slot narrow{.axis = {{0, 0}, {9, 0}}, .half_width = 2.0, .hole = 1.0};
  EXPECT_EQ(narrow.end_radius(), 2.0) << "a hole within the slot is none";
  const Slot open{.axis = {{0, 0}, {9, 0}}, .opens_at = sheet_detail::Corner{0, 1}};
  ASSERT_EQ(open.holes().size(), 1u);
  EXPECT_EQ(open.holes().front(), Vec2(9, 0));
}

/// A plate of 100 × 60 with a corner at (50, 0), where a slot opens.
Contour mouthed(const Vec2& mouth, const Vec2& left = {0, 0}, const Vec2& right = {100, 0}) {
  Contour contour;
  contour.loop = polygon({left, mouth, right, {100, 60}, {0, 60}});
  contour.origins.resize(5);
  return contour;
}

Slot opening(const Segment& axis, double half_width) {
  return {.axis = axis, .half_width = half_width, .opens_at = sheet_detail::Corner{0, 1}};
}

TEST(OpenSlot, TakesItsBandAndItsRoundEnd) {
  const auto cut = sheet_detail::with_open_slot(mouthed({50, 0}), opening({{50, 0}, {50, 30}}, 2),
                                                1e-6);
  ASSERT_TRUE(cut);
  expect_closed(cut->loop);
  EXPECT_EQ(cut->loop.size(), cut->origins.size());
  EXPECT_NEAR(signed_area(cut->loop), 6000 - (4 * 30 + 2 * pi), 1e-9);
  EXPECT_LT((end_of(cut->loop[0]) - Vec2(48, 0)).norm(), 1e-9);
}

TEST(OpenSlot, SlantedIsCutWhereItsBanksMeetTheSide) {
  // At 60° to the side: the area of a slanted band is that of a straight one about its axis.
  const Vec2 tip = Vec2(50, 0) + 30 * Vec2(0.5, std::sqrt(0.75));
  const auto cut = sheet_detail::with_open_slot(mouthed({50, 0}), opening({{50, 0}, tip}, 2), 1e-6);
  ASSERT_TRUE(cut);
  expect_closed(cut->loop);
  // Left of it the side lies at more than 90°: the round end about the mouth. Right of it the bank.
  const double wedge = 0.5 * 4 * (pi / 6), triangle = 0.5 * 2 * 2 / std::tan(pi / 3);
  EXPECT_NEAR(signed_area(cut->loop), 6000 - (4 * 30 + 2 * pi + wedge - triangle), 1e-9);
}

TEST(OpenSlot, NeedsRoomAtItsMouth) {
  const auto wide = [](double half_width, double beside, double deep = 30) {
    return sheet_detail::with_open_slot(mouthed({50, 0}, {50 - beside, 0}),
                                        opening({{50, 0}, {50, deep}}, half_width), 1e-6);
  };
  EXPECT_TRUE(wide(2, 2.1));
  EXPECT_EQ(wide(2, 1.9).error().code, code::bad_option);
  const auto right = [](double beside) {
    return sheet_detail::with_open_slot(mouthed({50, 0}, {0, 0}, {50 + beside, 0}),
                                        opening({{50, 0}, {50, 30}}, 2.0), 1e-6);
  };
  EXPECT_TRUE(right(2.1));
  EXPECT_FALSE(right(1.9));
  // At 45° the bank meets the side 2/sin 45° from the mouth, 2/tan 45° along the axis.
  const auto slanted = [](double deep) {
    const Vec2 tip = Vec2(50, 0) + deep * Vec2(std::sqrt(0.5), std::sqrt(0.5));
    return sheet_detail::with_open_slot(mouthed({50, 0}), opening({{50, 0}, tip}, 2), 1e-6);
  };
  EXPECT_TRUE(slanted(2.1));
  EXPECT_FALSE(slanted(1.9)) << "ends before its mouth";
}

TEST(OpenSlot, MeetsLinesOnly) {
  Contour curved = mouthed({50, 0});
  curved.loop[1] = Arc{{75, 0}, 25, pi, pi};
  const auto cut = sheet_detail::with_open_slot(curved, opening({{50, 0}, {50, 30}}, 2), 1e-6);
  ASSERT_FALSE(cut);
  EXPECT_EQ(cut.error().code, code::unsupported_shape);
}

void expect_pieces(const std::vector<Segment>& pieces, const std::vector<double>& x) {
  ASSERT_EQ(2 * pieces.size(), x.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    EXPECT_NEAR(pieces[i].a.x(), x[2 * i], 1e-9) << i;
    EXPECT_NEAR(pieces[i].b.x(), x[2 * i + 1], 1e-9) << i;
  }
}

TEST(OutsideOfSlots, LinesAreInterruptedByTheBandAndTheEnds) {
  const Segment line{{0, 0}, {100, 0}};
  const Slot across{.axis = {{30, -10}, {30, 10}}, .half_width = 2.0};
  expect_pieces(sheet_detail::outside(line, {across}), {0, 28, 32, 100});
  // Only its round end reaches the line: 4 below the middle of a circle of 5, and 0.5 below one
  // of 1.
  const Slot hole{.axis = {{60, 4}, {60, 20}}, .half_width = 1.0, .hole = 5.0};
  expect_pieces(sheet_detail::outside(line, {hole}), {0, 57, 63, 100});
  const Slot round{.axis = {{60, 0.5}, {60, 20}}, .half_width = 1.0};
  expect_pieces(sheet_detail::outside(line, {round}),
                {0, 60 - std::sqrt(0.75), 60 + std::sqrt(0.75), 100});
  const Slot far_end{.axis = {{60, 20}, {60, 4}}, .half_width = 1.0, .hole = 5.0};
  expect_pieces(sheet_detail::outside(line, {far_end}), {0, 57, 63, 100});
  const Slot small{.axis = {{60, 0.3}, {60, 20}}, .half_width = 0.0, .hole = 0.5};
  expect_pieces(sheet_detail::outside(line, {small}), {0, 59.6, 60.4, 100});
}

TEST(OutsideOfSlots, LinesAlongsideAreLeftOrTaken) {
  const Segment line{{0, 0}, {100, 0}};
  const Slot along{.axis = {{20, 1}, {80, 1}}, .half_width = 2.0};
  const double end = std::sqrt(3.0);
  expect_pieces(sheet_detail::outside(line, {along}), {0, 20 - end, 80 + end, 100});
  const Slot beside{.axis = {{20, 3}, {80, 3}}, .half_width = 2.0};
  expect_pieces(sheet_detail::outside(line, {beside}), {0, 100});
  const Slot below{.axis = {{20, -3}, {80, -3}}, .half_width = 2.0};
  expect_pieces(sheet_detail::outside(line, {below}), {0, 100});
  const Slot over_its_end{.axis = {{90, 0}, {120, 0}}, .half_width = 2.0};
  expect_pieces(sheet_detail::outside(line, {over_its_end}), {0, 88});
  const Slot all{.axis = {{-10, 0}, {120, 0}}, .half_width = 2.0};
  expect_pieces(sheet_detail::outside(line, {all}), {});
  const Slot behind{.axis = {{120, -5}, {120, 5}}, .half_width = 2.0};
  expect_pieces(sheet_detail::outside(line, {behind}), {0, 100});
}

TEST(OutsideOfSlots, SeveralMayOverlapAndComeInAnyOrder) {
  const Segment line{{0, 0}, {100, 0}};
  const auto at = [](double x, double half_width) {
    return Slot{.axis = {{x, -10}, {x, 10}}, .half_width = half_width};
  };
  expect_pieces(sheet_detail::outside(line, {at(50, 10), at(20, 2), at(55, 2), at(61, 3)}),
                {0, 18, 22, 40, 64, 100});
}

}  // namespace
}  // namespace planish::test
