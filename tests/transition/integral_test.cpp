#include "integral.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace planish::test {
namespace {

using namespace transition_detail;

TEST(Integral, IsExactForPolynomialsOfTheFifteenthDegree) {
  EXPECT_NEAR(integral([](double x) { return 16.0 * std::pow(x, 15); }, 0.0, 1.0), 1.0, 1e-15);
  EXPECT_NEAR(integral([](double x) { return 16.0 * std::pow(x, 15); }, 1.0, 0.0), -1.0, 1e-15);
  EXPECT_EQ(integral([](double) { return 1.0; }, 2.0, 2.0), 0.0);
}

TEST(Integral, HalvesPartsUntilASharpPeakIsSeen) {
  const double width = 1e-3;
  const auto peak = [&](double x) { return width / (width * width + x * x); };
  EXPECT_NEAR(integral(peak, -1.0, 1.0), 2.0 * std::atan(1.0 / width), 1e-11);
}

TEST(IntegralOver, IsExactOverKinksThatItIsTold) {
  const auto kinked = [](double x) { return std::abs(x - 0.3); };
  EXPECT_NEAR(integral_over(kinked, {-1.0, 0.3, 2.0}), 0.5 * (1.3 * 1.3 + 1.7 * 1.7), 1e-14);
}

TEST(PartIntegral, KnowsWhereAnAmountIsReached) {
  // ∫ (1 + x) from 0 to x is x + x²/2.
  const PartIntegral part([](double x) { return 1.0 + x; }, 0.0, 2.0);
  EXPECT_NEAR(part.whole(), 4.0, 1e-14);
  EXPECT_NEAR(part.first_half(), 1.5, 1e-14);
  for (const double amount : {0.0, 0.1, 1.5, 3.9, 4.0})
    EXPECT_NEAR(part.place_of(amount), std::sqrt(1.0 + 2.0 * amount) - 1.0, 1e-13);
}

TEST(AddParts, DividesUntilPartsAreNearlyPolynomials) {
  std::vector<PartIntegral> parts;
  add_parts(
      parts, [](double x) { return std::exp(5.0 * x); }, 0.0, 2.0);
  EXPECT_GT(parts.size(), 2u);
  double sum = 0.0;
  for (const PartIntegral& part : parts)
    sum += part.whole();
  const double exact = (std::exp(10.0) - 1.0) / 5.0;
  EXPECT_NEAR(sum / exact, 1.0, 2e-9);
  // Up to where half of it is reached.
  double behind = 0.0;
  std::size_t at = 0;
  while (behind + parts[at].whole() < 0.5 * exact)
    behind += parts[at++].whole();
  EXPECT_NEAR(parts[at].place_of(0.5 * exact - behind),
              std::log(0.5 * (1.0 + std::exp(10.0))) / 5.0, 1e-8);
}

}  // namespace
}  // namespace planish::test
