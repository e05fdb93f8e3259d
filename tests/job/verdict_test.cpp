#include "verdict.hpp"

#include "job/sample_reports.hpp"

#include <planish/sheet/codes.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace planish::job {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr double kVolume = 11843.0;
constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

Certificate perfect() {
  Certificate certificate;
  certificate.flat_area_half = 5921.5;
  certificate.volume_ratio = 1.0;
  certificate.explained_ratio = 1.0;
  return certificate;
}

std::vector<Finding> doubts_of(const Certificate& certificate) {
  return doubts(certificate, test::sample_pattern(), kVolume, {});
}

TEST(Verdict, HasNothingToSayOfAPerfectPattern) {
  EXPECT_TRUE(doubts_of(perfect()).empty());
  EXPECT_FALSE(disbelief(perfect(), kVolume, {}).has_value());
}

TEST(Verdict, WarnsAboveEachBoundWithThePlace) {
  Certificate certificate = perfect();
  certificate.length_error = 0.02;
  certificate.length_error_at = {3, 4};
  certificate.refold_deviation = 0.03;
  certificate.refold_at = {5, 6};
  const auto found = doubts_of(certificate);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].code, "edge_length");
  EXPECT_EQ(found[0].at, std::vector<Vec2>{Vec2(3, 4)});
  EXPECT_EQ(found[1].code, "refold");
  EXPECT_EQ(found[1].at, std::vector<Vec2>{Vec2(5, 6)});
  EXPECT_FALSE(disbelief(certificate, kVolume, {}).has_value());
}

TEST(Verdict, CallsALostOpeningAnErrorWithItsPlace) {
  Certificate certificate = perfect();
  certificate.openings = {.solid = 3, .pattern = 1, .features = 1, .loops = 0, .missing = {{7, 8}}};
  const auto found = doubts_of(certificate);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].code, "lost_opening");
  EXPECT_EQ(found[0].severity, Severity::error);
  EXPECT_EQ(found[0].at, std::vector<Vec2>{Vec2(7, 8)});
  EXPECT_THAT(found[0].message, HasSubstr("the solid has 3 openings, the pattern 2: one is lost"));
  certificate.openings.pattern = 4;
  EXPECT_EQ(doubts_of(certificate).at(0).code, "extra_opening");
  certificate.openings.pattern = 2;
  EXPECT_TRUE(doubts_of(certificate).empty());
}

TEST(Verdict, NotesPilotHolesAndWhatIsNotCut) {
  FlatPattern flat = test::sample_pattern();
  flat.features = {{"formed", FormSide::up, {{Arc{{20, 30}, 4.0, 0.0, 6.28}}}, 0, {{20, 30}}},
                   {"formed", FormSide::up, {{Arc{{50, 30}, 4.0, 0.0, 6.28}}}, 2, {}}};
  const auto found = doubts(perfect(), flat, kVolume, {});
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].code, "pilot_hole");
  EXPECT_EQ(found[1].code, "uncut_opening");
  for (const Finding& finding : found) {
    EXPECT_EQ(finding.severity, Severity::info);
    EXPECT_EQ(finding.at.size(), 1u);
  }
  EXPECT_EQ(found[0].at.at(0), Vec2(20, 30));
  EXPECT_NEAR((found[1].at.at(0) - Vec2(50, 30)).norm(), 0.0, 1e-2) << "the middle of its outline";
}

FlatPattern countersunk() {
  FlatPattern flat = test::sample_pattern();
  flat.features = {{"countersink", FormSide::up, {{Arc{{20, 30}, 4.0, 0.0, 6.28}}}}};
  return flat;
}

TEST(Verdict, SaysHowFarTheOtherSkinLiesOffASlantedCut) {
  FlatPattern pattern = test::sample_pattern();
  FlatFeature cut;
  cut.kind = "slanted cut";
  cut.along = {{1, 2}};
  cut.beyond_cut = -6.0;
  pattern.features = {cut};
  const auto within = doubts(perfect(), pattern, kVolume, {});
  ASSERT_EQ(within.size(), 1u);
  EXPECT_EQ(within[0].code, "slanted_cut");
  EXPECT_EQ(within[0].severity, Severity::info) << "it is taken off after cutting";
  EXPECT_THAT(within[0].message, HasSubstr("ends up to 6 mm within it"));
  EXPECT_THAT(within[0].message, Not(HasSubstr("beyond")));
  cut.beyond_cut = 2.0;
  pattern.features.push_back(cut);
  const auto both = doubts(perfect(), pattern, kVolume, {});
  ASSERT_EQ(both.size(), 1u);
  EXPECT_EQ(both[0].severity, Severity::warning) << "material is missing";
  EXPECT_THAT(both[0].message, HasSubstr("reaches up to 2 mm beyond it"));
  EXPECT_THAT(both[0].message, HasSubstr("ends up to 6 mm within it"));
}

TEST(Verdict, SaysNothingOfAVolumeThatMeasuredFeaturesExplain) {
  Certificate certificate = perfect();
  certificate.volume_ratio = 1.004;
  EXPECT_TRUE(doubts(certificate, countersunk(), kVolume, {}).empty());
}

TEST(Verdict, TakesFeaturesThatAreNotMeasuredAsTheCauseOfAVolumeThatDiffers) {
  Certificate certificate = perfect();
  certificate.volume_ratio = 1.004;
  certificate.explained_ratio = kNotANumber;
  const auto found = doubts(certificate, countersunk(), kVolume, {});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].code, "volume_identity");
  EXPECT_EQ(found[0].severity, Severity::warning);
  EXPECT_THAT(found[0].message, HasSubstr("has 1 countersink up, which"));
  ASSERT_EQ(found[0].at.size(), 1u);
  EXPECT_NEAR((found[0].at[0] - Vec2(20, 30)).norm(), 0.0, 1e-2);
  EXPECT_THAT(found[0].message, Not(HasSubstr("missed")));
}

TEST(Verdict, NamesMitresWhereNothingElseIsLeftOut) {
  Certificate certificate = perfect();
  certificate.volume_ratio = 0.98;
  certificate.explained_ratio = 0.9875;
  const auto found = doubts_of(certificate);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_THAT(found[0].message, HasSubstr("; without the mitres of its folds it is 0.9875;"));
  EXPECT_THAT(found[0].message, Not(HasSubstr("without them")));
}

TEST(Verdict, ShowsAChamferAtAnEdge) {
  Certificate certificate = perfect();
  certificate.volume_ratio = 1.004;
  certificate.explained_ratio = kNotANumber;
  FlatPattern flat = test::sample_pattern();
  flat.features = {
      {"chamfer", FormSide::up, {{Segment{{1, 1}, {99, 1}}, Segment{{99, 1}, {1, 1}}}}}};
  EXPECT_EQ(doubts(certificate, flat, kVolume, {}).at(0).at, std::vector<Vec2>{Vec2(50, 1)});
}

TEST(Verdict, TellsWhereAVolumeIsNotMissed) {
  Certificate certificate = perfect();
  certificate.explained_ratio = certificate.volume_ratio = 1.004;
  certificate.opening_error = 1e-9;
  const auto found = doubts(certificate, test::sample_pattern(), kVolume, {});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_THAT(found[0].message, HasSubstr("along the outer contour or in a bend"));
}

TEST(Verdict, ShowsAnOpeningThatIsNotWhatTheSolidLacks) {
  Certificate certificate = perfect();
  certificate.opening_error = 0.04;
  certificate.opening_error_at = {7, 8};
  const auto found = doubts_of(certificate);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].code, "opening_size");
  EXPECT_EQ(found[0].at, std::vector<Vec2>{Vec2(7, 8)});
  EXPECT_FALSE(disbelief(certificate, kVolume, {}).has_value());
  certificate.opening_error = 0.06;
  EXPECT_EQ(disbelief(certificate, kVolume, {})->code, code::pattern_wrong);
}

TEST(Verdict, ShowsWhereTheSolidReachesBeyondTheOutline) {
  Certificate certificate = perfect();
  certificate.outline_error = 0.009;
  EXPECT_TRUE(doubts_of(certificate).empty());
  certificate.outline_error = 0.04;
  certificate.outline_error_at = {7, 8};
  const auto found = doubts_of(certificate);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].code, "outline_size");
  EXPECT_EQ(found[0].at, std::vector<Vec2>{Vec2(7, 8)});
  EXPECT_FALSE(disbelief(certificate, kVolume, {}).has_value());
  certificate.outline_error = 0.06;
  EXPECT_EQ(disbelief(certificate, kVolume, {})->code, code::pattern_wrong);
}

TEST(Verdict, SuspectsWhatTheFeaturesDoNotExplain) {
  Certificate certificate = perfect();
  certificate.explained_ratio = 1.004;
  FlatPattern flat = test::sample_pattern();
  flat.features = {{"countersink", FormSide::up, {{Arc{{20, 30}, 4.0, 0.0, 6.28}}}}};
  const auto found = doubts(certificate, flat, kVolume, {});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_THAT(found[0].message, HasSubstr("a missed feature"));
  EXPECT_EQ(found[0].severity, Severity::warning);
  certificate.volume_ratio = 1.004;
  certificate.explained_ratio = kNotANumber;
  EXPECT_EQ(doubts(certificate, flat, kVolume, {}).at(0).severity, Severity::warning)
      << "forms that could not be measured explain nothing";
}

TEST(Verdict, AllowsMoreWhereFormsCouldNotBeMeasured) {
  Certificate certificate = perfect();
  certificate.volume_ratio = 1.05;
  certificate.explained_ratio = kNotANumber;
  EXPECT_FALSE(disbelief(certificate, kVolume, {}).has_value());
  certificate.explained_ratio = 1.05;
  EXPECT_TRUE(disbelief(certificate, kVolume, {}).has_value());
}

TEST(Verdict, RefusesAPatternThatCannotBeTrusted) {
  for (const double ratio : {0.84, 1.16, 0.0, kNotANumber}) {
    Certificate certificate = perfect();
    certificate.volume_ratio = certificate.explained_ratio = ratio;
    const auto refusal = disbelief(certificate, kVolume, {});
    ASSERT_TRUE(refusal.has_value()) << ratio;
    EXPECT_EQ(refusal->code, code::pattern_wrong);
  }
  Certificate stretched = perfect();
  stretched.length_error = 0.6;
  stretched.length_error_at = {3, 4};
  EXPECT_THAT(disbelief(stretched, kVolume, {})->where, HasSubstr("(3, 4)"));
  Certificate torn = perfect();
  torn.refold_deviation = 0.6;
  EXPECT_EQ(disbelief(torn, kVolume, {})->code, code::pattern_wrong);
}

TEST(Verdict, HasNoVolumeToCompareWithWhereThereIsNoSolid) {
  Certificate certificate = perfect();
  certificate.volume_ratio = certificate.explained_ratio = kNotANumber;
  EXPECT_FALSE(disbelief(certificate, 0.0, {}).has_value());
  EXPECT_TRUE(doubts(certificate, test::sample_pattern(), 0.0, {}).empty());
}

TEST(Verdict, GoesByTheBoundsItIsGiven) {
  Certificate certificate = perfect();
  certificate.volume_ratio = certificate.explained_ratio = 1.015;
  CertificateBounds strict;
  strict.volume_refusal = 0.01;
  EXPECT_TRUE(disbelief(certificate, kVolume, strict).has_value());
  CertificateBounds lenient;
  lenient.volume_warning = 0.1;
  EXPECT_TRUE(doubts(certificate, test::sample_pattern(), kVolume, lenient).empty());
}

TEST(Verdict, MakesOneRefusalOfSeveralOverlaps) {
  EXPECT_FALSE(overlap_refusal({}).has_value());
  const Finding one{"overlap", Severity::error, "12.5 mm² are covered twice", {{1, 2}, {3, 4}}};
  const auto refusal = overlap_refusal({one, one, one});
  ASSERT_TRUE(refusal.has_value());
  EXPECT_EQ(refusal->code, code::overlap);
  EXPECT_THAT(refusal->message, HasSubstr("12.5 mm² are covered twice, and at 2 more places"));
  EXPECT_THAT(refusal->where, HasSubstr("(1, 2)"));
}

TEST(Verdict, AsksAboutASizeThatNoShopHas) {
  for (const auto& [thickness, length] :
       {std::pair{0.02, 3.0}, {0.5, 30.0}, {3.0, 12000.0}, {300.0, 8000.0}})
    EXPECT_FALSE(size_doubt(thickness, length)) << thickness;
  // Metres for millimetres, and the other way round.
  for (const auto& [thickness, length] :
       {std::pair{2000.0, 86094.0}, {0.002, 0.086}, {500.0, 2000.0}, {20.0, 40000.0}}) {
    const auto doubt = size_doubt(thickness, length);
    ASSERT_TRUE(doubt) << thickness;
    EXPECT_EQ(doubt->code, "unlikely_size");
    EXPECT_EQ(doubt->severity, Severity::warning);
    ASSERT_EQ(doubt->numbers.size(), 2u);
    EXPECT_EQ(doubt->numbers[0].quantity.value, thickness);
  }
}

TEST(Verdict, RefusesAnErrorUnderItsOwnCodeUnlessItIsWrittenAnyway) {
  const Finding lost{"lost_opening", Severity::error, "the solid has 8 openings, one is lost", {}};
  const Finding extra{"extra_opening", Severity::error, "the pattern has one too many", {}};
  const Finding through{
      "self_intersection", Severity::error, "flange 3 runs through itself", {{5, 6}}};
  const Finding covers{"overlap", Severity::error, "3 mm² are covered twice", {{1, 2}}};
  const Finding low{"flange_height", Severity::warning, "bend B1 leaves 2 mm", {{7, 8}}};
  EXPECT_FALSE(error_refusal({}, {}));
  EXPECT_FALSE(error_refusal({low, covers}, {}))
      << "a warning writes; an overlap refuses by itself";
  for (const Finding& finding : {lost, extra, through}) {
    const auto refusal = error_refusal({low, finding}, {});
    ASSERT_TRUE(refusal) << finding.code;
    EXPECT_EQ(refusal->code.name, finding.code);
    EXPECT_EQ(refusal->code.status, ExitStatus::refused);
    ASSERT_EQ(refusal->remedies.size(), 1u);
    EXPECT_EQ(refusal->remedies[0].option, "write_anyway");
  }
  const auto both = error_refusal({lost, low, through}, {});
  ASSERT_TRUE(both);
  EXPECT_THAT(both->message, HasSubstr("The solid has 8 openings, one is lost, and 1 more error is "
                                       "found. Set `write_anyway`"));
  PatternChecks checks;
  checks.write_anyway = true;
  EXPECT_FALSE(error_refusal({covers, lost, through}, checks));
}

}  // namespace
}  // namespace planish::job
