#include "job/job_requests.hpp"
#include "lay_flat.hpp"
#include "plan_report.hpp"
#include "support/sheets.hpp"

#include <planish/brake/codes.hpp>
#include <planish/job/bend_plan_pages.hpp>
#include <planish/job/maker.hpp>
#include <planish/job/request.hpp>
#include <planish/job/run.hpp>
#include <planish/shop/tools_json.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <numbers>
#include <thread>

namespace planish::job {
using namespace shop;
namespace {

using nlohmann::json;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

std::string channel(double leg) { return test::channel_plates(leg).dump(); }

/// What a maker reports of a channel, with options changed by `change`.
template <typename Change>
std::unique_ptr<Made> made_of(const std::string& input, const Change& change) {
  Request request;
  request.input = "channel.json";
  request.bending.ask = Bending::Ask::plan;
  change(request.bending);
  const auto maker = built_in().maker_for("channel.json", input);
  EXPECT_TRUE(maker);
  const auto work = (*maker)->open({"channel.json", input, {}}, {});
  EXPECT_TRUE(work);
  auto made = shown((*work)->make(request, {}));
  EXPECT_TRUE(made) << made.error().message;
  return std::move(*made);
}

std::vector<std::string> codes_of(const Report& report) {
  std::vector<std::string> codes;
  for (const Finding& finding : report.findings)
    codes.push_back(finding.code);
  return codes;
}

constexpr auto kAsIs = [](Bending&) {};

TEST(Bending, PlansAChannelInTwoStrokesFromOneSide) {
  const auto made = made_of(channel(30), kAsIs);
  ASSERT_FALSE(made->report().refusal) << made->report().refusal->message;
  const json report = json::parse(made->json());
  const json& plan = report["plan"];
  EXPECT_EQ(plan["status"], "optimal");
  ASSERT_EQ(plan["strokes"].size(), 2u);
  EXPECT_EQ(plan["turn_overs"], 0);
  EXPECT_EQ(plan["tool_changes"], 0);
  // Two strokes, and the sheet rotated between them if at all.
  EXPECT_EQ(plan["cost"],
            2.0 + 2.0 * plan["rotations"].get<double>() + 4.0 * plan["ungauged"].get<double>());
  for (const json& stroke : plan["strokes"]) {
    EXPECT_NEAR(stroke["angle"], 90.0, 1e-9);
    // 1.42 · 450 · 2² / 12 N/mm over 100 mm
    EXPECT_NEAR(stroke["force"], 1.42 * 450 * 4 / 12 * 100 / 1000, 0.5);
  }
}

TEST(Bending, NumbersBendsByTheStrokesThatPressThem) {
  const auto made = made_of(channel(30), [](Bending& b) { b.begin_with = {"B2"}; });
  const json report = json::parse(made->json());
  EXPECT_EQ(report["plan"]["strokes"][0]["bends"], json({"B2"}));
  EXPECT_EQ(report["flat"]["bends"][0]["order"], 2);
  EXPECT_EQ(report["flat"]["bends"][1]["order"], 1);
}

TEST(Bending, RefusesABeginningWithABendThatIsNotThere) {
  Request request;
  request.bending.ask = Bending::Ask::plan;
  request.bending.begin_with = {"B3"};
  const auto work = built_in().maker("connect")->open({"c.json", channel(30), {}}, {});
  const auto made = (*work)->make(request, {});
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, code::bad_option);
  EXPECT_EQ(made.error().where, "fix");
  EXPECT_THAT(made.error().message, HasSubstr("B1, B2"));
}

TEST(Bending, RefusesABeginningThatNamesABendTwice) {
  Request request;
  request.bending.ask = Bending::Ask::plan;
  request.bending.begin_with = {"B1", "B2", "B1"};
  const auto work = built_in().maker("connect")->open({"c.json", channel(30), {}}, {});
  const auto made = (*work)->make(request, {});
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().where, "fix");
  EXPECT_THAT(made.error().message, HasSubstr("B1 twice"));
}

TEST(Bending, RefusesAChannelTooDeepForItsTools) {
  // Whichever leg is bent first stands 250 mm high and must pass the beam 120 mm above the tip,
  // 60 mm to either side of it: over a web of 60 mm it cannot.
  const auto made = made_of(channel(250), kAsIs);
  const Report& report = made->report();
  ASSERT_TRUE(report.refusal);
  EXPECT_EQ(report.refusal->code, code::cannot_bend);
  const json told = json::parse(made->json());
  EXPECT_EQ(told["status"], "refused");
  EXPECT_EQ(told["reason"]["code"], "cannot_bend");
  EXPECT_EQ(told["plan"]["status"], "infeasible");
  EXPECT_TRUE(told["plan"]["strokes"].empty());
  EXPECT_TRUE(told["plan"]["cost"].is_null());
  EXPECT_FALSE(told["sheet"].is_null());
  EXPECT_EQ(told["flat"]["bends"].size(), 2u);
}

TEST(Bending, IsAFindingIfOnlyThatIsAsked) {
  const auto deep = made_of(channel(250), [](Bending& b) { b.ask = Bending::Ask::finding; });
  EXPECT_FALSE(deep->report().refusal);
  EXPECT_THAT(codes_of(deep->report()), Contains("cannot_bend"));
  EXPECT_FALSE(deep->report().plan);
  const auto found = std::ranges::find(deep->report().findings, "cannot_bend", &Finding::code);
  ASSERT_FALSE(found->remedies.empty()) << "what it could be bent with";
  EXPECT_THAT(found->message, HasSubstr("; it can be bent "));
  for (const Remedy& remedy : found->remedies)
    EXPECT_THAT(remedy.change, ::testing::StartsWith("Bend it "));
  const auto flat = made_of(channel(30), [](Bending& b) { b.ask = Bending::Ask::finding; });
  EXPECT_THAT(codes_of(flat->report()), Not(Contains("cannot_bend")));
}

TEST(Bending, IsNotLookedAtUnlessAsked) {
  const auto made = made_of(channel(250), [](Bending& b) { b.ask = Bending::Ask::nothing; });
  EXPECT_FALSE(made->report().refusal);
  EXPECT_FALSE(made->report().plan);
  EXPECT_FALSE(json::parse(made->json()).contains("plan"));
}

TEST(Bending, TakesItsToolsFromTheRequest) {
  BrakeTools tools = default_tools();
  std::erase_if(tools.punches, [](const Punch& one) { return one.id != "P85-R1"; });
  std::erase_if(tools.dies, [](const Die& one) { return one.id != "V16-85"; });
  const auto made = made_of(channel(30), [&](Bending& b) { b.tools = tools; });
  ASSERT_TRUE(made->report().plan);
  for (const Stroke& stroke : made->report().plan->strokes) {
    EXPECT_EQ(stroke.punch, "P85-R1");
    EXPECT_EQ(stroke.die, "V16-85");
  }
}

TEST(Bending, TellsThePlanInTheUnitOfTheReport) {
  Request inches;
  inches.units = LengthUnit::inch;
  inches.bending.ask = Bending::Ask::plan;
  const auto work = built_in().maker("connect")->open({"c.json", channel(30), {}}, {});
  const auto in = (*work)->make(inches, {});
  const auto mm = made_of(channel(30), kAsIs);
  ASSERT_TRUE(in);
  const json a = json::parse((*in)->json())["plan"]["strokes"][0];
  const json b = json::parse(mm->json())["plan"]["strokes"][0];
  ASSERT_FALSE(b["gauge"].is_null());
  EXPECT_NEAR(a["gauge"]["distance"].get<double>() * 25.4, b["gauge"]["distance"], 1e-9);
  EXPECT_NEAR(a["punch_segments"][0].get<double>() * 25.4, b["punch_segments"][0], 1e-9);
  EXPECT_NEAR(a["clearance"].get<double>() * 25.4, b["clearance"], 1e-9);
  EXPECT_EQ(a["force"], b["force"]);
}

/// Acute tools turn a panel up by 75° on both sides, past the beam: the punches for hems are tall.
TEST(Bending, HemsLargePanels) {
  for (const double panel : {100.0, 130.0, 600.0}) {
    const Sheet sheet = test::strip(
        {test::Straight{panel}, test::Turn{Angle::degrees(180), 0.5, BendDirection::up},
         test::Straight{12.0}},
        400, 1.0);
    const auto flat = flat_sheet(sheet);
    ASSERT_TRUE(flat);
    const auto plan = plan_bending(sheet, flat->layout, default_tools());
    ASSERT_TRUE(plan) << plan.error().message;
    EXPECT_EQ(plan->status, PlanStatus::optimal) << panel;
    EXPECT_EQ(plan->strokes.size(), 2u);
  }
}

/// Another radius at 90° changes the developed length by (π/2 − 2)(made − drawn) a bend.
TEST(Bending, LaysThePartFlatForTheRadiiThatAreMade) {
  BrakeTools tools = default_tools();
  std::erase_if(tools.dies, [](const Die& one) { return one.id != "V20-85"; });
  const auto made = made_of(channel(60), [&](Bending& b) { b.tools = tools; });
  const Report& report = made->report();
  ASSERT_TRUE(report.plan);
  ASSERT_TRUE(report.as_made);
  ASSERT_EQ(report.as_made->bends.size(), 2u);
  double change = 0.0;
  for (const MadeFlat::Row& row : report.as_made->bends) {
    EXPECT_EQ(row.made, 0.16 * 20.0);
    EXPECT_NEAR(row.change, (std::numbers::pi / 2.0 - 2.0) * (row.made - row.drawn), 1e-9);
    change += row.change;
    // A bend table tells the bend's own allowance, without what the flanges give for its radius.
    const auto& table = report.as_made->flat.bends;
    const auto told = std::ranges::find(table, row.bend, &FlatBend::bend);
    ASSERT_NE(told, table.end());
    EXPECT_NEAR(told->allowance.k_factor, 0.44, 1e-12);
    EXPECT_NEAR(told->allowance.allowance, std::numbers::pi / 2.0 * (3.2 + 0.44 * 2.0), 1e-9);
    EXPECT_NEAR(told->allowance.deduction, 2.0 * (3.2 + 2.0) - told->allowance.allowance, 1e-9);
  }
  const Vec2 grown = report.as_made->size - report.size;
  EXPECT_NEAR(grown.x() + grown.y(), change, 1e-9);
  const json plan = json::parse(made->json())["plan"];
  EXPECT_EQ(plan["as_made"]["bends"].size(), 2u);
  EXPECT_EQ(plan["strokes"][0]["radius_made"], 3.2);
  EXPECT_EQ(plan["strokes"][0]["radius_drawn"], report.as_made->bends[0].drawn);
}

/// 60 + 60 outside in 2 mm over a V of 12, which leaves 1.92 for 0.5 mm: gauge, check and blank are
/// those of one flat, the drawn one or the one as made.
TEST(Bending, GaugesTheFlatThatItMeasures) {
  constexpr double kT = 2.0, kDrawn = 0.5, kMade = 1.92, kLeg = 60.0, kK = 0.4;
  const Sheet sheet = test::strip(
      {test::Straight{kLeg - kDrawn - kT}, test::Turn{Angle::degrees(90), kDrawn},
       test::Straight{kLeg - kDrawn - kT}},
      100, kT);
  const double quarter = 0.25 * std::numbers::pi;
  const double outside = kMade + kT - quarter * (kMade + kK * kT);  // beyond the gauge
  for (const bool as_made : {false, true}) {
    Report report;
    PatternChecks checks;
    checks.bending.ask = Bending::Ask::plan;
    checks.bending.as_made = as_made;
    const EdgeDistance unmeasured;
    const SheetToLay given{sheet, unmeasured, checks};
    ASSERT_FALSE(lay_flat(report, given, {.allowance = ConstantK{kK, "test"}}, {}));
    ASSERT_TRUE(report.plan && report.as_made);
    const Stroke& stroke = report.plan->strokes.front();
    ASSERT_EQ(stroke.radius_made, kMade);
    const double gauge = as_made ? kLeg - outside
                                 : kLeg - kDrawn - kT + quarter * (kDrawn + kK * kT);
    EXPECT_NEAR(stroke.gauge->distance, gauge, 1e-6) << as_made;
    EXPECT_NEAR(checks_of(report, report.plan->strokes)[0]->length, gauge + outside, 1e-6);
    EXPECT_NEAR(report.size.x(), 2.0 * gauge, 1e-6);
    EXPECT_NEAR(report.flat.area, 2.0 * gauge * 100.0, 1e-4);
    Request request;
    request.bending = checks.bending;
    const auto dxf = dxf_as_made(report, request);
    EXPECT_EQ(dxf.has_value(), as_made) << "of the flat that the plan is for";
  }
}

/// Seconds that end the search for proposals are said, as those are that end the search for an
/// order.
TEST(Bending, SaysWhatTheTimeEnded) {
  for (const bool late : {false, true}) {
    Request request;
    request.input = "channel.json";
    request.bending.ask = Bending::Ask::plan;
    request.bending.plan.clearance = 100.0;
    request.bending.plan.limits.seconds = late ? 5.0 : 300.0;
    Progress progress;
    progress.report = [&](std::string_view stage, double) {
      if (late && stage.starts_with("looking for changes"))
        std::this_thread::sleep_for(std::chrono::milliseconds(5'000));
    };
    const std::string input = channel(60);
    const auto work = (*built_in().maker_for("channel.json", input))
                          ->open({"channel.json", input, {}}, {});
    ASSERT_TRUE(work);
    const auto made = shown((*work)->make(request, progress));
    ASSERT_TRUE(made && (*made)->report().plan);
    const auto& remarks = (*made)->report().plan->remarks;
    EXPECT_EQ(std::ranges::count(remarks, std::string_view("timed_out"), &Remark::code), late);
  }
}

/// All rounds of a plan over the flat as made have one time: it is over before the second begins.
TEST(Bending, PlansTheFlatAsMadeWithinTheSameTime) {
  for (const bool late : {false, true}) {
    Request request;
    request.input = "channel.json";
    request.bending.ask = Bending::Ask::plan;
    request.bending.as_made = true;
    request.bending.plan.opening = 20.0;  // leaves 3.2 mm, and 2 mm is drawn
    request.bending.plan.limits.seconds = late ? 5.0 : 300.0;
    int rounds = 0;
    Progress progress;
    progress.report = [&](std::string_view stage, double) {
      if (stage == "ordering the bends" && ++rounds == 2 && late)
        std::this_thread::sleep_for(std::chrono::milliseconds(5'000));
    };
    const std::string input = channel(60);
    const auto work = (*built_in().maker_for("channel.json", input))
                          ->open({"channel.json", input, {}}, {});
    ASSERT_TRUE(work);
    const auto made = shown((*work)->make(request, progress));
    ASSERT_TRUE(made && (*made)->report().plan);
    EXPECT_EQ(rounds, 2);
    const auto& missing = (*made)->report().not_as_made;
    ASSERT_EQ(missing.has_value(), late);
    if (late) {
      EXPECT_NE(missing->message.find("5 s"), std::string::npos) << missing->message;
    }
  }
}

/// The V that differs, and the press that is too weak, as a person is told them.
TEST(Bending, HoldsTheForceAgainstThePress) {
  BrakeTools tools = default_tools();
  tools.machine.force = 0.5;
  const auto weak = made_of(channel(60), [&](Bending& b) { b.tools = tools; });
  ASSERT_TRUE(weak->report().refusal);
  EXPECT_EQ(weak->report().refusal->code, code::press_too_small);
  EXPECT_THAT(weak->report().refusal->message, HasSubstr("the machine has 0.5 kN"));
}

}  // namespace
}  // namespace planish::job
