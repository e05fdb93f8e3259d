#include "support/sample_strokes.hpp"

#include <planish/brake/bend_numbers.hpp>

#include <gtest/gtest.h>

namespace planish::test {
namespace {

FlatBend flat_bend(int number, std::vector<Segment> lines) {
  FlatBend bend;
  bend.bend = BendId{number};
  bend.lines = std::move(lines);
  return bend;
}

Plan plan_of(std::vector<Stroke> strokes) {
  Plan plan;
  plan.status = PlanStatus::optimal;
  plan.strokes = std::move(strokes);
  return plan;
}

TEST(BendNumbers, AreThoseOfTheFirstStrokeThatPressesThem) {
  FlatPattern flat;
  for (int i = 0; i < 3; ++i)
    flat.bends.push_back(flat_bend(i, {{{20, 0}, {20, 60}}}));
  number_bends(flat, plan_of({stroke_at_20(), stroke_at_40(), stroke_at_20()}));
  EXPECT_EQ(flat.bends[0].stroke, 2);
  EXPECT_EQ(flat.bends[1].stroke, 1);
  EXPECT_FALSE(flat.bends[2].stroke);
}

/// Three bumps of 10°, 4 mm apart, about the bend line at x = 20, which an opening interrupts.
TEST(BendNumbers, DrawALineForEachBump) {
  const std::vector<Segment> drawn{{{20, 0}, {20, 25}}, {{20, 40}, {20, 60}}};
  for (const Forming forming : {Forming::bumps, Forming::rolled}) {
    FlatPattern flat;
    flat.bends = {flat_bend(0, drawn), flat_bend(1, drawn)};
    Plan plan = plan_of({stroke_at_40()});
    plan.large = {{.bend = BendId{1},
                   .forming = forming,
                   .bumps = 3,
                   .pitch = 4.0,
                   .angle = Angle::degrees(10)}};
    number_bends(flat, plan);
    EXPECT_EQ(flat.bends[0].lines.size(), 2u);
    if (forming == Forming::rolled) {
      EXPECT_EQ(flat.bends[1].lines.size(), 2u);
      continue;
    }
    ASSERT_EQ(flat.bends[1].lines.size(), 6u);
    std::vector<double> places;
    for (std::size_t i = 0; i < 6; ++i) {
      const Segment& line = flat.bends[1].lines[i];
      places.push_back(line.a.x());
      EXPECT_EQ(line.a.x(), line.b.x());
      EXPECT_EQ(line.b.y() - line.a.y(), drawn[i % 2].b.y() - drawn[i % 2].a.y());
      EXPECT_DOUBLE_EQ(flat.bends[1].line_angles.at(i).degrees(), 10.0);
    }
    std::ranges::sort(places);
    EXPECT_EQ(places, (std::vector<double>{16, 16, 20, 20, 24, 24}));
  }
}

}  // namespace
}  // namespace planish::test
