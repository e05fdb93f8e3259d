#include "job/sample_reports.hpp"

#include <planish/job/unfold.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace planish::job {
namespace {

using nlohmann::json;
using test::refused_report;
using test::sample_report;
using ::testing::HasSubstr;

// Reads RFC 4180 by the letter, independently of how it is written.
std::vector<std::vector<std::string>> rows_of(const std::string& csv) {
  std::vector<std::vector<std::string>> rows{{""}};
  bool quoted = false;
  for (std::size_t i = 0; i < csv.size(); ++i) {
    const char c = csv[i];
    std::string& cell = rows.back().back();
    if (quoted && c == '"' && i + 1 < csv.size() && csv[i + 1] == '"') {
      cell += csv[++i];
    } else if (c == '"') {
      quoted = !quoted;
    } else if (!quoted && c == ',') {
      rows.back().emplace_back();
    } else if (!quoted && c == '\n') {
      rows.push_back({""});
    } else {
      cell += c;
    }
  }
  rows.pop_back();  // what follows the last line break
  return rows;
}

std::string cell(const std::vector<std::vector<std::string>>& rows, std::size_t row,
                 const std::string& column) {
  for (std::size_t c = 0; c < rows[0].size(); ++c) {
    if (rows[0][c] == column) return rows[row][c];
  }
  return "no such column";
}

TEST(SummaryCsv, HasOneRowABodyAndAsManyCellsAsTitles) {
  const auto rows = rows_of(summary_csv({sample_report(), refused_report()}));
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[1].size(), rows[0].size());
  EXPECT_EQ(rows[2].size(), rows[0].size());
  EXPECT_EQ(cell(rows, 1, "status"), "ok");
  EXPECT_EQ(cell(rows, 1, "thickness"), "2");
  EXPECT_EQ(cell(rows, 1, "length"), "100");
  EXPECT_EQ(cell(rows, 1, "width"), "60");
  EXPECT_EQ(cell(rows, 1, "openings"), "1");
}

TEST(SummaryCsv, GivesTheTypedReasonAndNothingThatIsNotKnown) {
  const auto rows = rows_of(summary_csv({sample_report(), refused_report()}));
  EXPECT_EQ(cell(rows, 2, "status"), "refused");
  EXPECT_EQ(cell(rows, 2, "reason"), "not_a_sheet");
  EXPECT_EQ(cell(rows, 2, "quantity"), "3");
  for (const char* column : {"thickness", "length", "area", "bends", "volume_ratio", "mass"}) {
    EXPECT_EQ(cell(rows, 2, column), "") << column;
  }
}

TEST(SummaryCsv, QuotesNamesWithCommasQuotesAndLineBreaks) {
  for (const std::string name : {"door, left", "3\" plate", "two\nlines", "a;b", "\"", ","}) {
    UnfoldReport report = sample_report();
    report.body = name;
    const auto rows = rows_of(summary_csv({report, refused_report()}));
    ASSERT_EQ(rows.size(), 3u) << name;
    EXPECT_EQ(rows[1].size(), rows[0].size()) << name;
    EXPECT_EQ(cell(rows, 1, "body"), name);
  }
}

TEST(SummaryCsv, ConvertsToTheUnitsOfTheReport) {
  UnfoldReport report = sample_report();
  report.units = LengthUnit::inch;
  const auto rows = rows_of(summary_csv({report}));
  EXPECT_EQ(cell(rows, 1, "units"), "inch");
  EXPECT_NEAR(std::stod(cell(rows, 1, "length")), 100.0 / 25.4, 5e-6);
  EXPECT_DOUBLE_EQ(std::stod(cell(rows, 1, "volume_ratio")), 1.0);
}

TEST(SummaryJson, HoldsAWholeReportForEveryBody) {
  const json summary = json::parse(summary_json({sample_report(), refused_report()}));
  EXPECT_EQ(summary["format"], "planish/summary");
  EXPECT_EQ(summary["unfolded"], 1);
  EXPECT_EQ(summary["refused"], 1);
  EXPECT_EQ(summary["pieces"], 4);
  ASSERT_EQ(summary["bodies"].size(), 2u);
  EXPECT_EQ(summary["bodies"][0], json::parse(report_json(sample_report())));
  EXPECT_EQ(summary["bodies"][1]["reason"]["code"], "not_a_sheet");
}

TEST(SummaryJson, OfAFileWithoutBodiesHasAnEmptyListOfThem) {
  const json summary = json::parse(summary_json({}));
  EXPECT_EQ(summary["bodies"], json::array());
  for (const char* count : {"unfolded", "refused", "pieces", "surface_bodies"})
    EXPECT_EQ(summary[count], 0) << count;
}

TEST(SummaryJson, IsRefusedOnlyWhenNoBodyUnfolds) {
  const auto status = [](const std::vector<Outcome<UnfoldReport>>& bodies) {
    return json::parse(summary_json(bodies))["status"].get<std::string>();
  };
  EXPECT_EQ(status({sample_report()}), "ok");
  EXPECT_EQ(status({sample_report(), refused_report()}), "warning");
  EXPECT_EQ(status({refused_report()}), "refused");
}

TEST(SummaryText, ShowsCertificatesAndReasons) {
  const std::string text = summary_text({sample_report(), refused_report()});
  EXPECT_THAT(text, HasSubstr("1 of 2 different bodies unfolded (4 pieces in all)"));
  EXPECT_THAT(text, HasSubstr("not_a_sheet: no two skins at one distance"));
  EXPECT_THAT(text, HasSubstr("1.000000  2e-13   3e-09"));
}

}  // namespace
}  // namespace planish::job
