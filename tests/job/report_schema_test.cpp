#include "report_schema.hpp"

#include "job/planned_reports.hpp"
#include "report_json.hpp"

#include <planish/job/run.hpp>
#include <planish/job/schemas.hpp>

#include <gtest/gtest.h>

namespace planish::job {
namespace {

using schema::Json;

std::string mistake_in_report(const Json& report) {
  const auto wrong = schema::first_mistake(report_schema(built_in()), report);
  return wrong ? wrong->pointer + " is wrong" : "";
}

/// A report with all that a report may have.
UnfoldReport full_report() {
  UnfoldReport report = test::sample_report();
  static_cast<Report&>(report) = test::planned_report();
  report.material = "S235";
  report.colour = "#c0c0c0";
  report.density = 7.85;
  report.mass = 0.1;
  report.flat.features = {{"louvre", FormSide::up, {report.flat.openings[0].loop}, 1}};
  report.flat.labels = {{{1, 2}, "A"}};
  report.certificate.openings = {
      .solid = 1, .pattern = 1, .features = 0, .loops = 1, .missing = {}};
  report.findings = {{"flange_height", Severity::warning, "too low", {{1, 2}}}};
  report.findings[0].places = {{Severity::warning, "too low", {{1, 2}}, {place::bend("B1")}}};
  report.findings[0].remedies = {{"relief", "rip", ""}, {"", "", "Draw a gap."}};
  report.notes = {"a note"};
  report.files = {"part.dxf"};
  return report;
}

TEST(ReportSchema, TakesReportsOfEveryMaker) {
  EXPECT_EQ(mistake_in_report(report_value(full_report())), "");
  EXPECT_EQ(mistake_in_report(report_value(test::sample_report())), "");
  EXPECT_EQ(mistake_in_report(report_value(test::refused_report())), "");
  for (const Maker& maker : built_in().makers)
    EXPECT_EQ(
        mistake_in_report(Json::parse(maker.failed({}, {code::cannot_read, "gone", "a"})->json())),
        "")
        << maker.name;
}

/// Every pointer to a number, a text, a list or an object in a document.
void pointers_of(const Json& doc, const Json::json_pointer& at,
                 std::vector<Json::json_pointer>& all) {
  if (!at.empty()) all.push_back(at);
  for (const auto& item : doc.items())
    if (doc.is_object())
      pointers_of(item.value(), at / item.key(), all);
    else if (doc.is_array())
      pointers_of(item.value(), at / std::stoul(item.key()), all);
}

TEST(ReportSchema, TakesNoOtherTypeAnywhere) {
  const Json report = report_value(full_report());
  std::vector<Json::json_pointer> all;
  pointers_of(report, Json::json_pointer(), all);
  EXPECT_GT(all.size(), 200u);
  for (const auto& at : all) {
    Json changed = report;
    changed[at] = true;  // which nothing in this report is, but `flattening`
    EXPECT_NE(mistake_in_report(changed), "") << at.to_string();
  }
}

TEST(ReportSchema, MissesWhatEveryReportHas) {
  const Json report = report_value(test::sample_report());
  for (const char* key : {"format", "version", "command", "input", "units", "status", "reason",
                          "sheet", "flat", "verification", "checks", "notes", "files"}) {
    Json without = report;
    without.erase(key);
    EXPECT_EQ(mistake_in_report(without).find(std::string("/") + key + " "), 0u) << key;
  }
}

TEST(ReportSchema, HasPointsOfTwoAndThreeCoordinates) {
  const auto takes = [](const schema::Schema& schema, const char* text) {
    return !schema::first_mistake(schema, Json::parse(text));
  };
  EXPECT_TRUE(takes(report_point(), "[1, null]"));
  EXPECT_FALSE(takes(report_point(), "[1]"));
  EXPECT_FALSE(takes(report_point(), "[1, 2, 3]"));
  EXPECT_TRUE(takes(report_space_point(), "[1, 2, null]"));
  EXPECT_FALSE(takes(report_space_point(), "[1, 2]"));
  EXPECT_TRUE(takes(report_line(), "[[1, 2], [3, 4]]"));
  EXPECT_FALSE(takes(report_line(), "[[1, 2]]"));
}

TEST(ReportSchema, CountsWherePeopleDo) {
  for (const char* from_one : {"/flat/bends/0/order", "/body_number", "/quantity",
                               "/verification/openings/loops", "/version", "/checks/0/count"}) {
    Json report = report_value(full_report());
    ASSERT_TRUE(report.contains(Json::json_pointer(from_one))) << from_one;
    report[Json::json_pointer(from_one)] = 1;
    EXPECT_EQ(mistake_in_report(report), "") << from_one;
    report[Json::json_pointer(from_one)] = 0;
    EXPECT_NE(mistake_in_report(report), "") << from_one;
  }
  for (const char* from_zero : {"/sheet/flanges", "/flat/openings", "/plan/turn_overs",
                                "/verification/openings/pattern", "/flat/features/0/openings"}) {
    Json report = report_value(full_report());
    ASSERT_TRUE(report.contains(Json::json_pointer(from_zero))) << from_zero;
    report[Json::json_pointer(from_zero)] = 0;
    EXPECT_EQ(mistake_in_report(report), "") << from_zero;
  }
}

TEST(SummarySchema, TakesSummaries) {
  const Json summary = Json::parse(summary_json({full_report(), test::refused_report()}));
  EXPECT_FALSE(schema::first_mistake(summary_schema(built_in()), summary));
  Json wrong = summary;
  wrong["bodies"][1]["status"] = "bad";
  EXPECT_EQ(schema::first_mistake(summary_schema(built_in()), wrong)->pointer, "/bodies/1/status");
}

}  // namespace
}  // namespace planish::job
