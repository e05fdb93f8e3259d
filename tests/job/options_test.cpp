#include <planish/job/options.hpp>

#include <gtest/gtest.h>

#include <functional>
#include <set>

namespace planish::job {
namespace {

Request with_text(const char* name, const char* text) {
  OptionValues values;
  const auto set = values.set_text(option(name), text);
  EXPECT_TRUE(set) << name << " " << text;
  Request request;
  const auto entered = values.enter(request);
  EXPECT_TRUE(entered) << name << " " << text;
  return request;
}

struct Meaning {
  const char *name, *text;
  std::function<bool(const Request&)> holds;
};

TEST(Options, SetWhatTheyAreNamedFor) {
  const Rules laser = rules_for(Process::laser), punch = rules_for(Process::punch);
  ASSERT_NE(laser.opening_to_edge_t, punch.opening_to_edge_t);
  for (const Meaning& one : std::vector<Meaning>{
           {"body", "door", [](auto& r) { return r.body == "door"; }},
           {"units", "inch", [](auto& r) { return r.units == LengthUnit::inch; }},
           {"units", "m", [](auto& r) { return r.units == LengthUnit::m; }},
           {"units", "mm", [](auto& r) { return r.units == LengthUnit::mm; }},
           {"piece", "3", [](auto& r) { return r.piece == 3; }},
           {"k", "0.25", [](auto& r) { return std::get<ConstantK>(*r.allowance).k == 0.25; }},
           {"din6935", "true",
            [](auto& r) { return std::holds_alternative<Din6935>(*r.allowance); }},
           {"bend_k", "B2=0.3",
            [](auto& r) {
              return r.bend_k == std::vector<std::pair<std::string, double>>{{"B2", 0.3}};
            }},
           {"root", "12", [](auto& r) { return r.root == "12"; }},
           {"up", "other", [](auto& r) { return r.up == "other"; }},
           {"rip_edges", "21,56",
            [](auto& r) {
              return r.rip_edges == std::vector<int>{21, 56};
            }},
           {"rip_edges", "7", [](auto& r) { return r.rip_edges == std::vector<int>{7}; }},
           {"inside_radius", "2.5", [](auto& r) { return r.join.inside_radius == 2.5; }},
           {"lateral", "auto",
            [](auto& r) { return r.join.lateral == LateralBoundary::automatic; }},
           {"lateral", "straight",
            [](auto& r) { return r.join.lateral == LateralBoundary::straight; }},
           {"lateral", "arc", [](auto& r) { return r.join.lateral == LateralBoundary::arc; }},
           {"lateral", "corner", [](auto& r) { return r.join.lateral == LateralBoundary::corner; }},
           {"trade_off", "2", [](auto& r) { return r.join.trade_off == 2.0; }},
           {"largest_span", "70", [](auto& r) { return r.join.largest_span == 70.0; }},
           {"extruded", "pilot", [](auto& r) { return r.extruded == ExtrudedHoles::pilot; }},
           {"extruded", "through", [](auto& r) { return r.extruded == ExtrudedHoles::through; }},
           {"extruded", "outline", [](auto& r) { return r.extruded == ExtrudedHoles::outline; }},
           {"relief", "none", [](auto& r) { return r.relief.shape == Relief::none; }},
           {"relief", "rip", [](auto& r) { return r.relief.shape == Relief::rip; }},
           {"relief", "square", [](auto& r) { return r.relief.shape == Relief::square; }},
           {"relief", "round", [](auto& r) { return r.relief.shape == Relief::round; }},
           {"bend_relief", "none", [](auto& r) { return r.relief.beside_bends == Relief::none; }},
           {"bend_relief", "square",
            [](auto& r) { return r.relief.beside_bends == Relief::square; }},
           {"bend_relief", "round", [](auto& r) { return r.relief.beside_bends == Relief::round; }},
           {"rip_width", "0.2", [](auto& r) { return r.relief.width == 0.2; }},
           {"profile", "default", [](auto& r) { return r.dxf.profile == LayerProfile::standard; }},
           {"profile", "inventor", [](auto& r) { return r.dxf.profile == LayerProfile::inventor; }},
           {"profile", "onshape", [](auto& r) { return r.dxf.profile == LayerProfile::onshape; }},
           {"profile", "solidedge",
            [](auto& r) { return r.dxf.profile == LayerProfile::solid_edge; }},
           {"r12", "true", [](auto& r) { return r.dxf.version == DxfVersion::r12; }},
           {"r12", "false", [](auto& r) { return r.dxf.version == DxfVersion::r2000; }},
           {"splines", "keep", [](auto& r) { return r.dxf.splines == Splines::keep; }},
           {"splines", "arcs", [](auto& r) { return r.dxf.splines == Splines::arcs; }},
           {"arc_tolerance", "0.5", [](auto& r) { return r.dxf.arc_tolerance == 0.5; }},
           {"bend_marks", "ticks", [](auto& r) { return r.dxf.bend_marks == BendMarks::ticks; }},
           {"bend_marks", "lines", [](auto& r) { return r.dxf.bend_marks == BendMarks::lines; }},
           {"tangent_lines", "true", [](auto& r) { return r.dxf.tangent_lines; }},
           {"bend_text", "true", [](auto& r) { return r.dxf.bend_text; }},
           {"turn_to_blank", "true", [](auto& r) { return r.dxf.turn_to_blank; }},
           {"process", "laser",
            [&](auto& r) { return r.rules.opening_to_edge_t == laser.opening_to_edge_t; }},
           {"process", "punch",
            [&](auto& r) { return r.rules.opening_to_edge_t == punch.opening_to_edge_t; }},
           {"no_rules", "true", [](auto& r) { return !r.rules.enabled; }},
           {"no_rules", "false", [](auto& r) { return r.rules.enabled; }},
           {"write_overlapping", "true", [](auto& r) { return r.write_overlapping; }},
           {"density", "7.85", [](auto& r) { return r.density == 7.85; }}})
    EXPECT_TRUE(one.holds(with_text(one.name, one.text))) << one.name << " " << one.text;
}

TEST(Options, SetTheLengthOfTicksBesideTicks) {
  OptionValues values;
  ASSERT_TRUE(values.set_text(option("tick_length"), "3"));
  ASSERT_TRUE(values.set_text(option("bend_marks"), "ticks"));
  Request request;
  ASSERT_TRUE(values.enter(request));
  EXPECT_EQ(request.dxf.tick_length, 3.0);
}

TEST(Options, ReadTheContentOfFiles) {
  Request request;
  ASSERT_TRUE(
      option("k_table").set(request, OptionFile{"shop/steel.csv", "r/t, k\n0.1, 0.3\n9, 0.3\n"}));
  const auto* table = std::get_if<BendTable>(&*request.allowance);
  ASSERT_NE(table, nullptr);
  EXPECT_FALSE(option("rules").set(request, OptionFile{"rules.json", "{"}));
  ASSERT_TRUE(option("rules").set(request, OptionFile{"rules.json", R"({"k_low": 0.15})"}));
  EXPECT_EQ(request.rules.k_low, 0.15);
  EXPECT_FALSE(option("k_table").set(request, OptionFile{"k.csv", "r/t, k\n1, 5\n"}));
  EXPECT_FALSE(option("shop").set(request, OptionFile{"shop.json", "{}"}));
  EXPECT_FALSE(option("material").set(request, OptionFile{"m.json", "{}"}));
}

TEST(Options, RefuseEdgesThatAreNoNumbers) {
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

TEST(Options, HaveNamesOfTheirOwnAndWhatTheirKindNeeds) {
  std::set<std::string_view> names;
  for (const Option& one : options()) {
    EXPECT_TRUE(names.insert(one.name).second) << one.name;
    EXPECT_EQ(&option(one.name), &one);
    EXPECT_FALSE(one.group.empty() || one.description.empty()) << one.name;
    const bool worded = one.kind == OptionKind::word || one.kind == OptionKind::face;
    EXPECT_EQ(one.words.empty(), !worded) << one.name;
    const bool file = one.kind == OptionKind::file;
    EXPECT_EQ(one.file_kind.empty(), !file) << one.name;
    EXPECT_EQ(one.file_type.empty(), !file) << one.name;
    for (const std::string_view word : one.words) {
      Request request;
      EXPECT_TRUE(one.set(request, std::string(word))) << one.name << " " << word;
    }
  }
  EXPECT_FALSE(option("piece").on_command_line);
  EXPECT_TRUE(option("k").on_command_line);
}

TEST(Options, TakeTheirLimits) {
  const auto takes = [](const char* name, const char* text) {
    OptionValues values;
    return values.set_text(option(name), text).has_value();
  };
  for (const auto& [name, least, taken] : {std::tuple{"k", "0", true},
                                           {"rip_width", "0", true},
                                           {"arc_tolerance", "0", false},
                                           {"tick_length", "0", false},
                                           {"density", "0", false},
                                           {"largest_span", "0", false},
                                           {"inside_radius", "0", true},
                                           {"trade_off", "0", true},
                                           {"piece", "0", true}}) {
    EXPECT_EQ(takes(name, least), taken) << name;
    EXPECT_FALSE(takes(name, "-0.5")) << name;
    EXPECT_TRUE(takes(name, "1")) << name;
  }
  EXPECT_FALSE(takes("k", "1.01"));
  EXPECT_FALSE(takes("bend_k", "B1=1.01"));
}

}  // namespace
}  // namespace planish::job
