#include "job/sample_reports.hpp"
#include "report_schema.hpp"

#include <planish/job/run.hpp>
#include <planish/job/slit.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace planish::job {
namespace {

using schema::Json;
using ::testing::HasSubstr;
using ::testing::Not;

/// Two strips: one solved, of two ridges; one flat and out of reach.
SlitReport two_strips_bent() {
  SlitReport report;
  static_cast<Report&>(report) = test::sample_report();
  report.input = "shop/chair.json";
  report.gap = 25.4;
  report.flat_deviation = 2.54;
  report.leg_scales = {1.0, 1.25};
  StripState solved;
  solved.status = StripStatus::solved;
  solved.gap = 2.54;
  solved.shortfall = 0.0;
  solved.min_radius = 50.8;
  solved.iterations = 17;
  solved.seat_distance = 25.4;
  solved.anchor_distance = 76.2;
  solved.scan_distance = 101.6;
  solved.crosses = {1};
  solved.crosses_plane = true;
  StripState out;
  out.status = StripStatus::out_of_reach;
  out.shortfall = 12.7;
  out.min_radius = HUGE_VAL;
  report.strips = {solved, out};
  FoldedStrip strip;
  strip.ridges = {
      {{Vec2(0, 0), Vec2(0, 25.4)}, {Vec3(0, 0, 0), Vec3(0, 0, 50.8)}, Angle::degrees(30)},
      {{Vec2(25.4, 0), Vec2(25.4, 25.4)}, {Vec3(0, 0, 0), Vec3(0, 0, 1)}, {}}};
  report.folded.strips = {strip, strip};
  return report;
}

TEST(SlitReport, HasARowForEachStrip) {
  SlitReport report = two_strips_bent();
  report.units = LengthUnit::inch;
  const Json doc = Json::parse(report_json(report));
  const auto wrong = schema::first_mistake(report_schema(built_in()), doc);
  EXPECT_FALSE(wrong) << (wrong ? wrong->pointer : "");
  EXPECT_EQ(doc["command"], "slit");
  const Json slit = doc["slit"];
  EXPECT_DOUBLE_EQ(slit["gap"], 1.0);
  EXPECT_DOUBLE_EQ(slit["flat_deviation"], 0.1);
  EXPECT_EQ(slit["leg_scales"], Json::parse("[1.0, 1.25]")) << "no lengths";
  ASSERT_EQ(slit["strips"].size(), 2u);
  const Json strip = slit["strips"][0];
  EXPECT_EQ(strip["status"], "solved");
  EXPECT_DOUBLE_EQ(strip["gap"], 0.1);
  EXPECT_DOUBLE_EQ(strip["shortfall"], 0.0);
  EXPECT_DOUBLE_EQ(strip["min_radius"], 2.0);
  EXPECT_EQ(strip["iterations"], 17);
  EXPECT_DOUBLE_EQ(strip["seat_distance"], 1.0);
  EXPECT_DOUBLE_EQ(strip["anchor_distance"], 3.0);
  EXPECT_DOUBLE_EQ(strip["scan_distance"], 4.0);
  EXPECT_EQ(strip["crosses"], Json::parse("[1]"));
  EXPECT_EQ(strip["crosses_plane"], true);
  ASSERT_EQ(strip["ridges"].size(), 2u);
  EXPECT_DOUBLE_EQ(strip["ridges"][0]["flat"][1][1], 1.0);
  EXPECT_DOUBLE_EQ(strip["ridges"][0]["folded"][1][2], 2.0);
  EXPECT_DOUBLE_EQ(strip["ridges"][0]["fold"], 30.0);
  EXPECT_EQ(slit["strips"][1]["status"], "out_of_reach");
  EXPECT_DOUBLE_EQ(slit["strips"][1]["shortfall"], 0.5);
  EXPECT_TRUE(slit["strips"][1]["min_radius"].is_null()) << "it is flat";
}

TEST(SlitReport, LeavesRidgesOutWhereNobodyReadsThem) {
  SlitReport report = two_strips_bent();
  const Json doc = Json::parse(report_json(report, Ridges::left_out));
  EXPECT_TRUE(doc["slit"]["strips"][0]["ridges"].empty());
  EXPECT_TRUE(doc["flat"]["bends"].empty());
  EXPECT_EQ(Json::parse(report_json(report))["flat"]["bends"].size(), 1u);
  report.strips[0].status = StripStatus::open;
  report.refusal = Error{code::out_of_time, "m", ""};
  const Json refused = Json::parse(report_json(report));
  EXPECT_EQ(refused["slit"]["strips"][0]["status"], "open");
  EXPECT_TRUE(refused["slit"]["flat_deviation"].is_null()) << "nothing was laid flat";
  report.strips.clear();
  EXPECT_TRUE(Json::parse(report_json(report))["slit"].is_null());
}

TEST(SlitReport, HasATableOfStripsOnTheTerminal) {
  SlitReport report = two_strips_bent();
  const std::string text = report_text(report);
  EXPECT_THAT(
      text, HasSubstr("1      solved        2.5  50.800  25.400   76.200  101.600          17\n"));
  EXPECT_THAT(
      text, HasSubstr("2      out_of_reach    0    flat   0.000    0.000    0.000           0\n"));
  EXPECT_THAT(text, HasSubstr("2.5 mm\n"));
  EXPECT_THAT(text, Not(HasSubstr("B1"))) << "ridges are no bends to read";
  report.refusal = Error{code::out_of_time, "m", ""};
  const std::string refused = report_text(report);
  EXPECT_THAT(refused, HasSubstr("out_of_reach"));
  EXPECT_THAT(refused, Not(HasSubstr("2.5 mm\n")));
  report.strips.clear();
  EXPECT_THAT(report_text(report), Not(HasSubstr("iterations")));
}

}  // namespace
}  // namespace planish::job
