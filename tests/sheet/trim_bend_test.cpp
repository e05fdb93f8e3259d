#include "trim_bend.hpp"

#include <gtest/gtest.h>

namespace planish::test {
namespace {

TEST(TrimBend, LeavesPartsOfLinesWithTheAngleOfTheLineTheyAreOf) {
  FlatBend bend;
  bend.angle = Angle::degrees(90);
  bend.lines = {{{0, 0}, {10, 0}}, {{0, 1}, {10, 1}}, {{0, 2}, {20, 2}}};
  bend.line_angles = {Angle::degrees(20), Angle::degrees(30), Angle::degrees(40)};
  bend.tangent_lines = {{{0, -1}, {10, -1}}, {{0, 3}, {10, 3}}};
  bend.length = 13.0;
  // Nothing of the first; both ends of the others, a quarter each.
  sheet_detail::trim_bend(bend, [](const Segment& line) -> std::vector<Segment> {
    if (line.a.y() == 0.0 || line.a.y() == -1.0) return {};
    const Vec2 quarter = 0.25 * (line.b - line.a);
    return {{line.a, line.a + quarter}, {line.b - quarter, line.b}};
  });
  ASSERT_EQ(bend.lines.size(), 4u);
  ASSERT_EQ(bend.line_angles.size(), 4u);
  EXPECT_EQ(bend.lines[0].b, Vec2(2.5, 1));
  EXPECT_EQ(bend.lines[1].a, Vec2(7.5, 1));
  EXPECT_EQ(bend.lines[3].a, Vec2(15, 2));
  for (const int i : {0, 1})
    EXPECT_NEAR(bend.line_angles[i].degrees(), 30, 1e-12);
  for (const int i : {2, 3})
    EXPECT_NEAR(bend.line_angles[i].degrees(), 40, 1e-12);
  ASSERT_EQ(bend.tangent_lines.size(), 2u);
  EXPECT_EQ(bend.tangent_lines[1].a, Vec2(7.5, 3));
  // 15 of 40 mm are left.
  EXPECT_NEAR(bend.length, 13.0 * 15 / 40, 1e-12);
}

TEST(TrimBend, WithoutLinesKeepsItsLengthAndWithoutAnglesTakesTheBends) {
  FlatBend bend;
  bend.angle = Angle::degrees(90);
  bend.length = 5.0;
  const auto all = [](const Segment& line) { return std::vector<Segment>{line}; };
  sheet_detail::trim_bend(bend, all);
  EXPECT_EQ(bend.length, 5.0);
  bend.lines = {{{0, 0}, {10, 0}}};
  sheet_detail::trim_bend(bend, all);
  ASSERT_EQ(bend.line_angles.size(), 1u);
  EXPECT_NEAR(bend.line_angles[0].degrees(), 90, 1e-12);
}

}  // namespace
}  // namespace planish::test
