#include "tool_room.hpp"

#include "brake/stroke_room.hpp"

#include <gtest/gtest.h>

namespace planish::test {
namespace {

using namespace brake_detail;

BrakeTools two_punches() {
  BrakeTools tools = plain_tools();
  Punch neck = punch();
  neck.id = "G";
  neck.profile = {{0, 0},    {5, 5.96},  {5, 25},   {-12, 45}, {-12, 80}, {14, 100},
                  {14, 150}, {-45, 150}, {-45, 40}, {-8, 18},  {-8, 9.53}};
  tools.punches.push_back(neck);
  tools.machine.upper_beam = {{-30, 150}, {40, 150}, {40, 400}, {-30, 400}};
  tools.machine.lower_beam = {{-45, -300}, {45, -300}, {45, -100}, {-45, -100}};
  return tools;
}

/// A key stands for one shape: the same for the same question, and for no other.
TEST(ToolRoom, GivesEachShapeAKeyOfItsOwn) {
  const BrakeTools tools = two_punches();
  ToolRoom room(tools, 1.0);
  std::map<int, std::pair<const Obstacle*, const Obstacle*>> by_key;
  for (int again = 0; again < 2; ++again)
    for (const ToolKind kind : kToolKinds)
      for (const int tool : {0, 1})
        for (const Nearness nearness : {Nearness::touching, Nearness::clear})
          for (const int direction : {1, -1}) {
            if (tool == 1 && (kind == ToolKind::die || kind == ToolKind::lower_beam)) continue;
            const SidedObstacle seen = room.obstacle(kind, tool, nearness, direction);
            const auto [known, added] = by_key.try_emplace(seen.key,
                                                           std::pair(seen.left, seen.right));
            EXPECT_EQ(known->second, std::pair(seen.left, seen.right));
            EXPECT_EQ(seen.left->moves, kind == ToolKind::die || kind == ToolKind::lower_beam);
          }
}

/// With the gauge on the other side everything is seen in a mirror, unless it is its own.
TEST(ToolRoom, TurnsToolsWithTheGauge) {
  const BrakeTools tools = two_punches();
  ToolRoom room(tools, 0.0);
  for (const int tool : {0, 1}) {
    const auto left = room.obstacle(ToolKind::punch, tool, Nearness::clear, 1);
    const auto right = room.obstacle(ToolKind::punch, tool, Nearness::clear, -1);
    EXPECT_EQ(left.key == right.key, tool == 0);
    EXPECT_EQ(left.left, right.right);
    EXPECT_EQ(left.right, right.left);
    EXPECT_NEAR(left.left->box.lo.x(), -left.right->box.hi.x(), 1e-9);
  }
  const auto neck = room.obstacle(ToolKind::punch, 1, Nearness::clear, 1);
  EXPECT_NEAR(neck.left->box.lo.x(), -45.0 + 0.05, 1e-6);
  EXPECT_NEAR(neck.left->box.hi.x(), 14.0 - 0.05, 1e-6);
}

/// What is kept away from: the whole tool with a clearance, else what is deeper than may be
/// penetrated. Beams keep their clearance from everything.
TEST(ToolRoom, KeepsTheClearanceFromWhatDoesNotTouch) {
  const BrakeTools tools = two_punches();
  ToolRoom room(tools, 2.0), none(tools, 0.0);
  EXPECT_EQ(room.obstacle(ToolKind::punch, 0, Nearness::clear, 1).left->keep, 2.0);
  EXPECT_EQ(room.obstacle(ToolKind::die, 0, Nearness::clear, 1).left->keep, 2.0);
  EXPECT_EQ(room.obstacle(ToolKind::die, 0, Nearness::touching, 1).left->keep, 0.0);
  for (const double keep : room.obstacle(ToolKind::punch, 0, Nearness::touching, 1).left->keeps)
    EXPECT_EQ(keep, 0.0);
  // What of a goose neck stands out beyond its tip keeps its clearance even from what is bent.
  EXPECT_EQ(room.obstacle(ToolKind::punch, 1, Nearness::touching, 1).left->keeps.back(), 2.0);
  for (const ToolKind beam : {ToolKind::upper_beam, ToolKind::lower_beam})
    for (const Nearness nearness : {Nearness::touching, Nearness::clear}) {
      EXPECT_EQ(room.obstacle(beam, 0, nearness, 1).left->keep, 2.0);
      EXPECT_EQ(none.obstacle(beam, 0, nearness, 1).left->keep, 0.0);
    }
}

/// The tool itself, without what touches it while it bends.
TEST(ToolRoom, HasBodiesOfTools) {
  const BrakeTools tools = two_punches();
  ToolRoom room(tools, 0.0);
  EXPECT_TRUE(room.body(ToolKind::die, 0, Nearness::touching, 1).left->pieces.empty());
  EXPECT_FALSE(room.body(ToolKind::die, 0, Nearness::clear, 1).left->pieces.empty());
  EXPECT_TRUE(room.body(ToolKind::punch, 0, Nearness::touching, 1).left->pieces.empty());
  EXPECT_FALSE(room.body(ToolKind::punch, 1, Nearness::touching, 1).left->pieces.empty());
  EXPECT_NEAR(room.body(ToolKind::punch, 0, Nearness::clear, 1).left->box.hi.x(), 10.0, 1e-9);
}

/// The upper beam comes down with the rounded tip; what is deeper in a tool is smaller.
TEST(ToolRoom, ShrinksToolsToWhatIsDeeper) {
  const BrakeTools tools = two_punches();
  ToolRoom room(tools, 0.0);
  const Obstacle& beam = room.deeper(ToolKind::upper_beam, 0, 3.0);
  EXPECT_NEAR(beam.box.lo.y(), 150.0 - lowered(tools.punches[0]) + 3.0, 1e-6);
  EXPECT_NEAR(beam.box.hi.x(), 37.0, 1e-6);
  EXPECT_FALSE(beam.moves);
  const Obstacle& lower = room.deeper(ToolKind::lower_beam, 0, 3.0);
  EXPECT_NEAR(lower.box.hi.y(), -103.0, 1e-6);
  EXPECT_TRUE(lower.moves);
  EXPECT_EQ(&room.deeper(ToolKind::upper_beam, 0, 3.0), &beam);
  EXPECT_NE(&room.deeper(ToolKind::upper_beam, 0, 2.0), &beam);
}

TEST(ToolRoom, NamesTools) {
  const BrakeTools tools = two_punches();
  const ToolRoom room(tools, 0.0);
  EXPECT_EQ(text_of(room.name(ToolKind::punch, 1)), "punch G");
  EXPECT_EQ(text_of(room.name(ToolKind::die, 0)), "die D");
  EXPECT_EQ(text_of(room.name(ToolKind::upper_beam, 0)), "upper beam");
  EXPECT_EQ(text_of(room.name(ToolKind::lower_beam, 0)), "lower beam");
}

}  // namespace
}  // namespace planish::test
