// What a batch keeps of a part is what its report says, and comes back from its journal as it was.

#include <planish/batch/part_record.hpp>

#include <gtest/gtest.h>

namespace planish::batch {
namespace {

const std::string kReport =
    R"({"input":"a/b ü.step","body":"cover","quantity":4,"status":"warning","units":"inch",)"
    R"("material":"S235","density":7.85,"colour":"#ff0000",)"
    R"("sheet":{"thickness":0.08,"bends":2,"mass":1.5,"volume":0.25},)"
    R"("flat":{"size":[10.0,5.5],"area":55.0,"cutting":{"outer":31.0,"inner":3.125},"openings":1},)"
    R"("verification":{"volume_ratio":1.0002},)"
    R"("checks":[{"code":"overlap","severity":"error","message":"it overlaps"},)"
    R"({"code":"springy","severity":"info","message":"it springs"},)"
    R"({"code":"thin","severity":"warning","message":"it is thin"}],)"
    R"("notes":["one","two"],"files":["a/b.dxf"],"later":{"unknown":[1,2]}})";

TEST(PartRecord, HoldsWhatTheReportSays) {
  const PartRecord record = part_record("f/1", kReport, {"s"}, {"b.dxf", "sketch.svg"});
  EXPECT_EQ(record.folder, "f/1");
  EXPECT_EQ(record.report, kReport);
  EXPECT_EQ(record.shapes, std::vector<std::string>{"s"});
  EXPECT_EQ(record.files, (std::vector<std::string>{"b.dxf", "sketch.svg"}));
  EXPECT_EQ(record.input, "a/b ü.step");
  EXPECT_EQ(record.body, "cover");
  EXPECT_EQ(record.status, "warning");
  EXPECT_EQ(record.units, "inch");
  EXPECT_EQ(record.material, "S235");
  EXPECT_EQ(record.colour, "#ff0000");
  EXPECT_EQ(record.quantity, 4);
  EXPECT_EQ(record.openings, 1);
  EXPECT_EQ(record.bends, 2);
  EXPECT_EQ(record.thickness, 0.08);
  EXPECT_EQ(record.length, 10.0);
  EXPECT_EQ(record.width, 5.5);
  EXPECT_EQ(record.area, 55.0);
  EXPECT_EQ(record.outer_cutting, 31.0);
  EXPECT_EQ(record.inner_cutting, 3.125);
  EXPECT_EQ(record.mass, 1.5);
  EXPECT_EQ(record.density, 7.85);
  EXPECT_EQ(record.volume, 0.25);
  EXPECT_EQ(record.volume_ratio, 1.0002);
  EXPECT_EQ(record.notes, (std::vector<std::string>{"one", "two"}));
  EXPECT_EQ(record.written, std::vector<std::string>{"a/b.dxf"});
  ASSERT_EQ(record.findings.size(), 3U);
  EXPECT_EQ(record.findings[1].code, "springy");
}

TEST(PartRecord, OfARefusedPartHasTheReasonAndNoMeasures) {
  const PartRecord record = part_record(
      "f",
      R"({"status":"refused","reason":{"code":"not_sheet_metal","message":"It is a block."},)"
      R"("flat":null,"material":null,"checks":[]})",
      {}, {});
  EXPECT_EQ(record.reason, "not_sheet_metal");
  EXPECT_EQ(record.message, "It is a block.");
  EXPECT_EQ(record.material, "");
  EXPECT_EQ(record.thickness, std::nullopt);
  EXPECT_EQ(record.length, std::nullopt);
  EXPECT_EQ(record.quantity, std::nullopt);
  EXPECT_TRUE(record.findings.empty());
}

TEST(PartRecord, TakesNothingOfAnotherType) {
  const PartRecord record = part_record(
      "f",
      R"({"input":7,"quantity":"4","sheet":{"thickness":"2","bends":1.5},"flat":{"size":{}},)"
      R"("checks":[3,{"severity":null,"code":"thin"}],"notes":["one",2,{}],"files":null})",
      {}, {});
  EXPECT_EQ(record.input, "");
  EXPECT_EQ(record.quantity, std::nullopt);
  EXPECT_EQ(record.thickness, std::nullopt);
  EXPECT_EQ(record.bends, std::nullopt);
  EXPECT_EQ(record.length, std::nullopt);
  EXPECT_EQ(record.findings.at(1).code, "thin");
  EXPECT_EQ(record.findings.at(1).severity, "");
  EXPECT_EQ(record.notes, std::vector<std::string>{"one"});
  EXPECT_TRUE(record.written.empty());
}

TEST(PartRecord, WarnsOfAllThatIsNotForInformation) {
  const auto warnings = warnings_of(part_record("f", kReport, {}, {}));
  ASSERT_EQ(warnings.size(), 2U);
  EXPECT_EQ(warnings[0].message, "it overlaps");
  EXPECT_EQ(warnings[1].code, "thin");
}

TEST(PartRecord, ComesBackFromItsText) {
  const PartRecord one = part_record("a \"b\"\t\\c", kReport, {R"({"x":0.1})", "not json"},
                                     {"a.dxf"});
  const PartRecord two = part_record("", R"({"n":2.5})", {}, {});
  const auto read = part_records("[" + record_text(one) + "," + record_text(two) + "]");
  ASSERT_TRUE(read);
  ASSERT_EQ(read->size(), 2U);
  EXPECT_EQ((*read)[0].folder, one.folder);
  // What this version knows nothing of is kept, too: "later".
  EXPECT_EQ((*read)[0].report, kReport);
  EXPECT_EQ((*read)[0].shapes, one.shapes);
  EXPECT_EQ((*read)[0].files, one.files);
  EXPECT_EQ((*read)[0].thickness, 0.08);
  EXPECT_EQ((*read)[0].findings.size(), 3U);
  EXPECT_EQ((*read)[1].report, two.report);
  EXPECT_EQ(record_text((*read)[0]), record_text(one));
}

// Keys in another order, and such as other versions may add.
TEST(PartRecord, OfAnotherVersionIsRead) {
  const auto read = part_records(
      R"([{"shapes":["s"],"made":"2031","folder":"f","report":{"body":"b","x":1},"files":["a"]}])");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->at(0).body, "b");
  EXPECT_EQ(read->at(0).report, R"({"body":"b","x":1})");
  EXPECT_EQ(part_records("[]")->size(), 0U);
}

TEST(PartRecord, ThatIsDamagedIsNone) {
  const std::string whole = "[" + record_text(part_record("f", kReport, {"s"}, {"a"})) + "]";
  for (std::size_t length = 0; length < whole.size(); ++length)
    EXPECT_FALSE(part_records(whole.substr(0, length))) << length;
  EXPECT_TRUE(part_records(whole));
  for (const char* text :
       {R"({"folder":"f"})", R"([7])", R"([{"folder":"f","files":[],"shapes":[]}])",
        R"([{"folder":"f","files":[],"report":{}}])", R"([{"files":[],"report":{},"shapes":[]}])",
        R"([{"folder":3,"files":[],"report":{},"shapes":[]}])",
        R"([{"folder":"f","files":["a",1],"report":{},"shapes":[]}])"})
    EXPECT_FALSE(part_records(text)) << text;
}

}  // namespace
}  // namespace planish::batch
