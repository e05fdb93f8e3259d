#include "job/planned_reports.hpp"
#include "report_schema.hpp"

#include <planish/job/run.hpp>
#include <planish/job/transition.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

namespace planish::job {
namespace {

using schema::Json;
using ::testing::HasSubstr;

/// Two pieces, two patches, a bend of one line and one of two, and three rulings.
TransitionReport two_pieces() {
  TransitionReport report;
  report.input = "shop/duct.json";
  report.body = "duct";
  report.summary.thickness = 2.0;
  TransitionPiece piece;
  static_cast<Report&>(piece) = test::planned_report();
  piece.plan.reset();
  piece.body = "duct-1";
  for (FlatBend& bend : piece.flat.bends)
    bend.line_angles.assign(bend.lines.size(), bend.angle);
  piece.flat.bends[0].line_angles = {Angle::degrees(40), Angle::degrees(50)};
  TransitionPiece second = piece;
  second.body = "duct-2";
  report.pieces = {piece, second};
  Transition& made = report.transition;
  made.pieces.resize(2);
  made.area = 25.4 * 25.4;
  made.perimeters = {25.4, 50.8};
  TransitionPatch plane, cone, general;
  cone.kind = PatchKind::cone;
  cone.area = 2 * 25.4 * 25.4;
  cone.border = {0.0, 76.2};
  cone.turn = Angle::degrees(90);
  general.kind = PatchKind::general;
  made.patches = {plane, cone, general};
  made.true_lengths = {{"A", "a1", {Vec3(0, 0, 0), Vec3(25.4, 0, 50.8)}, 76.2, 0, "B1.2"},
                       {"B", "a2", {Vec3(0, 0, 0), Vec3(1, 0, 0)}, 1.0, 1, ""},
                       {"C", "a3", {Vec3(0, 0, 0), Vec3(1, 0, 0)}, 1.0, 2, ""}};
  return report;
}

Json json_of(const TransitionReport& report) { return Json::parse(report_json(report)); }

TEST(TransitionReport, HasTheSurfaceAndItsPatches) {
  TransitionReport report = two_pieces();
  report.units = LengthUnit::inch;
  const Json doc = json_of(report);
  const auto wrong = schema::first_mistake(report_schema(built_in()), doc);
  EXPECT_FALSE(wrong) << (wrong ? wrong->pointer : "");
  EXPECT_EQ(doc["command"], "transition");
  const Json made = doc["transition"];
  EXPECT_DOUBLE_EQ(made["area"], 1.0);
  EXPECT_DOUBLE_EQ(made["perimeters"][0], 1.0);
  EXPECT_DOUBLE_EQ(made["perimeters"][1], 2.0);
  ASSERT_EQ(made["patches"].size(), 3u);
  EXPECT_EQ(made["patches"][0]["kind"], "plane");
  EXPECT_EQ(made["patches"][1]["kind"], "cone");
  EXPECT_EQ(made["patches"][2]["kind"], "general");
  EXPECT_DOUBLE_EQ(made["patches"][1]["area"], 2.0);
  EXPECT_DOUBLE_EQ(made["patches"][1]["borders"][0], 0.0);
  EXPECT_DOUBLE_EQ(made["patches"][1]["borders"][1], 3.0);
  EXPECT_DOUBLE_EQ(made["patches"][1]["turn"], 90.0);
}

TEST(TransitionReport, HasARowForEachPressLine) {
  const Json rows = json_of(two_pieces())["transition"]["press_lines"];
  ASSERT_EQ(rows.size(), 6u);
  EXPECT_EQ(rows[0], Json::parse(R"({"id": "B1.1", "piece": "duct-1", "angle": 40.0,
      "direction": "down", "line": [[40.0, 0.0], [40.0, 20.0]]})"));
  EXPECT_EQ(rows[1]["id"], "B1.2");
  EXPECT_DOUBLE_EQ(rows[1]["angle"], 50.0);
  EXPECT_EQ(rows[2]["id"], "B2") << "of one line";
  EXPECT_EQ(rows[2]["direction"], "up");
  EXPECT_EQ(rows[3]["piece"], "duct-2");
}

TEST(TransitionReport, HasTheTrueLengthsOfThePiecesThatItReports) {
  TransitionReport report = two_pieces();
  report.units = LengthUnit::inch;
  const Json rows = json_of(report)["transition"]["true_lengths"];
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0]["from"], "A");
  EXPECT_EQ(rows[0]["to"], "a1");
  EXPECT_DOUBLE_EQ(rows[0]["length"], 3.0);
  EXPECT_EQ(rows[0]["piece"], "duct-1");
  EXPECT_EQ(rows[0]["press_line"], "B1.2");
  EXPECT_DOUBLE_EQ(rows[0]["points"][1][0], 1.0);
  EXPECT_DOUBLE_EQ(rows[0]["points"][1][2], 2.0);
  EXPECT_EQ(rows[1]["piece"], "duct-2");
  EXPECT_TRUE(rows[1]["press_line"].is_null());
}

TEST(TransitionReport, ListsPiecesWhereThereAreSeveral) {
  TransitionReport report = two_pieces();
  Json doc = json_of(report);
  ASSERT_EQ(doc["pieces"].size(), 2u);
  EXPECT_EQ(doc["pieces"][1]["body"], "duct-2");
  EXPECT_EQ(doc["pieces"][1]["flat"]["bends"].size(), 2u);
  report.pieces.pop_back();
  EXPECT_FALSE(json_of(report).contains("pieces"));
  report.transition.pieces.clear();
  EXPECT_TRUE(json_of(report)["transition"].is_null());
}

TEST(TransitionReport, HasATableOfPatchesOnTheTerminal) {
  TransitionReport report = two_pieces();
  report.files = {"duct-1.dxf"};
  const std::string both = report_text(report);
  EXPECT_THAT(both, HasSubstr("duct-1: "));
  EXPECT_THAT(both, HasSubstr("duct-2: "));
  EXPECT_THAT(both, HasSubstr("cone "));
  const auto count = [&](const std::string& text) {
    std::size_t n = 0;
    for (std::size_t at = both.find(text); at != std::string::npos; at = both.find(text, at + 1))
      ++n;
    return n;
  };
  EXPECT_EQ(count("first profile"), 1u) << "one table for all";
  EXPECT_EQ(count("duct-1.dxf"), 1u);
  EXPECT_GT(both.find("duct-1.dxf"), both.find("duct-2: ")) << "behind the last piece";
  // Patches count from 1, each with its area, borders and turn.
  EXPECT_THAT(std::regex_replace(both, std::regex(" +"), " "),
              HasSubstr("\n2 cone 1290.3 0.000 76.200 90.0°\n"));
  report.pieces.pop_back();
  static_cast<Report&>(report) = report.pieces[0];
  const std::string one = report_text(report);
  EXPECT_THAT(one, HasSubstr("bracket.step: "));
  EXPECT_THAT(one, HasSubstr("first profile"));
}

}  // namespace
}  // namespace planish::job
