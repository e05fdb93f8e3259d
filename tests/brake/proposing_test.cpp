#include "proposing.hpp"

#include "brake/stroke_room.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace planish::test {
namespace {

using namespace brake_detail;

const Turn kUp{Angle::degrees(90), 2.0, BendDirection::up};

struct Example {
  Sheet sheet = strip({Straight{40}, kUp, Straight{60}}, 80, 1.5);
  FlatSheet flat = *flat_sheet(sheet);
  Plan plan = {};
  PlanOptions options = {};
};

/// Of punches that differ in their tips alone one is tried; those of another shape or with ears
/// are.
TEST(Proposing, TriesOnePunchOfAShape) {
  Example example;
  BrakeTools tools = plain_tools({.tip_radius = 0.8});
  const auto add = [&](const char* id, const Punch& punch) {
    tools.punches.push_back(punch);
    tools.punches.back().id = id;
  };
  add("rounder", punch({.tip_radius = 1.0}));
  add("thin", punch({.half_width = 5.0}));
  add("eared", punch({}));
  tools.punches.back().ears = Ears{50.0, 50.0, 25.0, 20.0};
  const Trying trying(example.sheet, example.flat.layout, tools, example.options, example.plan, {},
                      {});
  EXPECT_EQ(trying.all_tools().punches.size(), 4u);
  ASSERT_EQ(trying.tools().punches.size(), 3u);
  for (const Punch& punch : trying.tools().punches)
    EXPECT_NE(punch.id, "rounder");
}

/// Nothing is tried without a share of the work, and what is left of one goes to the next.
TEST(Proposing, TriesWithinItsShare) {
  Example example;
  const BrakeTools tools = plain_tools();
  Trying trying(example.sheet, example.flat.layout, tools, example.options, example.plan,
                {.checks = 300}, {});
  EXPECT_FALSE(trying.can_bend(tools));
  trying.share_out(1, 3);
  EXPECT_TRUE(trying.can_bend(tools));
  for (int i = 0; i < 300; ++i)
    trying.can_bend(tools);
  EXPECT_FALSE(trying.can_bend(tools));
  trying.share_out(2, 2);
  EXPECT_TRUE(trying.can_bend(tools));
}

}  // namespace
}  // namespace planish::test
