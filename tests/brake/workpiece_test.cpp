#include "workpiece.hpp"

#include "brake/stroke_room.hpp"

#include <planish/geometry/plane.hpp>

#include <gtest/gtest.h>

#include <algorithm>

namespace planish::test {
namespace {

using namespace brake_detail;

Workpiece work_of(const Sheet& sheet, const WorkpieceOptions& options = {}) {
  const auto flat = flat_sheet(sheet);
  auto work = workpiece_of(sheet, flat->layout, options);
  EXPECT_TRUE(work) << work.error().message;
  return std::move(*work);
}

Vec2 middle_of(const Body& body) {
  Vec2 sum = Vec2::Zero();
  double area = 0.0;
  for (const Convex& piece : body.pieces) {
    Vec2 middle = Vec2::Zero();
    for (const Vec2& p : piece)
      middle += p / static_cast<double>(piece.size());
    sum += ring_area(piece) * middle;
    area += ring_area(piece);
  }
  return sum / area;
}

/// Lines have the length of their bends, BA = α (r + K T), and bodies where they say.
TEST(Workpiece, HasALineInTheMiddleOfEachBend) {
  for (const Sheet& sheet : {l_bracket(), u_channel(), z_profile(), staircase(2), box()}) {
    const Workpiece work = work_of(sheet);
    EXPECT_EQ(work.lines.size(), sheet.bends.size());
    EXPECT_EQ(work.bodies.size(), sheet.bends.size() + 1);
    for (const BrakeLine& line : work.lines) {
      const Bend& bend = sheet[line.bends.front()];
      EXPECT_NEAR(line.angle.radians(), bend.angle.radians(), 1e-12);
      EXPECT_NEAR(line.bend.allowance,
                  bend.angle.radians() * (bend.inside_radius + line.bend.neutral), 1e-9);
      EXPECT_NEAR(line.length(), line.to() - line.from(), 1e-9);
      EXPECT_NEAR(line.along.norm(), 1.0, 1e-12);
      EXPECT_EQ(line.reference_up, bend.reference_inside);
      EXPECT_TRUE(line.given_radius);
      for (const int side : {0, 1}) {
        const Vec2 to = middle_of(work.bodies[line.bodies[side]]) - line.origin;
        EXPECT_EQ(cross(line.along, to) > 0.0, side == 1);
        EXPECT_TRUE(touches(line, line.bodies[side]));
      }
    }
  }
}

/// From a body without crossing a line: one end of the strip, or the other.
TEST(Workpiece, FallsApartAtALine) {
  const Workpiece work = work_of(staircase(2));
  for (int line = 0; line < std::ssize(work.lines); ++line) {
    const auto right = reached_from(work, work.lines[line].bodies[0], line);
    const auto left = reached_from(work, work.lines[line].bodies[1], line);
    for (std::size_t body = 0; body < work.bodies.size(); ++body) {
      EXPECT_NE(right[body], left[body]);
      const Vec2 to = middle_of(work.bodies[body]) - work.lines[line].origin;
      EXPECT_EQ(left[body], cross(work.lines[line].along, to) > 0.0);
    }
    int touching = 0;
    for (int body = 0; body < std::ssize(work.bodies); ++body)
      touching += touches(work.lines[line], body) ? 1 : 0;
    EXPECT_EQ(touching, 2);
  }
}

/// A hem is bent as far as tools go and closed in a line of its own, at the same place.
TEST(Workpiece, HasTwoLinesForAHem) {
  const Workpiece plain = work_of(hem());
  ASSERT_EQ(plain.lines.size(), 1u);
  EXPECT_FALSE(plain.lines[0].closes || plain.lines[0].closed_by);
  const Workpiece work = work_of(hem(), {1.0, Angle::degrees(150)});
  ASSERT_EQ(work.lines.size(), 2u);
  EXPECT_EQ(work.lines[0].closed_by, std::optional<int>(1));
  EXPECT_EQ(work.lines[1].closes, std::optional<int>(0));
  EXPECT_FALSE(work.lines[1].closed_by);
  for (const BrakeLine& line : work.lines) {
    EXPECT_NEAR(line.angle.degrees(), 150.0, 1e-9);
    EXPECT_NEAR(line.closed.degrees(), 180.0, 1e-9);
    // Open, the same allowance has a wider radius: BA/θ − K T.
    EXPECT_NEAR(line.inside_radius, 180.0 / 150.0 * (0.5 + line.bend.neutral) - line.bend.neutral,
                1e-9);
  }
  EXPECT_TRUE(is_same(work, 0, 1));
  EXPECT_TRUE(is_same(work, 1, 0));
  EXPECT_EQ(work.zones.size(), 2u);
}

TEST(Workpiece, IsAHemFrom170To225Degrees) {
  EXPECT_FALSE(is_hem(Angle::degrees(169)));
  EXPECT_TRUE(is_hem(Angle::degrees(171)));
  EXPECT_TRUE(is_hem(Angle::degrees(224)));
  EXPECT_FALSE(is_hem(Angle::degrees(226)));
}

}  // namespace
}  // namespace planish::test
