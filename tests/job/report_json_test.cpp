#include "job/sample_reports.hpp"

#include <planish/job/unfold.hpp>
#include <planish/sheet/codes.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>
#include <numbers>

namespace planish::job {
namespace {

using nlohmann::json;
using test::refused_report;
using test::sample_report;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

json value_of(const UnfoldReport& report) { return json::parse(report_json(report)); }

std::vector<std::string> keys(const json& object) {
  std::vector<std::string> names;
  for (const auto& [key, value] : object.items())
    names.push_back(key);
  return names;
}

TEST(ReportJson, HasEveryKeyOfTheFormatsPage) {
  const json report = value_of(sample_report());
  EXPECT_THAT(keys(report),
              ::testing::IsSupersetOf({"format", "version", "command", "input", "units", "status",
                                       "reason", "sheet", "flat", "verification", "checks"}));
  EXPECT_THAT(keys(report["sheet"]), ::testing::IsSupersetOf({"thickness", "k_factor", "k_source",
                                                              "flanges", "bends", "volume"}));
  EXPECT_THAT(keys(report["flat"]),
              ::testing::IsSupersetOf({"area", "perimeter", "size", "bends"}));
  EXPECT_THAT(keys(report["flat"]["bends"][0]),
              ::testing::IsSupersetOf({"id", "kind", "angle", "inside_radius", "k_factor",
                                       "allowance", "deduction", "direction", "length", "line"}));
  EXPECT_THAT(keys(report["verification"]),
              ::testing::IsSupersetOf({"volume_ratio", "length_error"}));
}

TEST(ReportJson, SaysWhatTheReportHolds) {
  const json report = value_of(sample_report());
  EXPECT_EQ(report["format"], "planish/report");
  EXPECT_EQ(report["version"], 1);
  EXPECT_EQ(report["command"], "unfold");
  EXPECT_EQ(report["input"], "parts/bracket.step");
  EXPECT_EQ(report["units"], "mm");
  EXPECT_EQ(report["status"], "ok");
  EXPECT_TRUE(report["reason"].is_null());
  EXPECT_EQ(report["sheet"]["thickness"], 2.0);
  EXPECT_EQ(report["sheet"]["k_source"], "default");
  EXPECT_EQ(report["flat"]["size"], (json{100.0, 60.0}));
  EXPECT_EQ(report["flat"]["openings"], 1);
  EXPECT_DOUBLE_EQ(report["flat"]["cutting"]["outer"], 320.0);
  EXPECT_DOUBLE_EQ(report["flat"]["cutting"]["inner"], 10.0 * std::numbers::pi);
  const json bend = report["flat"]["bends"][0];
  EXPECT_EQ(bend["id"], "B1");
  EXPECT_EQ(bend["kind"], "cylinder");
  EXPECT_DOUBLE_EQ(bend["angle"], 90.0);
  EXPECT_EQ(bend["direction"], "down");
  EXPECT_EQ(bend["k_source"], "default");
  EXPECT_EQ(bend["order"], 1);
}

TEST(ReportJson, TakesTheLongestPieceAsTheBendLine) {
  const json bend = value_of(sample_report())["flat"]["bends"][0];
  EXPECT_EQ(bend["line"], json::parse("[[40.0, 25.0], [40.0, 60.0]]"));
  EXPECT_EQ(bend["lines"].size(), 2u);
}

TEST(ReportJson, HasAnEmptyLineForABendWithoutMaterialAtItsMiddle) {
  UnfoldReport report = sample_report();
  report.flat.bends[0].lines.clear();
  EXPECT_EQ(value_of(report)["flat"]["bends"][0]["line"], json::array());
}

TEST(ReportJson, ConvertsLengthsAreasAndVolumesToInches) {
  const json mm = value_of(sample_report());
  UnfoldReport report = sample_report();
  report.units = LengthUnit::inch;
  report.findings = {{"flange_height", Severity::warning, "too low", {{25.4, 50.8}}}};
  const json inch = value_of(report);
  EXPECT_EQ(inch["units"], "inch");
  const auto ratio = [&](const char* pointer) {
    const json::json_pointer at(pointer);
    return mm[at].get<double>() / inch[at].get<double>();
  };
  for (const char* length :
       {"/sheet/thickness", "/flat/perimeter", "/flat/size/0", "/flat/bends/0/inside_radius",
        "/flat/bends/0/allowance", "/flat/bends/0/deduction", "/flat/bends/0/length",
        "/flat/bends/0/line/1/1", "/flat/cutting/outer", "/verification/length_error",
        "/verification/refold_deviation"}) {
    EXPECT_DOUBLE_EQ(ratio(length), 25.4) << length;
  }
  EXPECT_DOUBLE_EQ(ratio("/flat/area"), 25.4 * 25.4);
  EXPECT_DOUBLE_EQ(ratio("/sheet/volume"), 25.4 * 25.4 * 25.4);
  for (const char* pure : {"/flat/bends/0/angle", "/flat/bends/0/k_factor",
                           "/verification/volume_ratio", "/sheet/k_factor"}) {
    EXPECT_DOUBLE_EQ(ratio(pure), 1.0) << pure;
  }
  EXPECT_EQ(inch["checks"][0]["at"], json::parse("[[1.0, 2.0]]"));
}

TEST(ReportJson, SaysNullForWhatCouldNotBeMeasured) {
  UnfoldReport report = sample_report();
  report.certificate.volume_ratio = kNaN;
  report.certificate.length_error = std::numeric_limits<double>::infinity();
  const json verification = value_of(report)["verification"];
  EXPECT_TRUE(verification["volume_ratio"].is_null());
  EXPECT_TRUE(verification["length_error"].is_null());
}

TEST(ReportJson, HasNoKFactorForTheSheetWhereBendsDiffer) {
  UnfoldReport report = sample_report();
  report.summary.k_factor.reset();
  report.summary.k_source = "mixed";
  const json sheet = value_of(report)["sheet"];
  EXPECT_TRUE(sheet["k_factor"].is_null());
  EXPECT_EQ(sheet["k_source"], "mixed");
}

TEST(ReportJson, GivesTheReasonOfARefusalAndNoNumbersThatAreNotKnown) {
  const json report = value_of(refused_report());
  EXPECT_EQ(report["status"], "refused");
  EXPECT_EQ(report["reason"]["code"], "not_a_sheet");
  EXPECT_EQ(report["reason"]["message"], "no two skins at one distance");
  EXPECT_EQ(report["reason"]["where"], "body 2");
  EXPECT_EQ(report["quantity"], 3);
  EXPECT_TRUE(report["sheet"].is_null());
  EXPECT_TRUE(report["flat"].is_null());
  EXPECT_TRUE(report["verification"].is_null());
}

TEST(ReportJson, KeepsWhatWasKnownBeforeTheRefusal) {
  UnfoldReport report = sample_report();
  report.refusal = Error{code::overlap, "covers itself", ""};
  report.findings = {{"overlap", Severity::error, "3 mm² twice", {{1, 2}, {3, 4}, {5, 6}}}};
  const json value = value_of(report);
  EXPECT_EQ(value["status"], "refused");
  EXPECT_EQ(value["sheet"]["thickness"], 2.0);
  EXPECT_EQ(value["flat"]["bends"].size(), 1u);
  EXPECT_EQ(value["checks"][0]["severity"], "error");
  EXPECT_EQ(value["checks"][0]["at"].size(), 3u);
}

TEST(ReportJson, IsTheSameBytesForTheSameReport) {
  UnfoldReport later = sample_report();
  later.read_seconds = 1.0;
  later.unfold_seconds = 2.0;
  EXPECT_EQ(report_json(sample_report()), report_json(later));
}

TEST(ReportJson, SurvivesNamesThatAreNotUtf8) {
  UnfoldReport report = sample_report();
  report.body = "tr\xE4ger";
  EXPECT_EQ(value_of(report)["body"], "tr\uFFFDger");
}

}  // namespace
}  // namespace planish::job
