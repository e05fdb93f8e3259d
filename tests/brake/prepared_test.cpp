#include "prepared.hpp"

#include "brake/hemming_tools.hpp"

#include <planish/brake/codes.hpp>

#include <gtest/gtest.h>

#include <functional>

namespace planish::test {
namespace {

using namespace brake_detail;

Result<StrokeInputs> prepared_with(const Sheet& sheet, const BrakeTools& tools,
                                   const PlanOptions& options) {
  return prepared(sheet, flat_sheet(sheet)->layout, tools, options);
}

TEST(Prepared, RefusesOptionsOutOfTheirRange) {
  const BrakeTools tools = plain_tools();
  const Sheet sheet = l_bracket();
  EXPECT_TRUE(prepared_with(sheet, tools, {}));
  const std::vector<std::pair<std::string, std::function<void(PlanOptions&)>>> wrong = {
      {"clearance", [](PlanOptions& o) { o.clearance = -0.1; }},
      {"clearance", [](PlanOptions& o) { o.clearance = INFINITY; }},
      {"shortfall", [](PlanOptions& o) { o.shortfall = -1.0; }},
      {"springback", [](PlanOptions& o) { o.springback = Angle::degrees(-1); }},
      {"springback", [](PlanOptions& o) { o.springback = Angle::degrees(45); }},
      {"tensile_strength", [](PlanOptions& o) { o.tensile_strength = 0.0; }},
      {"tensile_strength", [](PlanOptions& o) { o.tensile_strength = NAN; }},
      {"radius_of_opening", [](PlanOptions& o) { o.radius_of_opening = -0.1; }},
      {"opening", [](PlanOptions& o) { o.opening = 0.0; }},
      {"begin_with", [](PlanOptions& o) { o.begin_with = {BendId(1)}; }}};
  for (const auto& [name, change] : wrong) {
    PlanOptions options;
    change(options);
    const auto made = prepared_with(sheet, tools, options);
    ASSERT_FALSE(made) << name;
    EXPECT_EQ(made.error().code, code::bad_option) << name;
    EXPECT_EQ(made.error().where, name);
  }
  PlanOptions right;
  right.clearance = 1.0;
  right.shortfall = 0.0;
  right.springback = Angle::degrees(2.0);
  right.radius_of_opening = 0.0;
  right.opening = 12.0;
  right.begin_with = {BendId(0)};
  EXPECT_TRUE(prepared_with(sheet, tools, right));
}

TEST(Prepared, RefusesToGaugeInOpeningsWithoutAGauge) {
  BrakeTools tools = plain_tools();
  PlanOptions options;
  options.gauge_openings = true;
  const auto refused = [&] {
    const auto made = prepared_with(l_bracket(), tools, options);
    return made ? std::string() : made.error().where + ": " + made.error().message;
  };
  const std::string without_gauge = refused();
  EXPECT_NE(without_gauge.find("machine.gauge"), std::string::npos) << without_gauge;
  EXPECT_EQ(without_gauge.find("gauge_openings: "), 0u);
  tools.machine.gauge = BackGauge{10, 300, 30, {{0, 0}, {0, -20}, {80, -20}, {80, 0}}};
  EXPECT_EQ(refused(), "");
}

TEST(Prepared, RefusesWrongToolsAndLinesWithoutTools) {
  BrakeTools tools = plain_tools();
  tools.machine.length = -1.0;
  EXPECT_EQ(prepared_with(l_bracket(), tools, {}).error().code, code::bad_tools);
  tools = plain_tools();
  tools.punches[0].angle = Angle::degrees(100);
  tools.punches[0].profile = punch({Angle::degrees(100)}).profile;
  const auto made = prepared_with(l_bracket(), tools, {});
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, code::no_tool);
  EXPECT_EQ(made.error().where, "B1");
}

TEST(Prepared, KnowsTheLinesOfAStroke) {
  const Sheet sheet = hem();
  const auto made = prepared_with(sheet, hemming_tools(), {});
  ASSERT_TRUE(made) << made.error().message;
  EXPECT_EQ(members(lines_of(made->work, {{BendId(0)}})), std::vector<int>{0});
  EXPECT_EQ(members(lines_of(made->work, {{BendId(0)}, std::nullopt, true})), std::vector<int>{1});
  EXPECT_EQ(count(lines_of(made->work, {{BendId(0)}, 0, false})), 0);
  EXPECT_EQ(count(lines_of(made->work, {{BendId(1)}})), 0);
  EXPECT_EQ(name_of(BendId(2)), "B3");
}

}  // namespace
}  // namespace planish::test
