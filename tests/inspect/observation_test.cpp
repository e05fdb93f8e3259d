#include "observation.hpp"

#include <gtest/gtest.h>

namespace planish::test {
namespace {

using namespace inspect_detail;

Observation hole(int number, double excess, Severity severity = Severity::info) {
  return {
      "smallest_opening", {severity, "hole " + std::to_string(number), {Vec2(number, 0)}}, excess};
}

TEST(Grouped, LeavesOnePlaceItsSentence) {
  const auto findings = grouped({hole(3, -1.0)});
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].code, "smallest_opening");
  EXPECT_EQ(findings[0].message, "hole 3");
  EXPECT_EQ(findings[0].severity, Severity::info);
  EXPECT_EQ(findings[0].places.size(), 1u);
}

TEST(Grouped, MakesOneFindingOfARuleWithTheWorstPlaceFirst) {
  std::vector<Observation> many{hole(0, -1.0), hole(1, -3.0), hole(2, -2.0, Severity::warning)};
  many.push_back({"hem", {Severity::info, "a hem", {}}, -9.0});
  many.push_back(hole(4, -1.0, Severity::warning));
  const auto findings = grouped(many);
  ASSERT_EQ(findings.size(), 2u);
  EXPECT_EQ(findings[0].message, "4 openings are too small; the worst: hole 2");
  EXPECT_EQ(findings[0].severity, Severity::warning);
  std::vector<double> order;
  for (const Vec2& p : findings[0].at)
    order.push_back(p.x());
  EXPECT_EQ(order, (std::vector<double>{2, 4, 1, 0})) << "warnings first, then the smallest";
  EXPECT_EQ(findings[1].message, "a hem");
}

TEST(Grouped, TellsWarningsBeforeInfo) {
  std::vector<Observation> all{{"hem", {Severity::info, "a hem", {}}, -9.0}, hole(1, -1.0)};
  all.push_back({"k_factor", {Severity::warning, "a K", {}}, 0.0});
  const auto findings = grouped(all);
  ASSERT_EQ(findings.size(), 3u);
  EXPECT_EQ(findings[0].code, "k_factor");
  EXPECT_EQ(findings[1].code, "hem");
  EXPECT_EQ(findings[2].code, "smallest_opening");
}

TEST(SeverityOf, IsAWarningBelowAShareOfTheLimit) {
  Rules rules;
  EXPECT_EQ(severity_of(0.9, 2.0, kHalf, rules), Severity::warning);
  EXPECT_EQ(severity_of(1.0, 2.0, kHalf, rules), Severity::info) << "drawn at the limit";
  EXPECT_EQ(severity_of(0.9, 2.0, kQuarter, rules), Severity::info);
  rules.strict = true;
  EXPECT_EQ(severity_of(1.9, 2.0, kHalf, rules), Severity::warning);
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
