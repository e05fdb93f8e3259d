#include "united_regions.hpp"

#include "guarded.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace planish::brep::test {
namespace {

using std::numbers::pi;
using Pieces = std::vector<std::vector<BorderPiece>>;

BorderLoop rectangle(double x0, double y0, double x1, double y1) {
  const Vec2 a(x0, y0), b(x1, y0), c(x1, y1), d(x0, y1);
  return {{.curve = Segment{a, b}},
          {.curve = Segment{b, c}},
          {.curve = Segment{c, d}},
          {.curve = Segment{d, a}}};
}

BorderLoop circle(const Vec2& centre, double radius, double sweep) {
  return {{.curve = Arc{centre, radius, 0.0, sweep}}};
}

std::optional<Pieces> united(const std::vector<PlaneRegion>& regions) {
  return guarded([&] { return united_regions(regions); }).value();
}

double area_of(const Pieces& pieces) {
  double area = 0.0;
  for (const auto& loop : pieces)
    for (const BorderPiece& piece : loop)
      area += green_area(piece.border.curve);
  return area;
}

void expect_closed(const Pieces& pieces) {
  for (const auto& loop : pieces)
    for (size_t i = 0; i < loop.size(); ++i) {
      const Vec2 next = start_of(loop[(i + 1) % loop.size()].border.curve);
      EXPECT_NEAR((end_of(loop[i].border.curve) - next).norm(), 0.0, 1e-9);
    }
}

TEST(UnitedRegions, OfOneIsItself) {
  const auto pieces = united({{rectangle(0, 0, 4, 3), circle({2, 1}, 0.5, -2 * pi)}});
  ASSERT_TRUE(pieces);
  ASSERT_EQ(pieces->size(), 2u);
  EXPECT_NEAR(area_of(*pieces), 12 - pi / 4, 1e-12);
  EXPECT_TRUE(pieces->back().front().whole);
}

TEST(UnitedRegions, CutBordersWhereTheyCross) {
  const auto pieces = united({{rectangle(0, 0, 10, 10)}, {rectangle(4, 6, 6, 13)}});
  ASSERT_TRUE(pieces);
  ASSERT_EQ(pieces->size(), 1u);
  EXPECT_NEAR(area_of(*pieces), 106.0, 1e-9);
  expect_closed(*pieces);
  int whole = 0, second = 0;
  for (const BorderPiece& piece : pieces->front()) {
    whole += piece.whole ? 1 : 0;
    second += piece.region;
  }
  EXPECT_EQ(whole, 4) << "three sides of the one, the far side of the other";
  EXPECT_EQ(second, 3);
}

TEST(UnitedRegions, FillAnOpeningAndOpenItElsewhere) {
  // A pocket of radius 5 with its floor, in which a bore is left open.
  const Vec2 at(20, 20);
  const auto pieces = united({{rectangle(0, 0, 40, 40), circle(at, 5, -2 * pi)},
                              {circle(at, 5, 2 * pi), circle(at + Vec2(1, 0), 2, -2 * pi)}});
  ASSERT_TRUE(pieces);
  ASSERT_EQ(pieces->size(), 2u);
  EXPECT_NEAR(area_of(*pieces), 1600 - 4 * pi, 1e-9);
  EXPECT_EQ(pieces->back().front().region, 1);
}

TEST(UnitedRegions, KeepArcsThatCrossTheEndsOfCirclesThatCoincide) {
  // The same circle begun at two places, with a tab across the end of the one.
  const Vec2 at(20, 20);
  BorderLoop tab = rectangle(20, 18, 26, 22);
  const auto pieces = united({{rectangle(0, 0, 40, 40), circle(at, 5, -2 * pi)}, {tab}});
  ASSERT_TRUE(pieces);
  const double half = std::asin(2.0 / 5);
  const double kept = 25 * half + 10 * std::cos(half);  // of the tab, within the circle
  EXPECT_NEAR(area_of(*pieces), 1600 - 25 * pi + kept, 1e-8);
  expect_closed(*pieces);
}

TEST(UnitedRegions, AreNoneWhereTheyDoNotHangTogether) {
  EXPECT_FALSE(united({{rectangle(0, 0, 4, 3)}, {rectangle(5, 0, 6, 3)}}));
}

}  // namespace
}  // namespace planish::brep::test
