#include "job/option_meanings.hpp"
#include "option_tables.hpp"

#include <gtest/gtest.h>

namespace planish::job {
namespace {

TEST(CheckOptions, SetWhatTheyAreNamedFor) {
  const Rules laser = rules_for(Process::laser), punch = rules_for(Process::punch);
  ASSERT_NE(laser.opening_to_edge_t, punch.opening_to_edge_t);
  test::expect_meanings(
      {{"process", "laser",
        [&](auto& r) { return r.rules.opening_to_edge_t == laser.opening_to_edge_t; }},
       {"process", "punch",
        [&](auto& r) { return r.rules.opening_to_edge_t == punch.opening_to_edge_t; }},
       {"no_rules", "true", [](auto& r) { return !r.rules.enabled; }},
       {"no_rules", "false", [](auto& r) { return r.rules.enabled; }},
       {"write_overlapping", "true", [](auto& r) { return r.write_overlapping; }},
       {"write_anyway", "true", [](auto& r) { return r.write_anyway; }},
       {"density", "7.85", [](auto& r) { return r.density == 7.85; }}});
}

TEST(CheckOptions, ReadTheContentOfFiles) {
  Request request;
  EXPECT_FALSE(option("rules").set(request, OptionFile{"rules.json", "{"}));
  ASSERT_TRUE(option("rules").set(request, OptionFile{"rules.json", R"({"k_low": 0.15})"}));
  EXPECT_EQ(request.rules.k_low, 0.15);
  EXPECT_FALSE(option("shop").set(request, OptionFile{"shop.json", "{}"}));
}

}  // namespace
}  // namespace planish::job
