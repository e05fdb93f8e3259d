#include "cutting.hpp"

#include "brake/stroke_room.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace planish::test {
namespace {

using namespace brake_detail;

Result<Workpiece> work_to_cut(const Sheet& sheet, const WorkpieceOptions& options = {}) {
  return workpiece_of(sheet, flat_sheet(sheet)->layout, options);
}

/// A fold drawn without a radius takes that of the V, and its allowance with it.
TEST(Cutting, GivesASharpFoldTheRadiusOfTheV) {
  const Sheet sheet = strip(
      {Straight{30}, Crease{Angle::degrees(90), BendDirection::up}, Straight{20}}, 40, 1.5);
  const auto work = work_to_cut(sheet, {2.4, {}});
  ASSERT_TRUE(work) << work.error().message;
  ASSERT_EQ(work->lines.size(), 1u);
  const BrakeLine& line = work->lines.front();
  EXPECT_FALSE(line.given_radius);
  EXPECT_EQ(line.inside_radius, 2.4);
  EXPECT_NEAR(line.bend.allowance, std::numbers::pi / 2 * (2.4 + line.bend.neutral), 1e-9);
  EXPECT_NEAR(line.length(), 40.0, 1e-9);
  EXPECT_EQ(work->bodies.size(), 2u);
}

/// A bend that is rolled has no line, and stays flat; bumps are lines at the middles of equal
/// shares of its zone.
TEST(Cutting, CutsALargeBendAsItIsFormed) {
  const Sheet sheet = strip(
      {Straight{60}, Turn{Angle::degrees(90), 30.0, BendDirection::up}, Straight{60}}, 40, 1.5);
  const BendId bend = sheet.bends.ids().front();
  WorkpieceOptions options;
  options.large = {{bend, Forming::rolled}};
  const auto rolled = work_to_cut(sheet, options);
  ASSERT_TRUE(rolled);
  EXPECT_TRUE(rolled->lines.empty());
  EXPECT_EQ(rolled->bodies.size(), 1u);
  const double allowance = std::numbers::pi / 2.0 * (30.0 + 0.44 * 1.5);
  options.large = {{bend, Forming::bumps, 3, allowance / 3.0, Angle::degrees(30)}};
  const auto bumped = work_to_cut(sheet, options);
  ASSERT_TRUE(bumped);
  ASSERT_EQ(bumped->lines.size(), 3u);
  EXPECT_EQ(bumped->bodies.size(), 4u);
  const BrakeLine& first = bumped->lines[0];
  for (int i = 0; i < 3; ++i) {
    const BrakeLine& line = bumped->lines[i];
    EXPECT_NEAR(line.angle.degrees(), 30.0, 1e-9);
    EXPECT_EQ(line.press_line, i);
    EXPECT_EQ(line.drawn_radius, 30.0);
    EXPECT_NEAR(std::abs(first.across().dot(line.origin - first.origin)), i * allowance / 3.0,
                1e-6);
  }
}

/// Two flaps on one edge are two lines; a flange bent at the same edge by two bends, which a gap
/// parts, is one.
TEST(Cutting, KeepsFlapsOnOneEdgeApart) {
  const auto work = work_to_cut(two_flaps());
  ASSERT_TRUE(work);
  EXPECT_EQ(work->lines.size(), 2u);
  EXPECT_EQ(work->bodies.size(), 3u);
  for (const BrakeLine& line : work->lines)
    EXPECT_NEAR(line.length(), 40.0, 1e-9);
}

double area_of_piece(const Convex& piece) {
  double twice = 0.0;
  for (size_t i = 0; i < piece.size(); ++i) {
    const Vec2 &a = piece[i], &b = piece[(i + 1) % piece.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * std::abs(twice);
}

/// One bend across a slot, drawn as two bends, one on each side of it.
Sheet bend_drawn_as_two(double slot) {
  Sheet sheet = slot_across_bend(slot);
  Bend second = sheet.bends.front();
  second.faces = {sheet.bends.front().faces.back()};
  sheet.bends.front().faces.pop_back();
  const auto id = static_cast<BendId>(sheet.bends.size());
  sheet.faces[second.faces.front()].part_of = id;
  sheet.bends.push_back(second);
  return sheet;
}

TEST(Cutting, MakesOneLineOfBendsThatGoOn) {
  const Opened part;
  for (const double slot : {6.0, 20.0}) {
    const Sheet sheet = bend_drawn_as_two(slot);
    ASSERT_TRUE(check(sheet));
    const auto work = work_to_cut(sheet);
    ASSERT_TRUE(work) << work.error().message;
    ASSERT_EQ(work->lines.size(), 1u);
    EXPECT_EQ(work->bodies.size(), 2u);
    const BrakeLine& line = work->lines.front();
    EXPECT_EQ(line.bends, (std::vector<BendId>{BendId(0), BendId(1)}));
    ASSERT_EQ(line.pieces.size(), 2u);
    const double one = 0.5 * (part.width - slot);
    for (const Interval& piece : line.pieces)
      EXPECT_NEAR(piece.size(), one, 1e-6);
    EXPECT_NEAR(line.pieces[1].lo - line.pieces[0].hi, slot, 1e-6);
    EXPECT_NEAR(line.length(), 2 * one, 1e-6);
    // Their zone is the material of both, the bodies the rest of the pattern.
    double zone = 0.0;
    for (const Convex& piece : work->zones.front().pieces)
      zone += area_of_piece(piece);
    EXPECT_NEAR(zone, 2 * one * line.bend.allowance, 1e-6);
  }
}

/// Bends that do not go on in each other, but join the same flanges, are a loop that no stroke can
/// press.
TEST(Cutting, RefusesBendsOfALoopThatAreNotOneLine) {
  Sheet sheet = bend_drawn_as_two(12);
  sheet.bends.back().reference_inside = !sheet.bends.back().reference_inside;
  const auto flat = flat_sheet(bend_drawn_as_two(12));
  ASSERT_TRUE(flat);
  const auto work = workpiece_of(sheet, flat->layout, {});
  ASSERT_FALSE(work);
  EXPECT_EQ(work.error().where, "B2");
}

/// Which side is up: the inside faces the viewer of the pattern or not, whichever way it is laid.
TEST(Cutting, TellsWhichWayLinesAreBent) {
  for (const UpSide side : {UpSide::reference, UpSide::other}) {
    FlattenOptions options;
    options.up = side;
    for (const bool down : {false, true}) {
      const Sheet sheet = down ? l_bracket_down() : l_bracket();
      const auto flat = flat_sheet(sheet, options);
      const auto work = workpiece_of(sheet, flat->layout);
      ASSERT_TRUE(work);
      const BrakeLine& line = work->lines.front();
      EXPECT_EQ(line.reference_up, !down);
      EXPECT_EQ(line.up, !down == (side == UpSide::reference));
    }
  }
}

}  // namespace
}  // namespace planish::test
