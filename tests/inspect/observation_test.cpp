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

TEST(Told, BeginsInTheMiddleOfALine) {
  EXPECT_EQ(told("{@bend} is off", {{"bend", place::bend("B2")}}).sentence, "bend B2 is off");
  EXPECT_EQ(
      told("{@bend} meet", {{"bend", place::bend("B2")}, {"bend", place::bend("B3")}}).sentence,
      "bends B2 and B3 meet");
}

TEST(Breach, KeepsWhatItsSentenceIsMadeOf) {
  const FindingPlace place = breach(Severity::info,
                                    "{@bend} is {measured} wide; {wanted} is needed",
                                    {{"bend", place::bend("B2")},
                                     {"flange", place::flange(3)},
                                     {"measured", 1.5, unit::mm},
                                     {"wanted", 2.0, unit::mm}},
                                    {Vec2(1, 2)});
  EXPECT_EQ(place.message, "bend B2 is 1.5 mm wide; 2 mm is needed");
  EXPECT_EQ(place.places, (std::vector{place::bend("B2"), place::flange(3)}));
  ASSERT_EQ(place.numbers.size(), 2u);
  EXPECT_EQ(place.numbers[0].name, "measured");
  EXPECT_EQ(place.numbers[1].quantity, (Quantity{2.0, unit::mm}));
}

TEST(Breach, AsksForItsLimitOnlyWhereItWarns) {
  const Facts facts{{"measured", 3.99, unit::mm}, {"wanted", 6.0, unit::mm}, {"rule", "2 T"}};
  const auto said = [&](Severity severity, const Facts& of) {
    return breach(severity, "it is {measured}; {limit}", of, {}).message;
  };
  EXPECT_EQ(said(Severity::warning, facts), "it is 3.99 mm; at least 6 mm (2 T) is needed");
  EXPECT_EQ(said(Severity::info, facts), "it is 3.99 mm; the rule of thumb is 6 mm (2 T)");
  const Facts bare(facts.begin(), facts.begin() + 2);
  EXPECT_EQ(said(Severity::warning, bare), "it is 3.99 mm; at least 6 mm is needed");
  EXPECT_EQ(said(Severity::info, bare), "it is 3.99 mm; the rule of thumb is 6 mm");
}

TEST(Grouped, CallsInformationUnusualAndNotWrong) {
  const auto many = [](Severity severity) {
    const Observation one{"opening_to_bend", breach(severity, "near", {}, {}), -1.0};
    return grouped({one, one}).front().message;
  };
  EXPECT_EQ(many(Severity::warning), "2 openings are too close to bends; the worst: near");
  EXPECT_EQ(many(Severity::info), "2 openings are closer to bends than usual; the worst: near");
}

TEST(Grouped, HasThePlacesAndNumbersOfTheWorst) {
  const auto one = [](const char* bend, double measured) {
    return Observation{"bend_relief",
                       breach(Severity::warning, "{@bend}: {measured}",
                              {{"bend", place::bend(bend)}, {"measured", measured, unit::mm}}, {}),
                       measured - 2.0};
  };
  const auto single = grouped({one("B1", 1.5)}).at(0);
  EXPECT_EQ(single.about, std::vector{place::bend("B1")});
  ASSERT_EQ(single.numbers.size(), 1u);
  const auto both = grouped({one("B1", 1.5), one("B2", 0.5)}).at(0);
  EXPECT_EQ(both.about, std::vector{place::bend("B2")});
  ASSERT_EQ(both.numbers.size(), 2u);
  EXPECT_EQ(both.numbers[0].quantity, Quantity{2.0});  // places
  EXPECT_EQ(both.numbers[1].quantity, (Quantity{0.5, unit::mm}));
}

TEST(FactorsText, OmitsFactorsOfZeroAndOne) {
  EXPECT_EQ(factors_text(1.5, 1.0), "1.5 T + R");
  EXPECT_EQ(factors_text(1.0), "T");
  EXPECT_EQ(factors_text(0.0, 2.0), "2 R");
}

}  // namespace
}  // namespace planish::test
