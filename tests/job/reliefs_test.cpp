#include "reliefs.hpp"

#include "support/sheet_builder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace planish::job {
namespace {

using std::numbers::pi;

constexpr double kThickness = 1.0, kRadius = 1.0, kWall = 10.0;
/// How far a wall reaches beyond its tangent line when it lies flat, at K = 0.44.
const double kReach = pi / 2 * (kRadius + 0.44 * kThickness) + kWall;

/// An L-shaped base with walls along both sides of its inner corner at (60, 60), which end
/// `overlap` too near to it: laid flat, they cover a square of that size twice.
Sheet inner_corner(double overlap) {
  const double back = kReach - overlap, end = 60 + back;
  test::SheetBuilder builder(kThickness);
  const FaceId base = builder.flange(
      Frame{},
      {test::polygon(
          {{0, 0}, {100, 0}, {100, 60}, {end, 60}, {60, 60}, {60, end}, {60, 100}, {0, 100}})});
  for (const int border : {2, 5}) {
    const test::Rim far = builder.bend(builder.rim(base, border),
                                       test::Turn{Angle::degrees(90), kRadius});
    builder.flange_behind(far, {test::rectangle(far.length, kWall)});
  }
  return builder.finish();
}

struct Laid {
  Sheet sheet;
  FlatSheet flat;
};
Laid laid(double overlap) {
  Sheet sheet = inner_corner(overlap);
  FlatSheet flat = flat_sheet(sheet).value();
  return {std::move(sheet), std::move(flat)};
}

Result<Relieved> relieved_of(const Laid& part, const ReliefOptions& options = {}) {
  const auto& [layout, pattern] = part.flat;
  return with_reliefs(part.sheet, layout, pattern, double_covers(part.sheet, layout, pattern),
                      options);
}

double whole(double overlap) {
  const double wall = 40 - kReach + overlap;
  return 100 * 100 - 40 * 40 + 2 * wall * kReach;
}

TEST(Reliefs, RipTheSmallestGap) {
  const Laid part = laid(0.5);
  ASSERT_NEAR(part.flat.pattern.area, whole(0.5), 1e-9);
  const auto relieved = relieved_of(part);
  ASSERT_TRUE(relieved) << relieved.error().message;
  // The place is 0.5 mm square; with the kerf of 0.2 mm each wall loses 0.6 mm by 0.6 mm.
  EXPECT_NEAR(relieved->removed, 2 * 0.36, 1e-2);
  EXPECT_NEAR(relieved->pattern.area, whole(0.5) - relieved->removed, 1e-9);
  ASSERT_EQ(relieved->findings.size(), 1u);
  EXPECT_EQ(relieved->findings.front().code, "mended_corner");
  EXPECT_EQ(relieved->findings.front().severity, Severity::warning);
  ASSERT_EQ(relieved->findings.front().at.size(), 1u);
}

TEST(Reliefs, AreAsWideAsTheSheetIsThickIfWanted) {
  const Laid part = laid(0.5);
  const auto relieved = relieved_of(part, {.shape = Relief::square});
  ASSERT_TRUE(relieved) << relieved.error().message;
  EXPECT_NEAR(relieved->removed, 2 * 0.75 * 0.75, 1e-2);
}

TEST(Reliefs, GiveRipsTheirWidth) {
  const Laid part = laid(0.5);
  const auto relieved = relieved_of(part, {.shape = Relief::rip, .width = 0.4});
  ASSERT_TRUE(relieved) << relieved.error().message;
  EXPECT_NEAR(relieved->removed, 2 * 0.7 * 0.7, 1e-2);
}

TEST(Reliefs, AreRefusedWhereFlangesCoverEachOther) {
  const Laid part = laid(2.5);
  const auto relieved = relieved_of(part);
  ASSERT_FALSE(relieved);
  EXPECT_EQ(relieved.error().code, ErrorCode::overlap);
}

TEST(Reliefs, LeaveASoundPatternAlone) {
  const Laid part = laid(-1.0);
  const auto relieved = relieved_of(part);
  ASSERT_TRUE(relieved) << relieved.error().message;
  EXPECT_EQ(relieved->removed, 0.0);
  EXPECT_TRUE(relieved->findings.empty());
}

}  // namespace
}  // namespace planish::job
