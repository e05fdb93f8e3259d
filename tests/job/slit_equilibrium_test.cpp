#include "slit_equilibrium.hpp"

#include "report_schema.hpp"

#include <planish/job/run.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

// What weight and loads do, as reports tell it.

namespace planish::job {
namespace {

using schema::Json;
using ::testing::HasSubstr;

/// Three strips: one yields, one springs open, one sways.
SlitReport three_strips() {
  SlitReport report;
  report.design.material = SlitMaterial{210000.0, 0.3, 7.85, 235.0};
  SlitEquilibrium state;
  state.stress = {300.0, 100.0, 200.0};
  state.kept_radius = {508.0, std::nullopt, std::nullopt};
  state.is_stable = {true, true, false};
  state.reactions = {{1, HeldBy::ground, Vec3(0, 5, 0), Vec3(1, 2, 3), Vec3(25.4, 0, 50.8)}};
  state.standing = SlitStanding{
      false, Angle::degrees(-2.5), Vec3(0, 254, 25.4), {Vec2(0, 0), Vec2(25.4, 0)}};
  report.equilibrium = state;
  return report;
}

Json slit_of(const SlitReport& report, LengthUnit unit) {
  Json slit{{"strips", Json::array({Json::object(), Json::object(), Json::object()})}};
  add_equilibrium(slit, report, schema::Units(unit));
  return slit;
}

TEST(SlitEquilibrium, IsInNewtonsAndLengthsInTheUnit) {
  const Json slit = slit_of(three_strips(), LengthUnit::inch);
  EXPECT_EQ(slit["strips"][0]["stress"], 300.0);
  EXPECT_DOUBLE_EQ(slit["strips"][0]["kept_radius"], 20.0);
  EXPECT_TRUE(slit["strips"][1]["kept_radius"].is_null());
  EXPECT_EQ(slit["stable"], false);
  const Json reaction = slit["reactions"][0];
  EXPECT_EQ(reaction["end"], "ground");
  EXPECT_EQ(reaction["strip"], 1);
  EXPECT_EQ(reaction["force"], Json({0.0, 5.0, 0.0}));
  EXPECT_EQ(reaction["moment"], Json({1.0, 2.0, 3.0}));
  EXPECT_DOUBLE_EQ(reaction["at"][2], 2.0);
  EXPECT_EQ(slit["standing"]["stands"], false);
  EXPECT_DOUBLE_EQ(slit["standing"]["margin"], -2.5);
  EXPECT_DOUBLE_EQ(slit["standing"]["centre_of_mass"][1], 10.0);
  EXPECT_DOUBLE_EQ(slit["standing"]["support"][1][0], 1.0);
}

TEST(SlitEquilibrium, OfNoMaterialLeavesTheReportAsItWas) {
  const Json slit = slit_of(SlitReport{}, LengthUnit::mm);
  EXPECT_EQ(slit.size(), 1u);
  EXPECT_TRUE(slit["strips"][0].empty());
  EXPECT_TRUE(equilibrium_findings(SlitReport{}, {}).empty());
  EXPECT_EQ(equilibrium_text(SlitReport{}), "");
}

TEST(SlitEquilibrium, FindingsNameStripsNumbersAndRemedies) {
  const auto findings = equilibrium_findings(three_strips(), {Vec2(1, 0), Vec2(2, 0), Vec2(3, 0)});
  ASSERT_EQ(findings.size(), 4u);
  EXPECT_EQ(findings[0].code, "yields");
  EXPECT_THAT(findings[0].message, HasSubstr("strip 1 is bent beyond its yield stress: 300 N/mm²"));
  EXPECT_THAT(findings[0].message, HasSubstr("keeps a radius of 508 mm"));
  EXPECT_EQ(findings[0].at, std::vector{Vec2(1, 0)});
  EXPECT_EQ(findings[1].code, "unstable");
  EXPECT_EQ(findings[1].about, std::vector{place::strip(2)});
  EXPECT_EQ(findings[2].code, "falls_over");
  EXPECT_EQ(findings[2].numbers[0].quantity.value, 2.5);
  EXPECT_EQ(findings[3].code, "springs_open");
  EXPECT_EQ(findings[3].severity, Severity::info);
  EXPECT_THAT(findings[3].message, HasSubstr("strips 2 and 3 spring open when let go"));
  EXPECT_THAT(findings[3].message, HasSubstr("200 N/mm², is less than"));
  for (const Finding& one : findings)
    EXPECT_EQ(one.remedies.size(), 1u) << one.code;
}

TEST(SlitEquilibrium, TextTellsHowFarItMayBeTilted) {
  SlitReport report = three_strips();
  EXPECT_THAT(equilibrium_text(report), HasSubstr("300 N/mm², in strip 1"));
  report.equilibrium->standing = SlitStanding{true, Angle::degrees(12.0), {}, {}};
  EXPECT_THAT(equilibrium_text(report), HasSubstr("may be tilted by 12°"));
}

}  // namespace
}  // namespace planish::job
