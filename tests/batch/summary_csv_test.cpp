#include "summary_csv.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace planish::batch {
namespace {

std::ptrdiff_t cells(const std::string& line) { return std::ranges::count(line, ',') + 1; }

TEST(SummaryCsv, HasACellForEachTitle) {
  EXPECT_EQ(cells(csv_of({}, "")), cells(csv_titles()));
  EXPECT_TRUE(csv_titles().starts_with("input,body,quantity,status,reason,message,units,"));
}

// Numbers have up to six digits, and what the report does not say is empty.
TEST(SummaryCsv, SaysWhatTheReportSays) {
  const PartRecord part = part_record(
      "f",
      R"({"input":"a.step","body":"b","quantity":2,"status":"warning","units":"mm",)"
      R"("material":"S235",)"
      R"("sheet":{"thickness":2.0000000000000004,"bends":3},)"
      R"("flat":{"size":[120.24999999999,80.0],"area":9620.123456,)"
      R"("openings":0},)"
      R"("checks":[{"severity":"warning"},{"severity":"info"},{"severity":"error"}],)"
      R"("files":["f/a.dxf","f/a.svg"]})",
      {}, {});
  EXPECT_EQ(csv_of(part, "e"),
            "a.step,b,2,warning,,,mm,2,120.25,80,9620.12,,,0,3,,,2,\"f/a.dxf;f/a.svg\",e,S235,,\n");
}

TEST(SummaryCsv, SaysWhatWouldHelpWithWarnings) {
  const PartRecord part = part_record(
      "f",
      R"({"checks":[)"
      R"({"severity":"warning","code":"cannot_bend","message":"It hits.",)"
      R"("remedy":{"change":"Use a smaller V"},)"
      R"("remedies":[{"option":"--opening","value":"10","change":"Use a smaller V"},)"
      R"({"change":"Split it"}]},)"
      R"({"severity":"warning","message":"Not this.","remedy":{"option":"--k","value":"1"}},)"
      R"({"severity":"warning","message":"It is thick.","remedy":{"change":"Thin it"}},)"
      R"({"severity":"info","remedy":{"change":"Leave it"}}]})",
      {}, {});
  EXPECT_TRUE(
      csv_of(part, "").ends_with("\"Use a smaller V; Split it; Thin it\",It hits. It is thick.\n"))
      << csv_of(part, "");
  EXPECT_TRUE(csv_titles().ends_with(",remedies,remedied\n"));
}

TEST(SummaryCsv, QuotesWhatWouldBeMisread) {
  const PartRecord part = part_record(
      "f", R"({"reason":{"code":"c","message":"It is a block, 3 mm \"thick\"."}})", {}, {});
  EXPECT_NE(csv_of(part, "").find(R"(,c,"It is a block, 3 mm ""thick"".",)"), std::string::npos);
}

}  // namespace
}  // namespace planish::batch
