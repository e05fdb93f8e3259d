#include "lay_flat.hpp"

#include "support/sheets.hpp"

#include <planish/sheet/codes.hpp>

#include <gtest/gtest.h>

#include <numbers>

namespace planish::job {
namespace {

using namespace planish::test;

const EdgeDistance kUnmeasured;

/// A sheet laid flat with K = 0.4 and no solid.
Report laid(const Sheet& sheet, const PatternChecks& checks = {}, ReliefOptions relief = {},
            std::optional<Error>* error = nullptr) {
  Report report;
  report.summary = summary_of(sheet);
  const EdgeDistance distance = border_distance(sheet);
  auto wrong = lay_flat(report, {sheet, distance, checks, {}, relief},
                        {.allowance = ConstantK{0.4, "ours"}}, {});
  if (error)
    *error = wrong;
  else
    EXPECT_FALSE(wrong) << wrong->message;
  return report;
}

/// Two walls beside each other on a base that need `beyond` of each other's room when flat.
Sheet walls_that_meet(double beyond) {
  SheetBuilder builder(1.0);
  const FaceId base = builder.flange(Frame{}, {rectangle(40, 40)});
  for (const int border : {1, 2}) {
    const Rim rim = builder.bend(builder.rim(base, border), Turn{Angle::degrees(90), 2});
    // Where they begin to flare they are an allowance of 3.83 mm beyond the base, and 3 more at its
    // end.
    const double flare = 6.83 + beyond;
    builder.flange_behind(
        rim,
        {polygon({{0, 0}, {40, 0}, {40 + flare, 3}, {40 + flare, 40}, {-flare, 40}, {-flare, 3}})});
  }
  return builder.finish();
}

TEST(SummaryOf, CountsWhatASheetHas) {
  Sheet sheet = u_channel();
  sheet.thickness_spread = 0.01;
  const SheetSummary summary = summary_of(sheet);
  EXPECT_EQ(summary.thickness, 1.5);
  EXPECT_EQ(summary.thickness_spread, 0.01);
  EXPECT_EQ(summary.volume, *sheet.volume);
  EXPECT_EQ(summary.flanges, 3);
  EXPECT_EQ(summary.bends, 2);
  sheet.volume.reset();
  EXPECT_EQ(summary_of(sheet).volume, 0.0);
}

TEST(LayFlat, GivesPatternSizeMassAndCertificate) {
  PatternChecks checks;
  checks.density = 2.7;
  const Sheet sheet = u_channel();
  const Report report = laid(sheet, checks);
  // 30 | 90° r 2 | 40 | 90° r 2 | 30, width 25, t 1.5
  const double length = 100.0 + std::numbers::pi * (2.0 + 0.4 * 1.5);
  EXPECT_NEAR(report.flat.area, 25.0 * length, 1e-6);
  EXPECT_NEAR(report.size.x(), length, 1e-6);
  EXPECT_NEAR(report.size.y(), 25.0, 1e-6);
  EXPECT_NEAR(*report.mass, 2.7e-6 * *sheet.volume, 1e-12);
  EXPECT_NEAR(*report.certificate.volume_ratio, 1.0, 1e-9);
  EXPECT_LT(report.certificate.length_error, 1e-9);
  EXPECT_EQ(report.sheet.faces.size(), sheet.faces.size());
  EXPECT_EQ(report.layout.placement.size(), sheet.faces.size());
}

TEST(LayFlat, TakesTheMassOfThePatternWhereThereIsNoSolid) {
  Sheet sheet = u_channel();
  sheet.volume.reset();
  PatternChecks checks;
  Report report;
  report.summary = summary_of(sheet);
  report.density = 7.85;  // of the file
  const EdgeDistance distance = border_distance(sheet);
  ASSERT_FALSE(lay_flat(report, {sheet, distance, checks}, {}, {}));
  EXPECT_NEAR(*report.mass, 7.85e-6 * report.flat.area * 1.5, 1e-12);
  EXPECT_FALSE(laid(u_channel()).mass) << "nobody says the density";
}

TEST(LayFlat, KnowsTheKOfAllBendsOrThatTheyDiffer) {
  EXPECT_EQ(laid(u_channel()).summary.k_factor, 0.4);
  EXPECT_EQ(laid(u_channel()).summary.k_source, "ours");
  const auto with = [](const Sheet& sheet, const FlattenOptions& options) {
    Report report;
    const PatternChecks checks{.effort = Effort::draft,
                               .rules = {},
                               .bounds = {},
                               .density = {},
                               .bending = {},
                               .shop = {}};
    EXPECT_FALSE(lay_flat(report, {sheet, kUnmeasured, checks}, options, {}));
    return report.summary;
  };
  const auto mixed = with(u_channel(),
                          {.allowance = ConstantK{0.4, "ours"}, .bend_k = {{BendId{0}, 0.3}}});
  EXPECT_FALSE(mixed.k_factor);
  EXPECT_EQ(mixed.k_source, "mixed");
  const auto named = with(u_channel(),
                          {.allowance = ConstantK{0.4, "ours"}, .bend_k = {{BendId{0}, 0.4}}});
  EXPECT_EQ(named.k_factor, 0.4) << "the same from two sources";
  EXPECT_EQ(named.k_source, "mixed");
  SheetBuilder plate(1.0);
  plate.flange(Frame{}, {rectangle(40, 40)});
  const Sheet flat = plate.finish();
  EXPECT_EQ(with(flat, {.allowance = ConstantK{0.3, "rule"}}).k_factor, 0.3);
  EXPECT_EQ(with(flat, {.allowance = ConstantK{0.3, "rule"}}).k_source, "rule");
  EXPECT_FALSE(with(flat, {.allowance = Din6935{}}).k_factor);
}

TEST(LayFlat, DrawsADraftWithoutLookingAtIt) {
  PatternChecks checks;
  checks.effort = Effort::draft;
  const Report report = laid(walls_that_meet(5.0), checks);
  EXPECT_FALSE(report.flat.outer.loop.empty());
  EXPECT_TRUE(report.findings.empty());
  EXPECT_FALSE(report.certificate.volume_ratio);
}

TEST(LayFlat, MendsASmallOverlapAndRefusesALargeOne) {
  std::optional<Error> error;
  Report report = laid(walls_that_meet(0.2), {}, {}, &error);
  ASSERT_FALSE(error) << error->message;
  EXPECT_FALSE(report.reliefs.empty());
  const double mended = report.flat.area;
  report = laid(walls_that_meet(0.2), {}, {.shape = Relief::none}, &error);
  ASSERT_TRUE(error);
  EXPECT_EQ(error->code, code::overlap);
  EXPECT_LT(mended, report.flat.area) << "something was cut away";
  laid(walls_that_meet(20.0), {}, {}, &error);
  ASSERT_TRUE(error);
  EXPECT_EQ(error->code, code::overlap);
  PatternChecks checks;
  checks.write_overlapping = true;
  report = laid(walls_that_meet(20.0), checks, {}, &error);
  EXPECT_FALSE(error);
  EXPECT_TRUE(report.has_warnings());
  checks.write_overlapping = false;
  checks.write_anyway = true;
  laid(walls_that_meet(20.0), checks, {}, &error);
  EXPECT_FALSE(error);
}

TEST(LayFlat, ChecksTheRulesUnlessToldNotTo) {
  PatternChecks checks;
  checks.rules.strict = true;
  checks.rules.inside_radius_t = 5.0;
  const auto breaches = [](const Report& report) {
    return std::ranges::count(report.findings, std::string("inside_radius"), &Finding::code);
  };
  EXPECT_EQ(breaches(laid(u_channel(), checks)), 1);
  checks.rules.enabled = false;
  EXPECT_EQ(breaches(laid(u_channel(), checks)), 0);
}

TEST(LayFlat, StopsWhenAsked) {
  for (int after = 0; after < 3; ++after) {
    int asked = 0;
    Progress progress;
    progress.cancelled = [&] { return asked++ >= after; };
    Report report;
    const Sheet sheet = u_channel();
    const auto error = lay_flat(report, {sheet, kUnmeasured, PatternChecks{}}, {}, progress);
    ASSERT_TRUE(error) << after;
    EXPECT_EQ(error->code, code::cancelled);
  }
}

TEST(LiesUncovered, IsWhatRipsMustLeadTo) {
  EXPECT_TRUE(lies_uncovered(u_channel(), {}, {}));
  EXPECT_TRUE(lies_uncovered(walls_that_meet(0.2), {}, {})) << "a small overlap is mended";
  EXPECT_EQ(lies_uncovered(walls_that_meet(20.0), {}, {}).error().code, code::overlap);
  Progress progress;
  progress.cancelled = [] { return true; };
  EXPECT_EQ(lies_uncovered(u_channel(), {}, progress).error().code, code::cancelled);
}

TEST(Reported, KeepsARefusalInTheReport) {
  const auto made = reported(Report(), [](Report& report) {
    report.body = "filled";
    return std::optional<Error>();
  });
  ASSERT_TRUE(made);
  EXPECT_EQ(made->body, "filled");
  EXPECT_GE(made->unfold_seconds, 0.0);
  const auto ending_with = [](const ErrorCode& code) {
    return reported(Report(), [&](Report&) { return std::optional(Error{code, "m", ""}); });
  };
  const auto refused = ending_with(code::overlap);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, code::overlap);
  ASSERT_TRUE(refused.error().shown);
  EXPECT_EQ(refused.error().shown->refusal->code, code::overlap);
  const auto failed = ending_with(code::invalid_input);
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().code, code::invalid_input);
  EXPECT_FALSE(failed.error().shown);
}

}  // namespace
}  // namespace planish::job
