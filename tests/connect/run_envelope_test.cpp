#include "run_envelope.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <random>

namespace planish::test {
namespace {

using connect_detail::RunEnvelope;

std::vector<Vec2> ragged(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> height(0.0, 50.0), step(0.1, 5.0);
  std::vector<Vec2> corners;
  double x = 0.0;
  for (int i = 0; i < count; ++i)
    corners.emplace_back(x += step(random), height(random));
  return corners;
}

RC_GTEST_PROP(RunEnvelope, FindsTheCornersThatASearchOfAllFinds, ()) {
  const int count = *rc::gen::inRange(2, 200);
  const auto corners = ragged(count, *rc::gen::arbitrary<unsigned>());
  const RunEnvelope envelope(corners);
  const int first = *rc::gen::inRange(0, count), last = *rc::gen::inRange(first, count);
  const double k = *rc::gen::inRange(-5000, 5000) / 1000.0;
  double lowest = -1e300, highest = -1e300;
  for (int i = first; i <= last; ++i) {
    lowest = std::max(lowest, k * corners[i].x() - corners[i].y());
    highest = std::max(highest, corners[i].y() - k * corners[i].x());
  }
  const Vec2 low = envelope.lowest(first, last, k), high = envelope.highest(first, last, k);
  RC_ASSERT(k * low.x() - low.y() == lowest);
  RC_ASSERT(high.y() - k * high.x() == highest);
}

TEST(RunEnvelope, TakesOneCorner) {
  const RunEnvelope envelope({{0, 5}, {1, 2}, {2, 9}});
  EXPECT_EQ(envelope.lowest(1, 1, 3.0), Vec2(1, 2));
  EXPECT_EQ(envelope.highest(1, 1, 3.0), Vec2(1, 2));
}

}  // namespace
}  // namespace planish::test
