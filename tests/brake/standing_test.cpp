#include "standing.hpp"

#include "brake/stroke_room.hpp"
#include "one_line.hpp"
#include "plane_side.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace planish::test {
namespace {

using namespace brake_detail;

BrakeTools tools_with_beam() {
  BrakeTools tools = plain_tools();
  tools.punches.push_back(punch({Angle::degrees(60), 16.0}));
  tools.punches.push_back(punch({Angle::degrees(60), 4.0}));
  tools.punches.back().ears = Ears{40.0, 50.0, 20.0, 30.0};
  tools.machine.upper_beam = {{-30, 150}, {30, 150}, {30, 400}, {-30, 400}};
  return tools;
}

std::vector<Sheet> sheets() {
  return {lipped_base(15.0), box({70.0, 45.0, 30.0}), box({60.0, 60.0, 55.0}), staircase(2),
          strip({Straight{12},
                 {Turn{Angle::degrees(90), 2.0, BendDirection::up}},
                 Straight{45},
                 Turn{Angle::degrees(90), 2.0, BendDirection::up},
                 Straight{50},
                 Turn{Angle::degrees(90), 2.0, BendDirection::up},
                 Straight{45}},
                80, 1.5)};
}

void for_each_choice(Room& room, auto&& look) {
  for (std::uint64_t stage = 0; stage + 1 < std::uint64_t{1} << room.inputs().lines(); ++stage) {
    const LineSet formed{stage};
    for (const StrokeChoice& choice : choices(room.cache(), formed))
      look(formed, choice, setting(room.inputs(), formed, choice));
  }
}

/// A refusal names one of all collisions; without any, only segments can be missing.
TEST(Standing, RefusesExactlyWhatCollides) {
  int collide = 0, stand = 0;
  for (const Sheet& sheet : sheets()) {
    Room room(sheet, tools_with_beam());
    for_each_choice(room, [&](const LineSet&, const StrokeChoice&, const Setting& at) {
      const Standing rows = standing(room.cache(), at);
      const std::vector<Obstruction> all = collisions(room.cache(), at);
      if (rows) {
        ++stand;
        EXPECT_TRUE(all.empty());
      } else if (rows.error().part >= 0) {
        ++collide;
        EXPECT_TRUE(std::ranges::any_of(all, [&](const Obstruction& one) {
          return one.part == rows.error().part && one.tool == rows.error().tool &&
                 one.because == rows.error().because;
        }));
      } else {
        EXPECT_TRUE(all.empty());
        EXPECT_TRUE(rows.error().lack.kind == Lack::Kind::segments ||
                    rows.error().lack.kind == Lack::Kind::no_room);
      }
    });
  }
  EXPECT_GT(collide, 20);
  EXPECT_GT(stand, 100);
}

/// What is blamed decides: in every stage in which those lines are formed or not as in this one,
/// the choice is infeasible too.
TEST(Standing, BlamesLinesThatDecide) {
  int refused = 0;
  for (const Sheet& sheet : sheets()) {
    Room room(sheet, tools_with_beam());
    std::map<std::tuple<LineSet, int, int, int>, std::map<LineSet, StrokeVerdict>> verdicts;
    for_each_choice(room, [&](const LineSet& formed, const StrokeChoice& choice, const Setting&) {
      verdicts[{choice.lines, choice.punch, choice.die, choice.direction}][formed] = check(
          room.cache(), formed, choice);
    });
    for (const auto& [way, by_stage] : verdicts)
      for (const auto& [stage, verdict] : by_stage) {
        if (verdict.feasible) continue;
        ASSERT_TRUE(verdict.because);
        ++refused;
        for (const auto& [other, told] : by_stage)
          if (common(stage, *verdict.because) == common(other, *verdict.because)) {
            EXPECT_FALSE(told.feasible);
          }
      }
  }
  EXPECT_GT(refused, 40);
}

/// Rows are made of segments that the tool has, each once, and press all of the line but a
/// shortfall at each end.
TEST(Standing, PressesTheWholeLine) {
  Room room(box(), tools_with_beam());
  for_each_choice(room, [&](const LineSet&, const StrokeChoice&, const Setting& at) {
    const Standing rows = standing(room.cache(), at);
    if (!rows) return;
    const auto pieces = pressed_pieces(room.cache(), at);
    const double left_out = shortfall(room.inputs()) + 1e-3;
    for (const auto* row : {&rows->punch, &rows->die}) {
      ASSERT_EQ(row->size(), 1u);
      EXPECT_LE(row->front().from, pieces.front().lo + left_out);
      EXPECT_GE(row->front().from + row->front().length(), pieces.back().hi - left_out);
      std::vector<double> left = room.tools().punches.front().segments;
      if (row->front().ears.lo > 0.0) left.push_back(row->front().ears.lo);
      if (row->front().ears.hi > 0.0) left.push_back(row->front().ears.hi);
      for (const double segment : row->front().segments) {
        const auto found = std::ranges::find(left, segment);
        ASSERT_NE(found, left.end());
        left.erase(found);
      }
    }
    const PressRows wanted = rows_without_walls(room.cache(), at);
    EXPECT_FALSE(wanted.punch.empty() || wanted.die.empty());
  });
}

/// Sides that are bent may touch punch and die, what is bent up already may not; beams nothing may.
TEST(Standing, LetsOnlyWhatIsBentTouchTheTools) {
  Room room(u_channel(), tools_with_beam());
  const LineSet formed = room.lines({1});
  const Setting at{&formed, room.lines({2}), room.line_of(2)};
  const PartTree& tree = room.cache().tree(at.line);
  for (int part = 0; part < std::ssize(tree.parts()); ++part) {
    const auto& known = tree.parts()[part];
    const bool hangs = known.over == room.line_of(1) && !disjoint(known.path, formed);
    EXPECT_EQ(nearness(room.cache(), at, part, ToolKind::punch),
              hangs ? Nearness::clear : Nearness::touching);
    // The formed bend at the end of the side lies on the die.
    EXPECT_EQ(nearness(room.cache(), at, part, ToolKind::die),
              hangs && !known.is_zone ? Nearness::clear : Nearness::touching);
    EXPECT_EQ(nearness(room.cache(), at, part, ToolKind::upper_beam), Nearness::clear);
    EXPECT_EQ(nearness(room.cache(), at, part, ToolKind::lower_beam), Nearness::clear);
  }
}

}  // namespace
}  // namespace planish::test
