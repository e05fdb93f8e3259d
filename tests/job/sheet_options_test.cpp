#include "job/option_meanings.hpp"
#include "option_tables.hpp"

#include <gtest/gtest.h>

namespace planish::job {
namespace {

TEST(SheetOptions, SetWhatTheyAreNamedFor) {
  test::expect_meanings(
      {{"k", "0.25", [](auto& r) { return std::get<ConstantK>(*r.allowance).k == 0.25; }},
       {"din6935", "true", [](auto& r) { return std::holds_alternative<Din6935>(*r.allowance); }},
       {"bend_k", "B2=0.3",
        [](auto& r) {
          return r.bend_k == std::vector<std::pair<std::string, double>>{{"B2", 0.3}};
        }},
       {"root", "12", [](auto& r) { return r.root == "12"; }},
       {"up", "other", [](auto& r) { return r.up == "other"; }},
       {"thickness", "1.5", [](auto& r) { return r.thickness == 1.5; }},
       {"rip_edges", "21,56",
        [](auto& r) {
          return r.rip_edges == std::vector<int>{21, 56};
        }},
       {"rip_edges", "7", [](auto& r) { return r.rip_edges == std::vector<int>{7}; }},
       {"inside_radius", "2.5", [](auto& r) { return r.join.inside_radius == 2.5; }},
       {"lateral", "auto", [](auto& r) { return r.join.lateral == LateralBoundary::automatic; }},
       {"lateral", "straight", [](auto& r) { return r.join.lateral == LateralBoundary::straight; }},
       {"lateral", "arc", [](auto& r) { return r.join.lateral == LateralBoundary::arc; }},
       {"lateral", "corner", [](auto& r) { return r.join.lateral == LateralBoundary::corner; }},
       {"trade_off", "2", [](auto& r) { return r.join.trade_off == 2.0; }},
       {"largest_span", "70", [](auto& r) { return r.join.largest_span == 70.0; }},
       {"trim", "auto", [](auto& r) { return !r.join.trim; }},
       {"trim", "yes", [](auto& r) { return r.join.trim == true; }},
       {"trim", "no", [](auto& r) { return r.join.trim == false; }},
       {"extruded", "pilot", [](auto& r) { return r.extruded == ExtrudedHoles::pilot; }},
       {"extruded", "through", [](auto& r) { return r.extruded == ExtrudedHoles::through; }},
       {"extruded", "outline", [](auto& r) { return r.extruded == ExtrudedHoles::outline; }},
       {"relief", "none", [](auto& r) { return r.relief.shape == Relief::none; }},
       {"relief", "rip", [](auto& r) { return r.relief.shape == Relief::rip; }},
       {"relief", "square", [](auto& r) { return r.relief.shape == Relief::square; }},
       {"relief", "round", [](auto& r) { return r.relief.shape == Relief::round; }},
       {"bend_relief", "none", [](auto& r) { return r.relief.beside_bends == Relief::none; }},
       {"bend_relief", "square", [](auto& r) { return r.relief.beside_bends == Relief::square; }},
       {"bend_relief", "round", [](auto& r) { return r.relief.beside_bends == Relief::round; }},
       {"rip_width", "0.2", [](auto& r) { return r.relief.width == 0.2; }}});
}

TEST(SheetOptions, RefuseEdgesThatAreNoNumbers) {
  for (const char* text : {"0", "-1", "21,", ",21", "21,,5", "21;5", "x", "21 5", "2.5", "21,0"}) {
    OptionValues values;
    ASSERT_TRUE(values.set_text(option("rip_edges"), text));
    Request request;
    const auto entered = values.enter(request);
    ASSERT_FALSE(entered) << text;
    EXPECT_EQ(entered.error().code, code::bad_option);
    EXPECT_EQ(entered.error().where, "rip_edges");
  }
  Request request;
  ASSERT_TRUE(option("rip_edges").set(request, std::string("1,2")));
  ASSERT_TRUE(option("rip_edges").set(request, std::string("3")));
  EXPECT_EQ(request.rip_edges, std::vector<int>{3}) << "instead of those before";
}

TEST(SheetOptions, ReadTheContentOfFiles) {
  Request request;
  ASSERT_TRUE(
      option("k_table").set(request, OptionFile{"shop/steel.csv", "r/t, k\n0.1, 0.3\n9, 0.3\n"}));
  EXPECT_TRUE(std::holds_alternative<BendTable>(*request.allowance));
  EXPECT_FALSE(option("k_table").set(request, OptionFile{"k.csv", "r/t, k\n1, 5\n"}));
  EXPECT_FALSE(option("material").set(request, OptionFile{"m.json", "{}"}));
}

}  // namespace
}  // namespace planish::job
