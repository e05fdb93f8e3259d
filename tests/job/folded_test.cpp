#include "folded.hpp"

#include "job/joined_sheet.hpp"

#include <planish/connect/codes.hpp>
#include <planish/job/connect.hpp>
#include <planish/sheet/codes.hpp>

#include <gtest/gtest.h>

#include <numbers>

namespace planish::job {
namespace {

// 50 | 90° r 3 | 30, width 40, t 2: the bend's mean radius is 4.
const double kVolumeOfL = 2.0 * 40.0 * (50.0 + std::numbers::pi / 2 * 4.0 + 30.0);

TEST(Folded, GivesTheSheetTheVolumeOfItsSolid) {
  Sheet sheet = test::l_bracket();
  sheet.volume.reset();
  Report report;
  report.body = "bracket";
  Result<Body> solid = fail(code::internal, "none");
  EXPECT_FALSE(fold(report, sheet, sheet, solid, {}));
  ASSERT_TRUE(solid);
  EXPECT_EQ(solid->name(), "bracket");
  EXPECT_NEAR(*sheet.volume, kVolumeOfL, 1e-6 * kVolumeOfL);
  EXPECT_TRUE(report.findings.empty());
  const auto text = checked_step(solid);
  ASSERT_TRUE(text) << text.error().message;
  const auto read = read_step_text(*text, "x.step");
  ASSERT_TRUE(read);
  EXPECT_NEAR(read->bodies.front().volume(), kVolumeOfL, 1e-6 * kVolumeOfL);
}

TEST(Folded, IsLeftWithAWarningWhereThereIsNoSolid) {
  Report report;
  Result<Body> solid = fail(code::internal, "none");
  leave_unfolded(report, {code::radius_too_small, "too thick", "bend B1"}, solid);
  ASSERT_EQ(report.findings.size(), 1u);
  EXPECT_EQ(report.findings[0].code, "folded_solid");
  EXPECT_EQ(report.findings[0].severity, Severity::warning);
  EXPECT_EQ(solid.error().code, code::radius_too_small);
  EXPECT_EQ(checked_step(solid).error().code, code::radius_too_small);
}

TEST(Folded, StopsWhenAsked) {
  Sheet sheet = test::l_bracket();
  Report report;
  Result<Body> solid = fail(code::internal, "none");
  Progress progress;
  progress.cancelled = [] { return true; };
  const auto stopped = fold(report, sheet, sheet, solid, progress);
  ASSERT_TRUE(stopped);
  EXPECT_EQ(stopped->code, code::cancelled);
}

TEST(Folded, PutsTheFilesNameBeforeAPointer) {
  EXPECT_EQ(placed({code::not_planar, "m", "/plates/2/outline/3"}, "p.json").where,
            "p.json/plates/2/outline/3");
  EXPECT_EQ(placed({code::not_planar, "m", ""}, "p.json").where, "p.json");
  EXPECT_EQ(placed({code::overlap, "m", "flat pattern at (1, 2) mm"}, "p.json").where,
            "flat pattern at (1, 2) mm");
}

TEST(Folded, CallsStandardInputSo) {
  EXPECT_EQ(place_name("shop/p.json"), "shop/p.json");
  EXPECT_NE(place_name("-"), "-");
}

}  // namespace
}  // namespace planish::job
