#include "reliefs.hpp"

#include "support/sheet_builder.hpp"

#include <planish/sheet/codes.hpp>
#include <planish/sheet/one_piece.hpp>

#include <gtest/gtest.h>

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
                      options, {});
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

/// A base with a notch, from whose sides two walls rise that cover each other by `overlap` when
/// they lie flat, along 80 mm.
Laid facing_walls(double overlap) {
  const double from = 60, to = from + 2 * kReach - overlap;
  test::SheetBuilder builder(kThickness);
  const FaceId base = builder.flange(
      Frame{},
      {test::polygon(
          {{0, 0}, {200, 0}, {200, 100}, {to, 100}, {to, 20}, {from, 20}, {from, 100}, {0, 100}})});
  for (const int border : {3, 5}) {
    const test::Rim far = builder.bend(builder.rim(base, border),
                                       test::Turn{Angle::degrees(90), kRadius});
    builder.flange_behind(far, {test::rectangle(far.length, kWall)});
  }
  Sheet sheet = builder.finish();
  FlatSheet flat = flat_sheet(sheet).value();
  return {std::move(sheet), std::move(flat)};
}

TEST(Reliefs, TakeWhatTheLaserTakesHoweverLong) {
  const auto relieved = relieved_of(facing_walls(0.1));
  ASSERT_TRUE(relieved) << relieved.error().message;
  // A cut of 0.3 mm: 0.2 mm of each wall, and 0.1 mm into the bottom of the notch. What touches
  // within 0.001 T is no overlap.
  EXPECT_NEAR(relieved->removed, 2 * (0.2 - 0.001) * 80 + 0.3 * 0.1, 1e-2);
  ASSERT_EQ(relieved->findings.size(), 1u);
  EXPECT_EQ(relieved->findings.front().code, "mended_corner");
  // Beyond the kerf it is a wall that lies on another.
  const auto refused = relieved_of(facing_walls(0.3));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, code::overlap);
}

TEST(Reliefs, AreRefusedWhereFlangesCoverEachOther) {
  const Laid part = laid(2.5);
  const auto relieved = relieved_of(part);
  ASSERT_FALSE(relieved);
  EXPECT_EQ(relieved.error().code, code::overlap);
}

TEST(Reliefs, LeaveASoundPatternAlone) {
  const Laid part = laid(-1.0);
  const auto relieved = relieved_of(part);
  ASSERT_TRUE(relieved) << relieved.error().message;
  EXPECT_EQ(relieved->removed, 0.0);
  EXPECT_TRUE(relieved->findings.empty());
}

constexpr double kTongue = 10.0;
const double kZone = pi / 2 * (kRadius + 0.44 * kThickness);

/// A tongue 20 mm wide that is bent up out of a plate 15 mm before its edge, between slits of no
/// width: each end of its bend tears the plate.
Laid lance() {
  test::SheetBuilder builder(kThickness);
  const FaceId base = builder.flange(
      Frame{},
      {test::polygon(
          {{0, 0}, {100, 0}, {100, 75}, {60, 75}, {60, 60}, {40, 60}, {40, 75}, {0, 75}})});
  const test::Rim far = builder.bend(builder.rim(base, 4), test::Turn{Angle::degrees(90), kRadius});
  builder.flange_behind(far, {test::rectangle(far.length, kTongue)});
  Sheet sheet = builder.finish();
  FlatSheet flat = flat_sheet(sheet).value();
  return {std::move(sheet), std::move(flat)};
}

int missing(const Laid& part, const FlatPattern& pattern) {
  for (const Finding& finding : check_rules(part.sheet, pattern, {}))
    if (finding.code == "bend_relief") return static_cast<int>(finding.places.size());
  return 0;
}

TEST(Reliefs, AreCutBesideBendsAsTheRulesAskFor) {
  const Laid part = lance();
  ASSERT_EQ(missing(part, part.flat.pattern), 2);
  // Half as wide as the sheet is thick, over the bend zone and a tenth of the thickness beyond.
  const double width = 0.5 * kThickness, straight = kZone + 0.2 * kThickness;
  const double slit = kTongue - 0.1 * kThickness;
  // They begin this far within the bend and are joined with its edge.
  constexpr double kJoined = 1e-4;
  for (const Relief shape : {Relief::square, Relief::round}) {
    const bool round = shape == Relief::round;
    const auto relieved = relieved_of(part, {.beside_bends = shape});
    ASSERT_TRUE(relieved) << relieved.error().message;
    const FlatPattern& pattern = relieved->pattern;
    EXPECT_EQ(missing(part, pattern), 0);
    // Half circles at both ends, but for the corner where the slit enters.
    const double corner = width * width / 4;
    const double area = width * straight + (round ? (pi + (1 - pi / 4)) * corner : 0.0);
    const double around = 2 * straight + (round ? (0.75 * pi + 1) * width : 2 * width);
    EXPECT_NEAR(relieved->removed, 2 * area, kJoined);
    EXPECT_NEAR(pattern.area, part.flat.pattern.area - 2 * area, kJoined);
    ASSERT_EQ(pattern.openings.size(), 2u);
    ASSERT_EQ(pattern.slits.size(), 2u);
    for (const Contour& opening : pattern.openings) {
      EXPECT_NEAR(length(opening.loop), around, 10 * kJoined);
      EXPECT_EQ(opening.loop.size(), round ? 5u : 4u) << "no steps where it meets the bend";
    }
    ASSERT_EQ(pattern.bends.size(), 1u);
    EXPECT_NEAR(pattern.bends.front().length, 20.0, kJoined);
    ASSERT_EQ(relieved->findings.size(), 1u);
    EXPECT_EQ(relieved->findings.front().code, "bend_relief_cut");
    EXPECT_EQ(relieved->findings.front().severity, Severity::info);
    EXPECT_EQ(relieved->findings.front().at.size(), 2u);
    EXPECT_EQ(
        relieved->findings.front().message,
        round ? "2 round reliefs are cut beside bends; the first, beside bend B1, is 0.5 mm by "
                "2.96 mm"
              : "2 reliefs are cut beside bends; the first, beside bend B1, is 0.5 mm by 2.46 mm");
    for (const Curve2& line : pattern.slits)
      EXPECT_NEAR(length(line), slit - (round ? width / 2 : 0.0), kJoined);
  }
}

/// Two tongues as in `lance`, `bridge` apart, between slits of no width.
Laid two_tongues(double bridge) {
  const double a = 50 - bridge / 2, b = 50 + bridge / 2;
  test::SheetBuilder builder(kThickness);
  const FaceId base = builder.flange(Frame{}, {test::polygon({{0, 0},
                                                              {100, 0},
                                                              {100, 75},
                                                              {b + 20, 75},
                                                              {b + 20, 60},
                                                              {b, 60},
                                                              {b, 75},
                                                              {a, 75},
                                                              {a, 60},
                                                              {a - 20, 60},
                                                              {a - 20, 75},
                                                              {0, 75}})});
  for (const int border : {4, 8}) {
    const test::Rim far = builder.bend(builder.rim(base, border),
                                       test::Turn{Angle::degrees(90), kRadius});
    builder.flange_behind(far, {test::rectangle(far.length, kTongue)});
  }
  Sheet sheet = builder.finish();
  FlatSheet flat = flat_sheet(sheet).value();
  return {std::move(sheet), std::move(flat)};
}

TEST(Reliefs, BesideBendsLeaveTheSheetInOnePiece) {
  // A bridge as wide as one relief and a half would be cut off by two, at the ends of its slits.
  for (const auto& [bridge, cuts] : {std::pair{0.75, 3}, {1.5, 4}})
    for (const Relief shape : {Relief::square, Relief::round}) {
      const Laid part = two_tongues(bridge);
      const auto relieved = relieved_of(part, {.beside_bends = shape});
      ASSERT_TRUE(relieved) << relieved.error().message;
      EXPECT_TRUE(is_one_piece(relieved->pattern, 1e-4));
      EXPECT_EQ(relieved->findings.front().at.size(), static_cast<size_t>(cuts)) << bridge;
      EXPECT_EQ(missing(part, relieved->pattern), 4 - cuts);
    }
}

TEST(Reliefs, NeverTakeABend) {
  // The tongue is 20 mm wide: rips along both its sides leave the rest of the line between them.
  const Laid part = lance();
  const auto narrow = relieved_of(part, {.width = 6.0});
  ASSERT_TRUE(narrow) << narrow.error().message;
  EXPECT_NEAR(narrow->pattern.bends.front().length, 20.0 - 2 * 3.0, 1e-9);
  for (const double width : {30.0, 44.0}) {
    const auto wide = relieved_of(part, {.width = width});
    ASSERT_FALSE(wide) << width;
    EXPECT_EQ(wide.error().code, code::bad_option);
    EXPECT_EQ(wide.error().where, "rip_width");
    EXPECT_NE(wide.error().message.find("bend B1"), std::string::npos) << wide.error().message;
  }
}

TEST(Reliefs, BesideBendsAreLeftOutIfNotAskedFor) {
  const Laid part = lance();
  const auto relieved = relieved_of(part);
  ASSERT_TRUE(relieved) << relieved.error().message;
  EXPECT_EQ(relieved->removed, 0.0);
  EXPECT_EQ(missing(part, relieved->pattern), 2);
}

}  // namespace
}  // namespace planish::job
