#include <planish/geometry/interval.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace planish {
namespace {

bool holds(const std::vector<Interval>& intervals, double x) {
  return std::ranges::any_of(intervals,
                             [&](const Interval& one) { return one.lo <= x && x <= one.hi; });
}

/// On a grid of whole and half numbers every union can be looked up point by point.
std::vector<Interval> on_grid(std::mt19937& random) {
  std::uniform_int_distribution<int> place(0, 40), size(0, 6), count(0, 9);
  std::vector<Interval> intervals(static_cast<std::size_t>(count(random)));
  for (Interval& one : intervals) {
    one.lo = place(random);
    one.hi = one.lo + size(random);
  }
  return intervals;
}

TEST(Intervals, JoinedHoldWhatTheyHeldAndLieApart) {
  std::mt19937 random(1);
  for (int run = 0; run < 500; ++run) {
    const std::vector<Interval> given = on_grid(random), made = joined(given, 0.0);
    for (double x = -1.0; x <= 50.0; x += 0.5)
      EXPECT_EQ(holds(made, x), holds(given, x)) << run << " at " << x;
    for (std::size_t i = 1; i < made.size(); ++i)
      EXPECT_GT(made[i].lo, made[i - 1].hi);
    double covered = 0.0;  // unit cells, by their middles
    for (double x = 0.5; x < 50.0; x += 1.0)
      covered += holds(given, x) ? 1.0 : 0.0;
    EXPECT_EQ(total(made), covered);
  }
}

TEST(Intervals, TouchWithinWhatIsGiven) {
  const std::vector<Interval> given{{5.0, 6.0}, {0.0, 2.0}, {3.0, 4.0}};
  EXPECT_EQ(joined(given, 0.99).size(), 3u);
  const auto one = joined(given, 1.0);
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(one.front().lo, 0.0);
  EXPECT_EQ(one.front().hi, 6.0);
  EXPECT_TRUE(joined({}, 1.0).empty());
}

TEST(Intervals, DistanceIsThatOfTheirNearestPoints) {
  std::mt19937 random(2);
  std::uniform_int_distribution<int> place(0, 20), size(0, 8);
  for (int run = 0; run < 300; ++run) {
    const double a = place(random), b = place(random);
    const Interval first{a, a + size(random)}, second{b, b + size(random)};
    double least = 1e9;
    for (double x = first.lo; x <= first.hi; x += 1.0)
      for (double y = second.lo; y <= second.hi; y += 1.0)
        least = std::min(least, std::abs(x - y));
    EXPECT_EQ(distance(first, second), least);
  }
}

}  // namespace
}  // namespace planish
