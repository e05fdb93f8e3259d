#include "connected.hpp"

#include "connect/sample_plates.hpp"
#include "job/joined_sheet.hpp"

#include <planish/job/connect.hpp>
#include <planish/sheet/codes.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

namespace planish::job {
namespace {

using test::joined;
using test::report_of;
using ::testing::HasSubstr;

constexpr double kHalfCircle = std::numbers::pi;

// Two walls beside each other on a base, so wide above that they share sheet when flat.
Sheet flaring_walls() {
  test::SheetBuilder builder(1.0);
  const FaceId base = builder.flange(Frame{}, {test::rectangle(40, 40)});
  for (const int border : {1, 2}) {
    const test::Rim rim = builder.bend(builder.rim(base, border),
                                       test::Turn{Angle::degrees(90), 2});
    builder.flange_behind(rim, {test::polygon({{0, 0}, {40, 0}, {110, 40}, {-70, 40}})});
  }
  return builder.finish();
}

TEST(Connected, VerifiesTheVolumeOnTheFoldedSolid) {
  const ConnectReport report = report_of(joined());
  const double area = 40.0 * (50.0 + kHalfCircle / 2 * (3.0 + 0.5 * 2.0) + 30.0);
  EXPECT_NEAR(report.summary.volume, 2.0 * area, 1e-6 * area);
  EXPECT_NEAR(*report.certificate.volume_ratio, 1.0, 1e-6);
  EXPECT_NEAR(*report.certificate.explained_ratio, 1.0, 1e-6);
  EXPECT_LT(report.certificate.length_error, 1e-9);
  EXPECT_LT(report.certificate.refold_deviation, 1e-6);
  EXPECT_EQ(report.status(), Status::ok);
  ASSERT_TRUE(report.solid.has_value());
  const auto step = step_text(*report.solid);
  ASSERT_TRUE(step) << step.error().message;
  EXPECT_THAT(*step, HasSubstr("ISO-10303-21"));
  EXPECT_THAT(*step, HasSubstr("'plates'"));
  EXPECT_TRUE(dxf_text(report.flat).has_value());
}

TEST(Connected, MeasuresFoldsThatEndInsideAnEdge) {
  // The mitre adds outside the middle surfaces what it takes inside: both plates as they are drawn.
  PlateStructure s;
  s.thickness = 2.0;
  s.plates = {test::rectangle_plate("A", {0, 0, 0}, {100, 0, 0}, {0, 50, 0}),
              test::rectangle_plate("B", {20, 0, 0}, {50, 0, 0}, {0, 0, 40})};
  s.bends = {{.between = {"A", "B"}, .inside_radius = 0.0}};
  auto connection = connect(s);
  ASSERT_TRUE(connection) << connection.error().message;
  const ConnectReport report = report_of(std::move(*connection));
  ASSERT_TRUE(report.solid.has_value());
  EXPECT_NEAR(report.summary.volume, 2.0 * (100.0 * 50.0 + 50.0 * 40.0), 1e-6);
  EXPECT_NEAR(*report.certificate.explained_ratio, 1.0, 1e-9);
  for (const Finding& finding : report.findings)
    EXPECT_NE(finding.severity, Severity::error) << finding.message;
}

TEST(Connected, LaysFlatByTheRuleAsked) {
  const ConnectReport report = report_of(joined(), ConstantK{0.3, "plates file"});
  EXPECT_EQ(report.summary.k_factor, 0.3);
  EXPECT_EQ(report.summary.k_source, "plates file");
  EXPECT_NEAR(report.flat.area, 40.0 * (80.0 + kHalfCircle / 2 * 3.6), 1e-6);
}

TEST(Connected, TakesKFromTheCommandThenTheFileThenTheDefault) {
  PlatesFile file;
  Request request;
  EXPECT_EQ(std::get<ConstantK>(allowance_of(file, request)).k, ConstantK{}.k);
  file.k_factor = 0.3;
  EXPECT_EQ(std::get<ConstantK>(allowance_of(file, request)).k, 0.3);
  EXPECT_EQ(std::get<ConstantK>(allowance_of(file, request)).source, "plates file");
  request.allowance = Din6935{};
  EXPECT_TRUE(std::holds_alternative<Din6935>(allowance_of(file, request)));
}

TEST(Connected, RefusesAPatternThatCoversItselfUnlessToldNotTo) {
  PatternChecks checks;
  Connection connection = joined();
  connection.sheet = flaring_walls();
  ConnectReport report;
  report.body = "flaring";
  const auto error = finish(report, connection, ConstantK{}, checks, {});
  ASSERT_TRUE(error.has_value());
  EXPECT_EQ(error->code, code::overlap);
  EXPECT_EQ(report.summary.flanges, 3);
  checks.write_overlapping = true;
  const auto other = finish(report, connection, ConstantK{}, checks, {});
  ASSERT_TRUE(other.has_value()) << "the folded walls run through each other too";
  EXPECT_EQ(other->code.name, "self_intersection");
  checks.write_anyway = true;
  EXPECT_FALSE(finish(report, connection, ConstantK{}, checks, {}).has_value());
  EXPECT_TRUE(report.has_warnings());
}

TEST(Connected, StopsWhenAsked) {
  Progress progress;
  progress.cancelled = [] { return true; };
  ConnectReport report;
  report.body = "stopped";
  const auto error = finish(report, joined(), ConstantK{}, {}, progress);
  ASSERT_TRUE(error.has_value());
  EXPECT_EQ(error->code, code::cancelled);
}

}  // namespace
}  // namespace planish::job
