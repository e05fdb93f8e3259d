#include "cutting.hpp"

#include "brake/stroke_room.hpp"

#include <gtest/gtest.h>

#include <algorithm>
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

/// Beyond ten thicknesses a bend is rolled: no line, and it stays flat.
TEST(Cutting, LeavesRolledBendsFlat) {
  for (const double step : {-0.1, 0.1}) {
    const Sheet sheet = strip(
        {Straight{60}, Turn{Angle::degrees(90), 15.0 + step, BendDirection::up}, Straight{60}}, 40,
        1.5);
    const auto work = work_to_cut(sheet);
    ASSERT_TRUE(work);
    EXPECT_EQ(work->lines.size(), step < 0.0 ? 1u : 0u);
    EXPECT_EQ(work->rolled.size(), step < 0.0 ? 0u : 1u);
    EXPECT_EQ(work->bodies.size(), step < 0.0 ? 2u : 1u);
  }
}

/// Two flaps on one edge are two lines; a flange bent at the same edge by two bends, which a gap
/// parts, is one.
Sheet flange_on_two_bends(double second_angle) {
  SheetBuilder builder(1.0);
  const FaceId base = builder.flange(
      Frame{},
      {polygon({{0, 0}, {40, 0}, {40, 2}, {60, 2}, {60, 0}, {100, 0}, {100, 80}, {0, 80}})});
  const Rim first = builder.bend(builder.rim(base, 0),
                                 {Angle::degrees(90), 1.0, BendDirection::up});
  const Rim second = builder.bend(builder.rim(base, 4),
                                  {Angle::degrees(second_angle), 1.0, BendDirection::up});
  builder.flange_behind(first, {rectangle(first.length, 30)});
  builder.flange_behind(second, {rectangle(second.length, 30)});
  return builder.finish();
}

TEST(Cutting, KeepsFlapsOnOneEdgeApart) {
  const auto work = work_to_cut(flange_on_two_bends(90));
  ASSERT_TRUE(work);
  EXPECT_EQ(work->lines.size(), 2u);
  EXPECT_EQ(work->bodies.size(), 3u);
  for (const BrakeLine& line : work->lines)
    EXPECT_NEAR(line.length(), 40.0, 1e-9);
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
