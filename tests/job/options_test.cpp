#include "job/option_meanings.hpp"

#include <gtest/gtest.h>

#include <set>

namespace planish::job {
namespace {

TEST(Options, SetWhatTheyAreNamedFor) {
  test::expect_meanings({{"body", "door", [](auto& r) { return r.body == "door"; }},
                         {"units", "inch", [](auto& r) { return r.units == LengthUnit::inch; }},
                         {"units", "m", [](auto& r) { return r.units == LengthUnit::m; }},
                         {"units", "mm", [](auto& r) { return r.units == LengthUnit::mm; }},
                         {"piece", "3", [](auto& r) { return r.piece == 3; }}});
}

TEST(Options, HaveNamesOfTheirOwnAndWhatTheirKindNeeds) {
  std::set<std::string_view> names;
  for (const Option& one : options()) {
    EXPECT_TRUE(names.insert(one.name).second) << one.name;
    EXPECT_EQ(&option(one.name), &one);
    EXPECT_NE(one.group, OptionGroup::none) << one.name;
    EXPECT_FALSE(heading(one.group).empty() || one.description.empty()) << one.name;
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
