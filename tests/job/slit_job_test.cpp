#include "job/job_requests.hpp"
#include "slit/sample_sheets.hpp"

#include <planish/job/slit.hpp>
#include <planish/job/slit_json.hpp>
#include <planish/slit/codes.hpp>
#include <planish/slit/slit_curves.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace planish::job {
namespace {

SlitFile small_chair() {
  SlitFile file;
  file.design = test::small_chair();
  return file;
}

Request slit_request(Effort effort = Effort::draft) {
  Request request;
  request.input = "shop/chair.json";
  request.effort = effort;
  return request;
}

SlitReport bent(const SlitFile& file, Effort effort = Effort::draft) {
  const auto report = slit_sheet(file, slit_request(effort));
  EXPECT_TRUE(report) << (report ? "" : report.error().message);
  return report ? *report : SlitReport{};
}

TEST(SlitJob, LaysFlatTheSheetThatWasCut) {
  const SlitReport report = bent(small_chair(), Effort::full);
  ASSERT_EQ(report.strips.size(), 2u);
  EXPECT_LT(report.flat_deviation, 1e-6);
  double gap = 0.0;
  for (const StripState& strip : report.strips) {
    EXPECT_EQ(strip.status, StripStatus::solved);
    gap = std::max(gap, strip.gap);
  }
  EXPECT_EQ(report.gap, gap);
  // The panel and the strips, both halves of them: 120 wide.
  EXPECT_NEAR(report.flat.area, 120.0 * (2 * 420.0 + 2 * 464.0), 1.0);
  EXPECT_NEAR(report.size.x(), 2 * (420.0 + 464.0), 1e-3);
  EXPECT_NEAR(report.size.y(), 120.0, 1e-3);
  EXPECT_EQ(report.leg_scales, std::vector<double>{1.0});
  EXPECT_FALSE(report.flat.slits.empty()) << "slits without width are lines";
}

TEST(SlitJob, CutsSlitsAsWideAsAsked) {
  SlitFile file = small_chair();
  const double whole = bent(file).flat.area;
  file.kerf = 2.0;
  const SlitReport report = bent(file);
  EXPECT_TRUE(report.flat.slits.empty());
  EXPECT_LT(report.flat.area, whole - 400.0);
  file.kerf = 500.0;
  const auto wide = slit_sheet(file, slit_request());
  ASSERT_FALSE(wide);
  EXPECT_EQ(wide.error().where, "shop/chair.json/kerf");
  file.kerf = 0.0;
  file.stop_hole = 500.0;
  const auto hole = slit_sheet(file, slit_request());
  ASSERT_FALSE(hole);
  EXPECT_EQ(hole.error().where, "shop/chair.json/stop_hole");
}

/// Three strips that narrow towards the symmetry plane between two curves that meet it squarely.
SlitFile curved_chair() {
  SlitFile file = small_chair();
  CurvedSlits curves;
  curves.width = 120.0;
  for (const double from : {40.0, 80.0}) {
    const double to = 60.0 + 0.6 * (from - 60.0);
    curves.slits.push_back(
        chain_on({{{440.0, from}, {560.0, from}, {720.0, to}, {884.0, to}}}, 0.02));
  }
  file.design.sheet.strips = *strips_between(file.design.sheet, curves);
  return file;
}

TEST(SlitJob, LaysFlatTheSheetThatWasCutAlongCurves) {
  const SlitFile file = curved_chair();
  const SlitReport report = bent(file, Effort::full);
  ASSERT_EQ(report.strips.size(), 3u);
  EXPECT_LT(report.flat_deviation, 1e-12 * 884.0 * 10.0);
  EXPECT_LT(report.gap, 1e-9 * 464.0);
  EXPECT_NEAR(report.flat.area, 120.0 * 2 * 884.0, 1e-6);
  EXPECT_NEAR(report.size.x(), 2 * 884.0, 1e-9);
  // Each is cut once, as long as it is: both halves of two slits.
  const double half = length(BezierCurve{{{440, 40}, {560, 40}, {720, 48}, {884, 48}}});
  EXPECT_NEAR(length(report.flat.slits), 4.0 * half, 4 * 0.02);
  EXPECT_EQ(report.flat.openings.size(), 0u);
  for (std::size_t a = 0; a < report.flat.slits.size(); ++a)
    for (std::size_t b = 0; b < report.flat.slits.size(); ++b) {
      if (a == b) continue;
      EXPECT_GT(nearest(report.flat.slits[a], point_at(report.flat.slits[b], 0.5)).distance, 0.05)
          << "twice";
    }
}

/// What is swept along a smooth curve is the width times its length.
TEST(SlitJob, CutsSlitsAlongCurvesAsWideAsAsked) {
  SlitFile file = curved_chair();
  file.kerf = 3.0;
  const SlitReport report = bent(file);
  EXPECT_TRUE(report.flat.slits.empty());
  ASSERT_EQ(report.flat.openings.size(), 2u);
  const double half = length(BezierCurve{{{440, 40}, {560, 40}, {720, 48}, {884, 48}}});
  const double cut = 2.0 * (3.0 * 2.0 * half + 1.5 * 1.5 * std::numbers::pi);
  EXPECT_NEAR(report.flat.area, 120.0 * 2 * 884.0 - cut, 1e-4 * cut);
  file.stop_hole = 8.0;
  const SlitReport holes = bent(file);
  EXPECT_LT(holes.flat.area, report.flat.area - 4 * 12.0);
  EXPECT_EQ(holes.flat.openings.size(), 2u);
}

TEST(SlitJob, ScalesLegCurvesThatMayFit) {
  SlitFile file = small_chair();
  file.design.fit = true;
  file.design.leg_curve = {{{360, 0}, {360, 100}}};
  const SlitReport report = bent(file);
  ASSERT_EQ(report.leg_scales.size(), 1u);
  EXPECT_NEAR(report.leg_scales[0], 1.2, 1e-6);
}

TEST(SlitJob, HalvesQuadsAsOftenAsAsked) {
  SlitFile file = small_chair();
  const std::size_t once = bent(file).folded.strips[0].ridges.size();
  file.subdivisions = 1;
  EXPECT_EQ(bent(file).folded.strips[0].ridges.size(), 2 * once - 1);
}

TEST(SlitJob, WarnsOfScansFarFromTheirStrips) {
  // A strip of 464 mm stays over 46 mm from a point 5 m away, and within it from its own corners.
  SlitFile file = small_chair();
  const auto far_strips = [&] {
    std::vector<std::string> messages;
    for (const Finding& finding : bent(file).findings)
      if (finding.code == "scan_far") messages.push_back(finding.message.substr(0, 13));
    return messages;
  };
  EXPECT_TRUE(far_strips().empty()) << "nothing is scanned";
  SlitScan own{1, {}};
  for (const SlitRidge& ridge : bent(file).folded.strips[1].ridges)
    own.points.insert(own.points.end(), ridge.folded.begin(), ridge.folded.end());
  file.design.scans = {own};
  EXPECT_TRUE(far_strips().empty());
  file.design.scans = {{1, {{0, 0, 5000}}}};
  EXPECT_EQ(far_strips(), std::vector<std::string>{"strip 2 stays"});
}

TEST(SlitJob, RefusesStripsThatDoNotReach) {
  SlitFile file = small_chair();
  file.design.sheet.half_length = 300;  // and the symmetry plane is 360 away
  const auto refused = slit_sheet(file, slit_request());
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, code::out_of_reach);
  EXPECT_EQ(refused.error().where, "shop/chair.json/sheet/strips/0") << "the first of them";
  ASSERT_TRUE(refused.error().shown);
  const SlitReport& report = *refused.error().shown;
  ASSERT_EQ(report.strips.size(), 2u);
  for (const StripState& strip : report.strips)
    EXPECT_NEAR(strip.shortfall, 60.0, 1.0);
  EXPECT_TRUE(report.flat.outer.loop.empty());
}

TEST(SlitJob, RefusesCurvesThatTheSheetDoesNotFit) {
  SlitFile file = small_chair();
  file.design.leg_curve = {{{360, 0}, {360, 60}}};
  const auto refused = slit_sheet(file, slit_request());
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, code::curve_too_short);
  EXPECT_EQ(refused.error().where.rfind("shop/chair.json/leg_curve", 0), 0u);
  ASSERT_TRUE(refused.error().shown);
  EXPECT_TRUE(refused.error().shown->strips.empty());
}

TEST(SlitJob, ReadsItsFile) {
  Request request = slit_request();
  request.input = test::example("slit/chair.json");
  const auto report = slit(request);
  ASSERT_TRUE(report) << report.error().message;
  EXPECT_EQ(report->body, "chair");
  EXPECT_EQ(report->strips.size(), 6u);
  request.input = "/no/such.json";
  EXPECT_EQ(slit(request).error().code, code::cannot_read);
}

}  // namespace
}  // namespace planish::job
