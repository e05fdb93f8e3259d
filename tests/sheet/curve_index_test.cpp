#include "curve_index.hpp"

#include <gtest/gtest.h>

#include <random>

namespace planish::sheet_detail {
namespace {

std::vector<Curve2> random_curves(std::mt19937& random, int count) {
  std::uniform_real_distribution<double> place(-100.0, 100.0), size(0.01, 60.0), turn(-6.0, 6.0);
  std::vector<Curve2> curves;
  for (int i = 0; i < count; ++i) {
    const Vec2 a(place(random), place(random)), b(place(random), place(random));
    if (i % 3 == 0)
      curves.emplace_back(Segment{a, b});
    else if (i % 3 == 1)
      curves.emplace_back(Arc{a, size(random), turn(random), turn(random)});
    else
      curves.emplace_back(CubicSpline{{a, a + Vec2(5, 1), b + Vec2(-2, 3), b}});
  }
  return curves;
}

TEST(CurveIndex, FindsWhatLookingAtEveryCurveFinds) {
  std::mt19937 random(7);
  for (const int count : {1, 2, 9, 60}) {
    const std::vector<Curve2> curves = random_curves(random, count);
    const CurveIndex index(curves);
    std::uniform_real_distribution<double> place(-300.0, 300.0);
    for (int i = 0; i < 200; ++i) {
      const Vec2 p(place(random), place(random));
      double least = std::numeric_limits<double>::infinity();
      for (const Curve2& curve : curves)
        least = std::min(least, nearest(curve, p).distance);
      const auto hit = index.nearest(p);
      ASSERT_TRUE(hit);
      EXPECT_NEAR(hit->distance, least, 1e-12 * (1.0 + least));
      EXPECT_NEAR((hit->point - p).norm(), least, 1e-9 * (1.0 + least));
    }
  }
}

TEST(CurveIndex, HasNothingNearWhereThereIsNothing) {
  EXPECT_FALSE(CurveIndex({}).nearest({0, 0}));
}

TEST(CurveIndex, HoldsCurvesThatAreOnePoint) {
  const CurveIndex index({Segment{{3, 4}, {3, 4}}});
  EXPECT_NEAR(index.nearest({0, 0})->distance, 5.0, 1e-12);
}

}  // namespace
}  // namespace planish::sheet_detail
