#include "job/job_requests.hpp"

#include <planish/brake/codes.hpp>
#include <planish/job/bend_order.hpp>

#include <gtest/gtest.h>

namespace planish::job {
namespace {

using nlohmann::json;

const Report& channel_report() {
  static const auto made = test::made_from("channel.json", test::channel_plates(30).dump());
  return made->report();
}

BendOrder order_of_channel(Bending bending = {}) {
  auto order = BendOrder::make(channel_report(), std::move(bending));
  EXPECT_TRUE(order) << (order ? "" : order.error().message);
  return std::move(*order);
}

TEST(BendOrder, IsTheCheapestOneThatIsFound) {
  const auto text = order_of_channel().plan({});
  ASSERT_TRUE(text) << text.error().message;
  const json plan = json::parse(*text);
  EXPECT_EQ(plan["status"], "optimal");
  EXPECT_TRUE(plan["sentence"].is_null());
  ASSERT_EQ(plan["strokes"].size(), 2u);
  EXPECT_EQ(plan["thickness"], 2.0);
  EXPECT_EQ(plan["units"], "mm");
  // Two strokes and what is done between them, at the usual weights.
  EXPECT_EQ(plan["cost"].get<double>(),
            2.0 + 3.0 * plan["turn_overs"].get<double>() + 2.0 * plan["rotations"].get<double>() +
                5.0 * plan["tool_changes"].get<double>() + 4.0 * plan["ungauged"].get<double>());
  for (const json& stroke : plan["strokes"]) {
    EXPECT_TRUE(stroke["blocked"].is_null());
    EXPECT_TRUE(plan["tools"]["punches"].contains(stroke["punch"].get<std::string>()));
    EXPECT_TRUE(plan["tools"]["dies"].contains(stroke["die"].get<std::string>()));
  }
}

TEST(BendOrder, IsCheckedAsItIsGiven) {
  BendOrder order = order_of_channel();
  for (const auto& [asked, first] : {std::pair{R"([{"bends": ["B2"]}, {"bends": ["B1"]}])", "B2"},
                                     {R"([{"bends": ["B1"]}, {"bends": ["B2"]}])", "B1"}}) {
    const auto text = order.check(asked, {});
    ASSERT_TRUE(text) << text.error().message;
    const json checked = json::parse(*text);
    EXPECT_EQ(checked["status"], "possible");
    EXPECT_EQ(checked["strokes"][0]["bends"], json({first}));
    EXPECT_TRUE(checked["notes"].empty());
  }
  const auto rest = order.check(R"([{"bends": ["B2"]}])", {});
  EXPECT_EQ(json::parse(*rest)["strokes"].size(), 2u) << "what it leaves out follows";
}

/// The sides of a U with a foot are 16 mm apart, too near for a punch between them: the plan rolls
/// it, and so do orders that are checked after it.
TEST(BendOrder, FormsLargeBendsAsThePlan) {
  const auto made = test::made_from("u.json", R"({"thickness": 2, "plates": [
      {"id": "a", "outline": [[10, 0, 0], [100, 0, 0], [100, 90, 0], [10, 90, 0]]},
      {"id": "b", "outline": [[10, 0, 18], [100, 0, 18], [100, 90, 18], [10, 90, 18]]},
      {"id": "c", "outline": [[105, 0, -5], [105, 0, -40], [105, 90, -40], [105, 90, -5]]}],
      "bends": [{"between": ["a", "b"], "inside_radius": 8},
                {"between": ["a", "c"], "inside_radius": 2}]})");
  auto order = BendOrder::make(made->report(), {});
  ASSERT_TRUE(order) << order.error().message;
  const json plan = json::parse(*order->plan({}));
  EXPECT_EQ(plan["status"], "optimal");
  ASSERT_EQ(plan["strokes"].size(), 1u);
  EXPECT_EQ(plan["strokes"][0]["bends"], json({"B2"}));
  const json checked = json::parse(*order->check(R"([{"bends": ["B2"]}])", {}));
  EXPECT_EQ(checked["strokes"].size(), 1u);
}

TEST(BendOrder, BeginsAsItIsTold) {
  Bending bending;
  bending.begin_with = {"B2"};
  const json plan = json::parse(*order_of_channel(bending).plan({}));
  EXPECT_EQ(plan["strokes"][0]["bends"], json({"B2"}));
  bending.begin_with = {"B7"};
  const auto none = BendOrder::make(channel_report(), bending);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code, code::bad_option);
}

TEST(BendOrder, SaysWhereAnOrderIsWrong) {
  BendOrder order = order_of_channel();
  for (const auto& [asked, where] :
       {std::pair{"7", "/order"},
        {R"([{"bends": "B1"}])", "/order/0/bends"},
        {R"([{"bends": ["B1"]}, {"bends": ["B9"]}])", "/order/1"},
        {R"([{"bends": ["B1"], "press_line": 0}])", "/order/0/press_line"},
        {R"([{"bends": ["B1"], "x": 0}])", "/order/0/x"}}) {
    const auto checked = order.check(asked, {});
    ASSERT_FALSE(checked) << asked;
    EXPECT_EQ(checked.error().code, code::invalid_input);
    EXPECT_EQ(checked.error().where, where) << asked;
    EXPECT_EQ(std::ranges::count(checked.error().places, place::pointer(where)), 1) << asked;
  }
  std::string many = "[";
  for (int i = 0; i <= 10'000; ++i)
    many += std::string(i ? "," : "") + R"({"bends": ["B1"]})";
  EXPECT_EQ(order.check(many + "]", {}).error().where, "/order");
  EXPECT_EQ(order.check(R"([{"bends": ["B1"]}, {"bends": ["B1"]}])", {}).error().code,
            code::bad_option)
      << "bent twice";
}

TEST(BendOrder, NeedsAPattern) {
  Report refused;
  refused.refusal = Error{code::cannot_bend, "m", "w"};
  EXPECT_EQ(BendOrder::make(refused, {}).error().where, "w");
}

TEST(ReadBending, TakesWhatIsOfThePressBrakeAlone) {
  Bending usual;
  usual.plan.clearance = 2.0;
  usual.plan.shortfall = 7.0;
  const auto bending = read_bending(R"({"clearance": 0.5, "fix": "B2,B1", "metal": "stainless"})",
                                    "/options", usual);
  ASSERT_TRUE(bending) << bending.error().message;
  EXPECT_EQ(bending->plan.clearance, 0.5);
  EXPECT_EQ(bending->plan.shortfall, 7.0) << "as it was";
  EXPECT_EQ(bending->plan.tensile_strength, 700.0);
  EXPECT_EQ(bending->begin_with, (std::vector<std::string>{"B2", "B1"}));
  for (const auto& [text, where] : {std::pair{R"({"k": 0.4})", "/options/k"},
                                    {R"({"first": true})", "/options/first"},
                                    {R"({"check_bending": true})", "/options/check_bending"},
                                    {R"({"clearance": -1})", "/options/clearance"},
                                    {R"({"weights": "turn=1"})", "/options/weights"},
                                    {R"({"tools": "tools.json"})", "/options/tools"}})
    EXPECT_EQ(read_bending(text, "/options").error().where, where) << text;
}

}  // namespace
}  // namespace planish::job
