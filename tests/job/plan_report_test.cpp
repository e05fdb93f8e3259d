#include "plan_report.hpp"

#include "job/planned_reports.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

namespace planish::job {
namespace {

using schema::first_mistake;
using schema::Json;
using test::infeasible_report;
using test::planned_report;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

Json plan_of(const Report& report) { return plan_json(*report.plan, report); }

std::string mistake_in(const Json& plan) {
  const auto wrong = first_mistake(plan_schema(), plan);
  return wrong ? wrong->pointer + " is wrong" : "";
}

TEST(PlanReport, CallsBendsAsThePatternDoes) {
  Report report = planned_report();
  report.flat.bends[0].id = "B9";
  EXPECT_EQ(flange_id(FlangeId{2}), "F3");
  EXPECT_EQ(bend_id(report, BendId{0}), "B9");
  EXPECT_EQ(bend_id(report, BendId{6}), "B7") << "of one that the pattern does not have";
  EXPECT_THAT(bend_ids(report, {BendId{1}, BendId{0}}), ElementsAre("B2", "B9"));
}

TEST(PlanReport, HasOneRowAStroke) {
  const Json plan = plan_of(planned_report());
  EXPECT_EQ(mistake_in(plan), "");
  EXPECT_EQ(plan["status"], "optimal");
  EXPECT_EQ(plan["cost"], 7.5);
  EXPECT_EQ(plan["turn_overs"], 1);
  EXPECT_EQ(plan["rotations"], 2);
  EXPECT_EQ(plan["tool_changes"], 3);
  EXPECT_EQ(plan["ungauged"], 4);
  EXPECT_EQ(plan["states"], 17);
  ASSERT_EQ(plan["strokes"].size(), 2u);
  EXPECT_FALSE(plan.contains("proposals"));
  EXPECT_FALSE(plan.contains("unformed"));
  EXPECT_FALSE(plan.contains("in_the_way"));
  const Json stroke = plan["strokes"][0];
  EXPECT_EQ(stroke["bends"], Json({"B1"}));
  EXPECT_DOUBLE_EQ(stroke["angle"], 90.0);
  EXPECT_EQ(stroke["punch"], "P88");
  EXPECT_EQ(stroke["die"], "V16");
  EXPECT_EQ(stroke["punch_segments"], Json::parse("[40.0, 15.0]"));
  EXPECT_EQ(stroke["punch_from"], 5.08);
  EXPECT_EQ(stroke["die_segments"], Json::parse("[55.0]"));
  EXPECT_EQ(stroke["die_from"], 0.0);
  EXPECT_EQ(stroke["side_up"], "reference");
  EXPECT_EQ(stroke["to_gauge"], "F2");
  EXPECT_EQ(stroke["gauge_direction"], Json::parse("[1.0, 0.0]"));
  EXPECT_EQ(stroke["gauge"],
            Json::parse(R"({"distance": 60.0, "edge": [[100.0, 0.0], [100.0, 60.0]],
                            "touched": 60.0})"));
  EXPECT_EQ(stroke["force"], 12.34);
  EXPECT_EQ(stroke["clearance"], 2.54);
  for (const char* key : {"press_line", "flattening", "punch_rows", "die_rows"})
    EXPECT_FALSE(stroke.contains(key)) << key;
  EXPECT_EQ(plan["strokes"][1]["side_up"], "other");
  EXPECT_EQ(plan["strokes"][1]["gauge_direction"], Json::parse("[-1.0, 0.0]"));
}

TEST(PlanReport, TellsRowsLinesAndHemsWhereThereAreAny) {
  Report report = planned_report();
  Stroke& stroke = report.plan->strokes[0];
  stroke.press_line = 0;
  stroke.flattening = true;
  stroke.punch_rows.push_back({50.0, {5.0}});
  stroke.to_gauge.reset();
  stroke.gauge.reset();
  const Json plan = plan_of(report);
  EXPECT_EQ(mistake_in(plan), "");
  const Json row = plan["strokes"][0];
  EXPECT_EQ(row["press_line"], 1) << "people count from 1";
  EXPECT_EQ(row["flattening"], true);
  EXPECT_EQ(row["punch_segments"], Json::parse("[40.0, 15.0, 5.0]"));
  EXPECT_EQ(row["punch_from"], 5.08);
  EXPECT_EQ(row["punch_rows"], Json::parse(R"([{"from": 5.08, "segments": [40.0, 15.0]},
                                               {"from": 50.0, "segments": [5.0]}])"));
  EXPECT_FALSE(row.contains("die_rows"));
  EXPECT_TRUE(row["to_gauge"].is_null());
  EXPECT_TRUE(row["gauge"].is_null());
}

TEST(PlanReport, TellsTheFlangeThatTouchesTheGauge) {
  Report report = planned_report();
  report.units = LengthUnit::inch;
  EXPECT_FALSE(plan_of(report)["strokes"][0]["gauge"].contains("flange"));
  EXPECT_FALSE(plan_of(report)["strokes"][0]["gauge"].contains("height"));
  report.plan->strokes[0].gauge->height = 25.4;
  EXPECT_DOUBLE_EQ(plan_of(report)["strokes"][0]["gauge"]["height"], 1.0);
  report.plan->strokes[0].gauge->flange = FlangeId{2};
  report.plan->strokes[0].gauge->height = -25.4;
  const Json plan = plan_of(report);
  EXPECT_EQ(mistake_in(plan), "");
  EXPECT_EQ(plan["strokes"][0]["gauge"]["flange"], "F3");
  EXPECT_DOUBLE_EQ(plan["strokes"][0]["gauge"]["height"], -1.0);
}

TEST(PlanReport, TellsWhichFoldTouches) {
  Report report = planned_report();
  report.plan->strokes[0].gauge->fold = BendId(0);
  report.plan->strokes[0].gauge->height = 1.25;
  const Json plan = plan_of(report);
  EXPECT_EQ(mistake_in(plan), "");
  EXPECT_EQ(plan["strokes"][0]["gauge"]["fold"], "B1");
  EXPECT_DOUBLE_EQ(plan["strokes"][0]["gauge"]["height"], 1.25);
}

TEST(PlanReport, TellsThatTheNoseTouchesInAnOpening) {
  Report report = planned_report();
  EXPECT_FALSE(plan_of(report)["strokes"][0]["gauge"].contains("opening"));
  EXPECT_THAT(plan_text(*report.plan, report), Not(HasSubstr("in the opening")));
  report.plan->strokes[0].gauge->in_opening = true;
  const Json plan = plan_of(report);
  EXPECT_EQ(mistake_in(plan), "");
  EXPECT_EQ(plan["strokes"][0]["gauge"]["opening"], true);
  EXPECT_THAT(plan_text(*report.plan, report), HasSubstr("60.000 in the opening"));
}

TEST(PlanReport, ConvertsLengths) {
  Report report = planned_report();
  report.units = LengthUnit::inch;
  report.plan->strokes[0].punch_rows.push_back({50.8, {25.4}});
  const Json row = plan_of(report)["strokes"][0];
  EXPECT_DOUBLE_EQ(row["punch_from"], 0.2);
  EXPECT_DOUBLE_EQ(row["punch_segments"][2], 1.0);
  EXPECT_DOUBLE_EQ(row["punch_rows"][1]["from"], 2.0);
  EXPECT_DOUBLE_EQ(row["clearance"], 0.1);
  EXPECT_DOUBLE_EQ(row["gauge"]["distance"].get<double>() * 25.4, 60.0);
  EXPECT_DOUBLE_EQ(row["gauge"]["edge"][1][1].get<double>() * 25.4, 60.0);
  EXPECT_EQ(row["force"], 12.34);
  EXPECT_DOUBLE_EQ(row["angle"], 90.0);
  report = infeasible_report();
  report.units = LengthUnit::inch;
  EXPECT_DOUBLE_EQ(plan_of(report)["blocked"][0]["depth"], 0.125);
}

TEST(PlanReport, HasNoCostWithoutAPlan) {
  Report report = planned_report();
  for (const auto& [status, word, found] : {std::tuple{PlanStatus::optimal, "optimal", true},
                                            {PlanStatus::feasible, "feasible", true},
                                            {PlanStatus::infeasible, "infeasible", false},
                                            {PlanStatus::gave_up, "gave_up", false}}) {
    report.plan->status = status;
    const Json plan = plan_of(report);
    EXPECT_EQ(plan["status"], word);
    EXPECT_EQ(plan["cost"].is_number(), found) << word;
    EXPECT_EQ(plan.contains("proposals"), status == PlanStatus::infeasible) << word;
    EXPECT_EQ(mistake_in(plan), "");
  }
}

TEST(PlanReport, IsNoPlanWhereNothingIsBent) {
  Report report = planned_report();
  report.plan->strokes.clear();
  report.plan->cost = 0.0;
  const Json plan = plan_of(report);
  EXPECT_EQ(mistake_in(plan), "");
  EXPECT_EQ(plan["status"], "nothing_to_bend");
  EXPECT_EQ(plan_text(*report.plan, report), "plan: nothing to bend\n");
  report.plan->status = PlanStatus::infeasible;
  EXPECT_EQ(plan_of(report)["status"], "infeasible");
}

TEST(PlanReport, TellsWhatToMeasureAfterAStroke) {
  const Report report = planned_report();
  const Json row = stroke_json(report.plan->strokes[0], CheckDimension{FlangeId{1}, 25.4}, report);
  EXPECT_EQ(row["check_dimension"], Json::parse(R"({"flange": "F2", "length": 25.4})"));
  Report inches = report;
  inches.units = LengthUnit::inch;
  EXPECT_DOUBLE_EQ(stroke_json(report.plan->strokes[0], CheckDimension{FlangeId{1}, 25.4},
                               inches)["check_dimension"]["length"],
                   1.0);
  EXPECT_FALSE(stroke_json(report.plan->strokes[0], {}, report).contains("check_dimension"));
}

TEST(PlanReport, WritesCostsInPlainDigits) {
  Report report = planned_report();
  report.plan->cost = 2345678.0;
  EXPECT_THAT(plan_text(*report.plan, report), HasSubstr("cost 2345678:"));
}

TEST(PlanReport, SaysWhatIsInTheWay) {
  Report report = infeasible_report();
  report.plan->unformed = {BendId{1}};
  report.plan->in_the_way = report.plan->blocked;
  BlockedBend without;
  without.bend = BendId{0};
  without.why = Remark{"short_side", tell("a side is {is} long", {{"is", 2.5, unit::mm}})};
  report.plan->blocked.push_back(without);
  const Json plan = plan_of(report);
  EXPECT_EQ(mistake_in(plan), "");
  EXPECT_EQ(plan["blocked"][0], Json::parse(R"({"bend": "B2", "hits": "punch P88", "tool": "punch",
                                                "tool_id": "P88", "with": "F4", "depth": 3.175,
                                                "at_turn": 72.0})"));
  EXPECT_EQ(plan["blocked"][1],
            Json::parse(R"({"bend": "B1", "hits": null, "tool": null, "with": null, "depth": 0.0,
                            "at_turn": null, "why": "a side is 2.5 mm long",
                            "remark": {"code": "short_side", "message": "a side is 2.5 mm long",
                                       "places": [],
                                       "numbers": {"is": {"value": 2.5, "unit": "mm"}}}})"));
  EXPECT_EQ(plan["unformed"], Json({"B2"}));
  EXPECT_EQ(plan["in_the_way"], Json::array({plan["blocked"][0]}));
  EXPECT_EQ(plan["proposals"].size(), 1u);
}

TEST(PlanReport, HasRemarksAsData) {
  Report report = planned_report();
  EXPECT_EQ(plan_of(report)["remarks"], Json::array());
  report.plan->remarks = {
      {"rolled", tell("no stroke bends {@bend}", {{"bend", place::bend("B1")}})}};
  const Json plan = plan_of(report);
  EXPECT_EQ(mistake_in(plan), "");
  EXPECT_EQ(plan["remarks"],
            Json::parse(R"([{"code": "rolled", "message": "no stroke bends bend B1",
                             "places": [{"kind": "bend", "id": "B1"}], "numbers": {}}])"));
}

TEST(PlanReport, HasASchemaThatCountsFromOne) {
  Json plan = plan_of(planned_report());
  plan["strokes"][0]["press_line"] = 0;
  EXPECT_THAT(mistake_in(plan), HasSubstr("/strokes/0/press_line"));
  plan = plan_of(planned_report());
  plan["strokes"][1]["gauge"]["edge"].push_back(Json::parse("[1, 2]"));
  EXPECT_THAT(mistake_in(plan), HasSubstr("/strokes/1/gauge/edge"));
  plan = plan_of(planned_report());
  plan["strokes"][1]["gauge_direction"].push_back(0);
  EXPECT_THAT(mistake_in(plan), HasSubstr("/strokes/1/gauge_direction"));
}

TEST(PlanReport, IsATableOnTheTerminal) {
  Report report = planned_report();
  report.plan->strokes[1].gauge.reset();
  report.plan->strokes[1].to_gauge.reset();
  std::istringstream lines(plan_text(*report.plan, report));
  std::string head, titles, first, second;
  std::getline(lines, head);
  std::getline(lines, titles);
  std::getline(lines, first);
  std::getline(lines, second);
  EXPECT_THAT(head, HasSubstr("7.5"));
  EXPECT_THAT(head, HasSubstr("2 strokes, 1 turn-over, 2 rotations, 3 tool changes"));
  EXPECT_THAT(first, ::testing::MatchesRegex(" +1 +B1 +90.0. +P88 +V16 +front +F2 +60.000 +12|"
                                             " +1 +B1 +90.0.. +P88 +V16 +front +F2 +60.000 +12"));
  EXPECT_THAT(second, ::testing::MatchesRegex(" +2 +B2 +30.0.. +P88 +V16 +back +none +12"));
  EXPECT_EQ(lines.peek(), std::char_traits<char>::eof());
}

TEST(PlanReport, SaysOnTheTerminalThatThereIsNone) {
  Report report = infeasible_report();
  EXPECT_THAT(plan_text(*report.plan, report), HasSubstr("17 stages"));
  EXPECT_THAT(plan_text(*report.plan, report), HasSubstr("V10-88"));
  const std::string impossible = plan_text(*report.plan, report);
  report.plan->status = PlanStatus::gave_up;
  report.plan->proposals.clear();
  EXPECT_THAT(plan_text(*report.plan, report), HasSubstr("17 stages"));
  EXPECT_NE(plan_text(*report.plan, report), impossible);
}

}  // namespace
}  // namespace planish::job
