#include "bend_order_json.hpp"

#include "job/planned_reports.hpp"

#include <gtest/gtest.h>

namespace planish::job {
namespace {

using schema::Json;
using test::planned_report;

BrakeTools two_of_each() {
  BrakeTools tools;
  tools.machine.name = "brake";
  tools.machine.lower_beam = {{-20, -100}, {20, -100}, {20, -80}, {-20, -80}};
  for (const char* id : {"P88", "P85"})
    tools.punches.push_back({.id = id,
                             .profile = {{0, 0}, {10, 40}, {-10, 40}},
                             .tip_radius = 0.0,
                             .angle = Angle::degrees(28),
                             .segments = {100}});
  for (const char* id : {"V16", "V12"})
    tools.dies.push_back(
        {.id = id,
         .opening = 16,
         .angle = Angle::degrees(88),
         .shoulder_radius = 0.0,
         .profile = {{-20, -60}, {20, -60}, {20, 0}, {8, 0}, {0, -8}, {-8, 0}, {-20, 0}},
         .segments = {100}});
  return tools;
}

CheckedOrder one_stroke() {
  CheckedStroke checked;
  checked.stroke = test::stroke_at_40();
  StrokeScene& scene = checked.scene;
  scene.origin = {40, 0};
  scene.along = {0, 1};
  scene.pattern_up = false;
  scene.held = {10, 5};
  scene.across = 1.5;
  scene.moments = {{Angle::degrees(0), Angle::degrees(1), {2, 3}, 4, 5},
                   {Angle::degrees(90), Angle::degrees(-45), {6, 7}, 8, 9}};
  scene.punch = {{-5, 40}, {35, 15}};
  scene.die = {{0, 55}};
  CheckedOrder order;
  order.strokes = {checked};
  order.cost = 7.5;
  order.turn_overs = 1;
  order.rotations = 2;
  order.tool_changes = 3;
  order.ungauged = 4;
  return order;
}

Json written(const CheckedOrder& order, const Report& report,
             const BrakeTools& tools = two_of_each()) {
  Json doc = checked_order_json(order);
  add_order(doc, order, report, tools);
  return doc;
}

TEST(BendOrderJson, HasTheCostsOfTheWholeOrder) {
  Report report = planned_report();
  report.sheet.thickness = 2.0;
  report.units = LengthUnit::inch;
  const Json doc = written(one_stroke(), report);
  EXPECT_EQ(doc["status"], "possible");
  EXPECT_TRUE(doc["sentence"].is_null());
  EXPECT_EQ(doc["units"], "inch");
  EXPECT_EQ(doc["thickness"], 2.0) << "in mm, as the scenes";
  EXPECT_EQ(doc["cost"], 7.5);
  EXPECT_EQ(doc["turn_overs"], 1);
  EXPECT_EQ(doc["rotations"], 2);
  EXPECT_EQ(doc["tool_changes"], 3);
  EXPECT_EQ(doc["ungauged"], 4);
  EXPECT_EQ(doc["strokes"][0]["bends"], Json({"B1"}));
  EXPECT_TRUE(doc["strokes"][0]["blocked"].is_null());
}

TEST(BendOrderJson, PutsEachStrokeIntoItsScene) {
  Report report = planned_report();
  report.units = LengthUnit::inch;
  const Json scene = written(one_stroke(), report)["strokes"][0]["scene"];
  EXPECT_EQ(scene["origin"], Json::parse("[40.0, 0.0]"));
  EXPECT_EQ(scene["along"], Json::parse("[0.0, 1.0]"));
  EXPECT_EQ(scene["pattern_up"], false);
  EXPECT_EQ(scene["held"], Json::parse("[10.0, 5.0]"));
  EXPECT_EQ(scene["across"], 1.5);
  EXPECT_EQ(scene["punch"], Json::parse("[[-5.0, 40.0], [35.0, 15.0]]"));
  EXPECT_EQ(scene["die"], Json::parse("[[0.0, 55.0]]"));
  EXPECT_EQ(scene["gauge"], Json::parse("[[100.0, 0.0], [100.0, 60.0]]"));
  const Json& moments = scene["moments"];
  EXPECT_DOUBLE_EQ(moments["turn"][1], 90.0);
  EXPECT_DOUBLE_EQ(moments["slope"][1], -45.0);
  EXPECT_EQ(moments["y"], Json::parse("[2.0, 6.0]"));
  EXPECT_EQ(moments["z"], Json::parse("[3.0, 7.0]"));
  EXPECT_EQ(moments["punch"], Json::parse("[4.0, 8.0]"));
  EXPECT_EQ(moments["die"], Json::parse("[5.0, 9.0]"));
  CheckedOrder ungauged = one_stroke();
  ungauged.strokes[0].stroke.gauge.reset();
  EXPECT_TRUE(written(ungauged, report)["strokes"][0]["scene"]["gauge"].is_null());
}

TEST(BendOrderJson, SaysWhatBlocksAStroke) {
  CheckedOrder order = one_stroke();
  for (const auto& [hits, name] : {std::pair{ToolName{ToolKind::punch, "P88"}, "punch P88"},
                                   {{ToolKind::die, "V16"}, "die V16"},
                                   {{ToolKind::upper_beam}, "upper beam"},
                                   {{ToolKind::lower_beam}, "lower beam"}}) {
    order.strokes[0].blocked = test::infeasible_report().plan->blocked[0];
    order.strokes[0].blocked->hits = hits;
    const Json doc = written(order, planned_report());
    EXPECT_EQ(doc["status"], "blocked");
    EXPECT_TRUE(doc["cost"].is_null());
    const Json blocked = doc["strokes"][0]["blocked"];
    EXPECT_EQ(blocked["tool"], Json(kind_name(hits.kind))) << name;
    EXPECT_EQ(blocked["with"], "F4");
    EXPECT_NE(blocked["sentence"].get<std::string>().find(name), std::string::npos);
    std::string whole;
    for (const Json& piece : blocked["wording"])
      whole += piece["text"].get<std::string>();
    EXPECT_EQ(blocked["sentence"], whole);
  }
}

TEST(BendOrderJson, HasTheSectionsOfTheToolsThatAreUsed) {
  BrakeTools tools = two_of_each();
  const Json plain = written(one_stroke(), planned_report(), tools)["tools"];
  EXPECT_EQ(plain["machine"], "brake");
  EXPECT_EQ(plain["punches"].size(), 1u);
  EXPECT_TRUE(plain["punches"].contains("P88"));
  EXPECT_EQ(plain["dies"].size(), 1u);
  EXPECT_TRUE(plain["dies"].contains("V16"));
  EXPECT_TRUE(plain["upper_beams"].empty());
  EXPECT_GE(plain["lower_beam"].size(), 4u);
  EXPECT_TRUE(plain["finger"].empty());
  EXPECT_EQ(plain["finger_width"], 0.0);
  tools.machine.upper_beam = {{-20, 100}, {20, 100}, {20, 200}, {-20, 200}};
  tools.machine.gauge = BackGauge{10, 500, 60, {{0, 0}, {50, -5}, {50, 30}, {0, 5}}};
  const Json full = written(one_stroke(), planned_report(), tools)["tools"];
  EXPECT_EQ(full["upper_beams"].size(), 1u);
  EXPECT_TRUE(full["upper_beams"].contains("P88"));
  EXPECT_EQ(full["finger"].size(), 4u);
  EXPECT_EQ(full["finger_width"], 60.0);
  EXPECT_TRUE(full["nose"].empty());
  EXPECT_EQ(full["nose_width"], 0.0);
  tools.machine.gauge->nose = GaugeNose{8, {{0, 0}, {6, -3}, {6, 9}}};
  const Json nosed = written(one_stroke(), planned_report(), tools)["tools"];
  EXPECT_EQ(nosed["nose"].size(), 3u);
  EXPECT_EQ(nosed["nose_width"], 8.0);
}

TEST(BendOrderJson, SaysWhatBecameOfAPlan) {
  Report report = test::infeasible_report();
  const Remark rolled{"rolled", tell("B3 is rolled", {})};
  report.plan->remarks = {rolled};
  const auto begun = [&](PlanStatus status) {
    report.plan->status = status;
    return planned_order_json(*report.plan, {}, report);
  };
  EXPECT_EQ(begun(PlanStatus::optimal)["status"], "nothing_to_bend") << "without strokes";
  EXPECT_TRUE(begun(PlanStatus::optimal)["sentence"].is_null());
  EXPECT_TRUE(begun(PlanStatus::feasible)["sentence"].is_null());
  const std::string impossible = begun(PlanStatus::infeasible)["sentence"];
  EXPECT_NE(impossible.find("punch P88"), std::string::npos);
  const std::string unknown = begun(PlanStatus::gave_up)["sentence"];
  EXPECT_NE(unknown.find("17"), std::string::npos) << "how many stages were looked at";
  EXPECT_EQ(begun(PlanStatus::gave_up)["notes"], Json({"B3 is rolled"}));
  // Where each bend can be formed, but not in one order, what is in the way at last.
  report.plan->in_the_way = report.plan->blocked;
  report.plan->blocked.clear();
  report.plan->unformed = {BendId{1}};
  report.plan->remarks = {rolled,
                          {kFurthestStage, tell("B2 hits the punch at last", {})},
                          {"rolled", tell("B4 is rolled too", {})}};
  const std::string at_last = begun(PlanStatus::infeasible)["sentence"];
  EXPECT_NE(at_last.find("leaves B2 flat; B2: flange 4 hits punch P88"), std::string::npos)
      << at_last;
  EXPECT_EQ(at_last.find("rolled"), std::string::npos);
  EXPECT_EQ(at_last.find("at best"), std::string::npos);
}

}  // namespace
}  // namespace planish::job
