#include "report_schema.hpp"

#include <planish/job/info.hpp>
#include <planish/sheet/codes.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace planish::job {
namespace {

using schema::Json;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

InfoReport two_bodies() {
  InfoReport report;
  report.input = "shop/two.step";
  report.schema = "AP214";
  report.cad_system = "Cad 1";
  report.file_unit = "inch";
  report.surface_bodies = 1;
  BodyInfo lid;
  lid.number = 1;
  lid.name = "lid";
  lid.quantity = 3;
  lid.faces = 14;
  lid.size = {25.4, 50.8, 76.2};
  lid.volume = 2 * 25.4 * 25.4 * 25.4;
  lid.sheet = SheetInfo{2.54, 2, 1, {{7, 2 * 25.4 * 25.4}, {12, 25.4 * 25.4}}};
  BodyInfo block = lid;
  block.number = 2;
  block.name = "block";
  block.material = "S235";
  block.colour = "#c0c0c0";
  block.density = 7.85;
  block.sheet = fail(code::not_a_sheet, "no skins", "face 3");
  report.bodies = {lid, block};
  return report;
}

std::string mistake_of(const Json& info) {
  const auto wrong = schema::first_mistake(info_schema(), info);
  return wrong ? wrong->pointer + " is wrong" : "";
}

TEST(InfoReport, HasWhatTheFileHolds) {
  const Json info = Json::parse(info_json(two_bodies()));
  EXPECT_EQ(mistake_of(info), "");
  EXPECT_EQ(info["format"], "planish/info");
  EXPECT_EQ(info["version"], 1);
  EXPECT_EQ(info["command"], "info");
  EXPECT_EQ(info["input"], "shop/two.step");
  EXPECT_EQ(info["status"], "ok");
  EXPECT_TRUE(info["reason"].is_null());
  EXPECT_EQ(info["schema"], "AP214");
  EXPECT_EQ(info["cad_system"], "Cad 1");
  EXPECT_EQ(info["file_units"], "inch");
  EXPECT_EQ(info["surface_bodies"], 1);
  ASSERT_EQ(info["bodies"].size(), 2u);
  const Json lid = info["bodies"][0];
  EXPECT_EQ(lid["number"], 1);
  EXPECT_EQ(lid["name"], "lid");
  EXPECT_EQ(lid["quantity"], 3);
  EXPECT_EQ(lid["faces"], 14);
  for (const char* key : {"material", "density", "colour"})
    EXPECT_FALSE(lid.contains(key)) << key;
  EXPECT_TRUE(lid["sheet"]["reason"].is_null());
  EXPECT_EQ(lid["sheet"]["flanges"], 2);
  EXPECT_EQ(lid["sheet"]["bends"], 1);
  EXPECT_EQ(lid["sheet"]["flange_faces"][0]["number"], 7);
  const Json block = info["bodies"][1];
  EXPECT_EQ(block["material"], "S235");
  EXPECT_EQ(block["density"], 7.85);
  EXPECT_EQ(block["colour"], "#c0c0c0");
  EXPECT_EQ(block["sheet"]["reason"]["code"], "not_a_sheet");
  EXPECT_EQ(block["sheet"].size(), 1u) << "nothing else is known";
}

TEST(InfoReport, ConvertsLengthsAreasAndVolumes) {
  InfoReport report = two_bodies();
  report.units = LengthUnit::inch;
  const Json info = Json::parse(info_json(report));
  EXPECT_EQ(info["units"], "inch");
  const Json lid = info["bodies"][0];
  for (int i = 0; i < 3; ++i)
    EXPECT_DOUBLE_EQ(lid["size"][i], i + 1.0);
  EXPECT_DOUBLE_EQ(lid["volume"], 2.0);
  EXPECT_DOUBLE_EQ(lid["sheet"]["thickness"], 0.1);
  EXPECT_DOUBLE_EQ(lid["sheet"]["flange_faces"][0]["area"], 2.0);
}

TEST(InfoReport, IsRefusedWhereTheFileIs) {
  InfoReport report;
  report.input = "gone.step";
  const Json info = Json::parse(info_json(report, Error{code::cannot_read, "gone", "gone.step"}));
  EXPECT_EQ(mistake_of(info), "");
  EXPECT_EQ(info["status"], "refused");
  EXPECT_EQ(info["input"], "gone.step");
  EXPECT_EQ(info["reason"]["code"], "cannot_read");
  EXPECT_TRUE(info["bodies"].empty());
}

TEST(InfoReport, IsReadOnATerminal) {
  InfoReport report = two_bodies();
  report.units = LengthUnit::inch;
  const std::string text = info_text(report);
  EXPECT_THAT(text, AllOf(HasSubstr("STEP AP214"), HasSubstr("Cad 1"), HasSubstr("2 different")));
  EXPECT_THAT(text, HasSubstr("1.0000 × 2.0000 × 3.0000"));
  EXPECT_THAT(text, AllOf(HasSubstr("S235"), HasSubstr("#c0c0c0"), HasSubstr("not_a_sheet")));
  EXPECT_THAT(text, AllOf(HasSubstr("0.1 in"), HasSubstr("2 flanges"), HasSubstr("1 bend;"),
                          HasSubstr(" 7 (2.0000), 12 (1.0000)")));
  EXPECT_THAT(text, HasSubstr("1 shell"));
}

TEST(InfoReport, LeavesOutOnATerminalWhatNobodySays) {
  InfoReport report = two_bodies();
  report.bodies.pop_back();
  report.bodies[0].sheet.reset();
  report.surface_bodies = 0;
  report.cad_system.clear();
  report.schema = "B-rep of the kernel";
  const std::string text = info_text(report);
  EXPECT_THAT(text, AllOf(HasSubstr("not stated"), HasSubstr("1 body,"), Not(HasSubstr("STEP B")),
                          Not(HasSubstr("material")), Not(HasSubstr("colour")),
                          Not(HasSubstr("shell")), Not(HasSubstr("sheet"))));
  report.bodies[0].colour = "#ff0000";
  EXPECT_THAT(info_text(report), AllOf(HasSubstr("#ff0000"), Not(HasSubstr("material"))));
  report.bodies[0].name = "red\033[31m";
  EXPECT_THAT(info_text(report), Not(HasSubstr("\033")));
}

}  // namespace
}  // namespace planish::job
