#include "observation.hpp"

#include <gtest/gtest.h>

namespace planish::test {
namespace {

using namespace inspect_detail;

Observation hole(int number, double excess) {
  return {
      {"smallest_opening", Severity::warning, "hole " + std::to_string(number), {Vec2(number, 0)}},
      "Ø 1 mm",
      "holes are too small",
      excess};
}

TEST(Grouped, KeepsTenOfAKindApart) {
  std::vector<Observation> ten;
  for (int i = 0; i < 10; ++i)
    ten.push_back(hole(i, -1.0));
  const auto findings = grouped(ten);
  ASSERT_EQ(findings.size(), 10u);
  EXPECT_EQ(findings[7].message, "hole 7");
}

TEST(Grouped, MakesMoreThanTenOneFindingWithTheWorstOfThem) {
  std::vector<Observation> many;
  for (int i = 0; i < 11; ++i)
    many.push_back(hole(i, i == 4 ? -3.0 : -1.0));
  many.push_back(hole(99, -9.0));
  many.back().kind = "another";
  const auto findings = grouped(many);
  ASSERT_EQ(findings.size(), 2u);
  EXPECT_EQ(findings[0].message, "11 holes are too small; the worst: hole 4");
  ASSERT_EQ(findings[0].at.size(), 11u);
  EXPECT_EQ(findings[0].at[10], Vec2(10, 0));
  EXPECT_EQ(findings[1].message, "hole 99");
}

TEST(NumberText, HasAtMostThreeDecimals) {
  EXPECT_EQ(number_text(2.0), "2");
  EXPECT_EQ(number_text(2.5004), "2.5");
  EXPECT_EQ(number_text(-0.0004), "0");
  EXPECT_EQ(mm_text(1.23456), "1.235 mm");
  EXPECT_EQ(point_text({1.5, -20}), "(1.5, -20)");
}

TEST(FactorsText, OmitsFactorsOfZeroAndOne) {
  EXPECT_EQ(factors_text(1.5, 1.0), "1.5 T + R");
  EXPECT_EQ(factors_text(1.0), "T");
  EXPECT_EQ(factors_text(0.0, 2.0), "2 R");
}

}  // namespace
}  // namespace planish::test
