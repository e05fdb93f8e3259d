#include "gap.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace planish::test {
namespace {

using namespace inspect_detail;
using std::numbers::pi;

void expect_gap(const Gap& gap, double distance, const Vec2& a, const Vec2& b) {
  EXPECT_NEAR(gap.distance, distance, 1e-9);
  EXPECT_NEAR((gap.a - a).norm(), 0.0, 1e-6);
  EXPECT_NEAR((gap.b - b).norm(), 0.0, 1e-6);
}

TEST(Gap, OfSegmentsIsAtAnEndOrZeroWhereTheyCross) {
  const Segment level{{0, 0}, {10, 0}};
  expect_gap(gap_between(level, Segment{{4, 3}, {4, 9}}), 3.0, {4, 0}, {4, 3});
  expect_gap(gap_between(level, Segment{{13, 4}, {20, 4}}), 5.0, {10, 0}, {13, 4});
  expect_gap(gap_between(level, Segment{{2, -1}, {4, 1}}), 0.0, {3, 0}, {3, 0});
}

TEST(Gap, OfCirclesLiesOnTheLineOfTheirCentres) {
  const Arc a{{0, 0}, 2.0, 0.3, 2 * pi}, b{{6, 8}, 3.0, 1.0, -2 * pi};
  expect_gap(gap_between(a, b), 5.0, {1.2, 1.6}, {4.2, 5.6});
  expect_gap(gap_between(b, a), 5.0, {4.2, 5.6}, {1.2, 1.6});
}

TEST(Gap, OfACircleWithinAnotherIsTheDifferenceOfRadii) {
  const Gap gap = gap_between(Arc{{1, 0}, 2.0, 0.0, 2 * pi}, Arc{{0, 0}, 10.0, 0.0, 2 * pi});
  expect_gap(gap, 7.0, {3, 0}, {10, 0});
}

TEST(Gap, OfAnArcAndASegmentIsAtTheArcsTop) {
  // A half circle of radius 3 below the line y = 5.
  const Arc half{{1, 0}, 3.0, 0.0, pi};
  expect_gap(gap_between(half, Segment{{-9, 5}, {9, 5}}), 2.0, {1, 3}, {1, 5});
  expect_gap(gap_between(Segment{{-9, 5}, {9, 5}}, half), 2.0, {1, 5}, {1, 3});
}

TEST(Gap, OfArcsIsFoundWhereverItsPlaceIsBetweenSamples) {
  // Of an arc and a line it is where the line's normal through the centre meets the arc; of two
  // arcs on the line of their centres.
  for (int i = 0; i < 40; ++i) {
    const double at = 0.3 + 0.0613 * i;  // direction from the centre
    const Vec2 out(std::cos(at), std::sin(at)), center(5, -3);
    const Arc arc{center, 20.0, 0.1, 2.9};
    const Vec2 foot = center + 27.0 * out, along(-out.y(), out.x());
    const Segment line{foot - 11.0 * along, foot + 17.0 * along};
    expect_gap(gap_between(arc, line), 7.0, center + 20.0 * out, foot);
    expect_gap(gap_between(line, arc), 7.0, foot, center + 20.0 * out);
    const Arc other{center + 36.0 * out, 12.0, at + pi - 1.3, 2.2};
    expect_gap(gap_between(arc, other), 4.0, center + 20.0 * out, center + 24.0 * out);
  }
}

TEST(Gap, OfASplineIsThatOfItsParabola) {
  // y = x² for x from −1 to 1; nearest to (0, −2) is its vertex, to (3, 1) its end.
  const CubicSpline parabola{{{-1, 1}, {-1.0 / 3, -1.0 / 3}, {1.0 / 3, -1.0 / 3}, {1, 1}}};
  expect_gap(gap_between(parabola, Segment{{-5, -2}, {5, -2}}), 2.0, {0, 0}, {0, -2});
  expect_gap(gap_between(parabola, Segment{{3, 1}, {3, 5}}), 2.0, {1, 1}, {3, 1});
}

Loop square_at(double x) {
  return {Segment{{x, 0}, {x + 1, 0}}, Segment{{x + 1, 0}, {x + 1, 1}}, Segment{{x + 1, 1}, {x, 1}},
          Segment{{x, 1}, {x, 0}}};
}

TEST(Gap, OfLoopsIsFoundWithinItsReachOnly) {
  const Loop first = square_at(0), second = square_at(4);
  const BoxedLoop a(first), b(second);
  EXPECT_DOUBLE_EQ(gap_between(a, b, 3.5).distance, 3.0);
  EXPECT_TRUE(std::isinf(gap_between(a, b, 2.9).distance));
  EXPECT_DOUBLE_EQ(gap_between(a, Segment{{0.5, 3}, {0.5, 8}}, 5.0).distance, 2.0);
}

}  // namespace
}  // namespace planish::test
