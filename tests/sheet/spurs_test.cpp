#include "spurs.hpp"

#include "support/sheet_builder.hpp"

#include <gtest/gtest.h>

namespace planish::test {
namespace {

constexpr double kBanks = 1e-3;

sheet_detail::WithoutSpurs without(const std::vector<Vec2>& corners) {
  Contour contour;
  contour.loop = polygon(corners);
  for (int i = 0; i < std::ssize(corners); ++i)
    contour.origins.push_back({{BorderRef{FaceId{0}, 0, i}, false, contour.loop[i]}});
  return sheet_detail::without_spurs(contour, kBanks);
}

/// From either end.
void expect_slits(const std::vector<Segment>& slits, const std::vector<Segment>& wanted) {
  ASSERT_EQ(slits.size(), wanted.size());
  const auto same = [](const Segment& a, const Segment& b) {
    return ((a.a - b.a).norm() < 1e-9 && (a.b - b.b).norm() < 1e-9) ||
           ((a.a - b.b).norm() < 1e-9 && (a.b - b.a).norm() < 1e-9);
  };
  for (const Segment& slit : wanted)
    EXPECT_TRUE(std::ranges::any_of(slits, [&](const Segment& s) { return same(s, slit); }))
        << slit.a.transpose() << " to " << slit.b.transpose();
}

TEST(Spurs, OfAPlainContourAreNone) {
  const auto plain = without({{0, 0}, {30, 0}, {30, 20}, {0, 20}});
  EXPECT_TRUE(plain.slits.empty());
  EXPECT_EQ(plain.contour.loop.size(), 4u);
  // A notch of 1 is not a slit, nor is one of a hundredth.
  EXPECT_TRUE(without({{0, 0}, {30, 0}, {30, 9}, {10, 9}, {10, 10}, {30, 10}, {30, 20}, {0, 20}})
                  .slits.empty());
  EXPECT_TRUE(without({{0, 0}, {30, 0}, {30, 9}, {10, 9.005}, {30, 9.01}, {30, 20}, {0, 20}})
                  .slits.empty());
}

TEST(Spurs, AreTakenAlongTheLongerOfTheirCurves) {
  // Half a thousandth beside the long curve; the short one's own line leads 0.1 past its beginning.
  const auto cut = without(
      {{0, 0}, {30, 0}, {30, 9}, {10, 9}, {10.1, 9.0005}, {10.1, 20}, {0, 20}});
  ASSERT_EQ(cut.slits.size(), 1u);
  EXPECT_NEAR(length(cut.slits.front()), 0.1, 1e-3);
  const auto first = without(
      {{0, 0}, {30, 0}, {30, 9}, {29.9, 9.0005}, {50, 9}, {50, 20}, {0, 20}});
  EXPECT_NEAR(signed_area(first.contour.loop), 50 * 20 - 20 * 9, 20.0);
}

TEST(Spurs, LeaveACornerWhereTheyBegin) {
  const auto cut = without({{0, 0}, {30, 0}, {30, 9}, {10, 9}, {30, 9}, {30, 20}, {0, 20}});
  expect_slits(cut.slits, {{{30, 9}, {10, 9}}});
  ASSERT_EQ(cut.contour.loop.size(), 5u);
  ASSERT_EQ(cut.contour.origins.size(), 5u);
  EXPECT_EQ(end_of(cut.contour.loop[1]), Vec2(30, 9));
  EXPECT_EQ(start_of(cut.contour.loop[2]), Vec2(30, 9));
  EXPECT_EQ(cut.contour.origins[2].front().border.border, 4);
  EXPECT_NEAR(signed_area(cut.contour.loop), 600, 1e-9);
}

TEST(Spurs, BeganAtEitherEndOfTheContour) {
  const std::vector<Vec2> corners{{0, 0}, {30, 0}, {30, 9}, {10, 9}, {30, 9}, {30, 20}, {0, 20}};
  for (std::size_t first = 0; first < corners.size(); ++first) {
    std::vector<Vec2> turned = corners;
    std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(first), turned.end());
    const auto cut = without(turned);
    expect_slits(cut.slits, {{{30, 9}, {10, 9}}});
    EXPECT_NEAR(signed_area(cut.contour.loop), 600, 1e-9) << first;
    EXPECT_EQ(cut.contour.loop.size(), 5u) << first;
  }
}

TEST(Spurs, WithOneBankLongerThanTheOther) {
  // Back beyond where it began, and not as far: the rest is contour.
  const auto beyond = without({{0, 0}, {20, 0}, {20, 10}, {10, 10}, {30, 10}, {30, 20}, {0, 20}});
  expect_slits(beyond.slits, {{{10, 10}, {20, 10}}});
  EXPECT_NEAR(signed_area(beyond.contour.loop), 200 + 300, 1e-9);
  const auto short_of = without({{0, 0}, {30, 0}, {30, 10}, {10, 10}, {20, 10}, {20, 20}, {0, 20}});
  expect_slits(short_of.slits, {{{10, 10}, {20, 10}}});
  EXPECT_NEAR(signed_area(short_of.contour.loop), 300 + 200, 1e-9);
}

TEST(Spurs, OfSeveralPiecesBecomeOneSlit) {
  const auto cut = without(
      {{0, 0}, {30, 0}, {30, 9}, {22, 9}, {10, 9}, {14, 9}, {25, 9}, {30, 9}, {30, 20}, {0, 20}});
  expect_slits(cut.slits, {{{30, 9}, {10, 9}}});
  EXPECT_NEAR(signed_area(cut.contour.loop), 600, 1e-9);
}

TEST(Spurs, ThatForkAreSlitsOfTheirOwn) {
  const auto cut = without({{0, 0},
                            {30, 0},
                            {30, 9},
                            {20, 9},
                            {15, 4},
                            {20, 9},
                            {15, 14},
                            {20, 9},
                            {30, 9},
                            {30, 20},
                            {0, 20}});
  expect_slits(cut.slits, {{{30, 9}, {20, 9}}, {{20, 9}, {15, 4}}, {{20, 9}, {15, 14}}});
  EXPECT_NEAR(signed_area(cut.contour.loop), 600, 1e-9);
}

TEST(Spurs, ThatOneBridgesBecomeOneSlit) {
  // From below, tips at 5 and, from above, at 15 of 20; last a piece from side to side over both.
  for (const bool bridge : {false, true}) {
    std::vector<Vec2> corners{{0, 0}, {10, 0}, {10, 5}, {10, 0}, {30, 0}, {30, 20}, {10, 20}};
    corners.emplace_back(10, 15);
    if (bridge) corners.emplace_back(10, 4);
    corners.emplace_back(10, 20);
    corners.emplace_back(0, 20);
    const auto cut = without(corners);
    if (bridge)
      expect_slits(cut.slits, {{{10, 0}, {10, 20}}});
    else
      expect_slits(cut.slits, {{{10, 0}, {10, 5}}, {{10, 20}, {10, 15}}});
    EXPECT_NEAR(signed_area(cut.contour.loop), 600, 1e-9);
  }
}

TEST(Spurs, ContourOfNothingElseIsGone) {
  const auto cut = without({{10, 5}, {20, 5}, {26, 5}, {14, 5}});
  EXPECT_TRUE(cut.contour.loop.empty());
  expect_slits(cut.slits, {{{10, 5}, {26, 5}}});
}

TEST(Spurs, CollinearOnesWithAGapStayApart) {
  const auto cut = without({{0, 0},
                            {10, 0},
                            {10, 5},
                            {10, 0},
                            {30, 0},
                            {30, 20},
                            {10, 20},
                            {10, 15},
                            {10, 20},
                            {0, 20}});
  expect_slits(cut.slits, {{{10, 0}, {10, 5}}, {{10, 20}, {10, 15}}});
}

}  // namespace
}  // namespace planish::test
