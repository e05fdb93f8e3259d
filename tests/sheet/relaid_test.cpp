#include "relaid.hpp"

#include "support/sheets.hpp"

#include <planish/sheet/codes.hpp>
#include <planish/sheet/flat_pattern.hpp>

#include <gtest/gtest.h>

#include <numbers>

// The certificate's own layout, against closed forms: the layout that made the pattern is not used.

namespace planish::test {
namespace {

using sheet_detail::HingeBand;
using sheet_detail::Relaid;
using std::numbers::pi;

constexpr double kRelaidK = 0.4;

struct Stated {
  Sheet sheet;
  FlatPattern pattern;
  Relaid laid;
};

/// Laid with face 0 where the pattern has no say: in its own coordinates.
Stated stated(const Sheet& sheet, const Isometry2& placed = Isometry2::Identity()) {
  FlatPattern pattern;
  pattern.root = FaceId{0};
  pattern.root_placement = placed;
  for (const BendId id : sheet.bends.ids()) {
    FlatBend bend;
    bend.bend = id;
    bend.allowance = *bend_allowance(ConstantK{kRelaidK, "test"}, sheet.thickness,
                                     sheet[id].inside_radius, sheet[id].angle);
    pattern.bends.push_back(bend);
  }
  const auto allowances = sheet_detail::stated_allowances(sheet, pattern);
  if (!allowances) throw std::runtime_error(allowances.error().message);
  auto laid = sheet_detail::relaid(sheet, pattern, *allowances);
  if (!laid) throw std::runtime_error(laid.error().message);
  return {sheet, pattern, *laid};
}

void expect_at(const Stated& stated, FaceId face, const Vec2& uv, const Vec2& wanted) {
  EXPECT_LT((stated.laid.image(face, uv) - wanted).norm(), 1e-9)
      << stated.laid.image(face, uv).transpose() << ", not " << wanted.transpose();
  EXPECT_LT((stated.laid.fold(face, wanted) - uv).norm(), 1e-9);
}

TEST(Relaid, LaysAStripOutToItsFlatLength) {
  for (const BendDirection direction : {BendDirection::up, BendDirection::down}) {
    const Turn turn{Angle::degrees(70), 3.0, direction};
    const Stated s = stated(strip({Straight{50}, turn, Straight{30}}, 40.0, 2.0));
    const double allowance = turn.angle.radians() * (3.0 + kRelaidK * 2.0);
    const FaceId last{2};
    ASSERT_TRUE(std::holds_alternative<FlangeId>(s.sheet[last].part_of));
    // Its x runs against y of the strip, from the end of its border; y away from the bend.
    expect_at(s, last, {0, 0}, {50 + allowance, 40});
    expect_at(s, last, {40, 30}, {80 + allowance, 0});
  }
}

TEST(Relaid, ShiftsANarrowerWallAlongASharpFold) {
  for (const double from : {0.0, 7.0, 20.0}) {
    SheetBuilder builder(2.0);
    const FaceId base = builder.flange({}, {rectangle(50, 40)});
    Rim rim = builder.crease(builder.rim(base, 1), {Angle::degrees(90), BendDirection::up});
    rim.frame.origin += from * rim.frame.y;
    rim.length = 20;
    builder.flange_behind(rim, {rectangle(20, 30)});
    const Stated s = stated(builder.finish());
    expect_at(s, FaceId{1}, {0, 0}, {50 + pi / 2 * 0.8, from + 20});
    expect_at(s, FaceId{1}, {20, 30}, {80 + pi / 2 * 0.8, from});
  }
}

TEST(Relaid, TakesTheRootsPlaceFromThePattern) {
  Isometry2 placed = Isometry2::Identity();
  placed.rotate(0.7).pretranslate(Vec2(-20, 90));
  const Stated here = stated(z_profile()), there = stated(z_profile(), placed);
  for (const FaceId face : here.sheet.faces.ids())
    EXPECT_LT((there.laid.image(face, {0.5, 3}) - placed * here.laid.image(face, {0.5, 3})).norm(),
              1e-9);
}

TEST(Relaid, SetsBackOnlyWhereASharpBendHasItsReferenceSkinOutside) {
  const auto creased = [](double degrees, BendDirection direction) {
    return strip({Straight{50}, Crease{Angle::degrees(degrees), direction}, Straight{30}}, 40, 2);
  };
  const auto setback = [](const Sheet& sheet) {
    return sheet_detail::setback_at(sheet, sheet.joints.front());
  };
  EXPECT_EQ(setback(creased(90, BendDirection::up)), 0.0);
  EXPECT_NEAR(setback(creased(90, BendDirection::down)), 2.0, 1e-12);
  EXPECT_NEAR(setback(creased(60, BendDirection::down)), 2.0 / std::sqrt(3.0), 1e-12);
  EXPECT_EQ(setback(l_bracket_down()), 0.0);
  Sheet between = creased(90, BendDirection::down);
  between.reference_depth = 1.0;
  EXPECT_EQ(setback(between), 0.0);
}

TEST(Relaid, MovesKToTheMiddleWithTheAllowance) {
  const Sheet sheet = strip({Straight{50}, Turn{Angle::degrees(70), 3.0}, Straight{30}}, 40, 2);
  IdVector<BendId, BendAllowance> allowances;
  allowances.push_back(*bend_allowance(ConstantK{0.3, ""}, 2.0, 3.0, Angle::degrees(70)));
  const auto half = sheet_detail::at_half(sheet, allowances);
  EXPECT_EQ(half[BendId{0}].k_factor, 0.5);
  EXPECT_NEAR(half[BendId{0}].allowance, 70 * pi / 180 * (3.0 + 0.5 * 2.0), 1e-12);
}

TEST(Relaid, RefusesAPatternThatLeavesOutABendAndASheetInTwoParts) {
  const Sheet sheet = u_channel();
  FlatPattern pattern = stated(sheet).pattern;
  pattern.bends.pop_back();
  const auto missing = sheet_detail::stated_allowances(sheet, pattern);
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, code::pattern_wrong);
  Sheet parted = sheet;
  parted.joints.pop_back();
  const Stated whole = stated(sheet);
  const auto laid = sheet_detail::relaid(parted, whole.pattern,
                                         *sheet_detail::stated_allowances(sheet, whole.pattern));
  ASSERT_FALSE(laid);
  EXPECT_EQ(laid.error().code, code::not_a_sheet);
}

TEST(HingeBand, LiesBetweenTheBordersItJoins) {
  for (const double turned : {0.0, 0.9}) {
    Isometry2 placed = Isometry2::Identity();
    placed.rotate(turned).pretranslate(Vec2(5, 7));
    for (const BendDirection direction : {BendDirection::up, BendDirection::down}) {
      const Stated s = stated(
          strip({Straight{50}, Crease{Angle::degrees(90), direction}, Straight{30}}, 40, 2),
          placed);
      const double width = 1.3;
      const HingeBand band = sheet_detail::hinge_band(s.sheet, s.laid, s.sheet.joints.front(),
                                                      width);
      // Where the reference skin is outside, it begins one setback, T tan 45°, before the corner.
      const double from = direction == BendDirection::up ? 50.0 : 48.0;
      EXPECT_NEAR(band.length, 40.0, 1e-9);
      const auto holds = [&](double x, double y, double tolerance = 1e-6) {
        return band.holds(placed * Vec2(x, y), tolerance);
      };
      for (const double y : {0.01, 20.0, 39.99}) {
        EXPECT_TRUE(holds(from + 0.01, y));
        EXPECT_TRUE(holds(from + width - 0.01, y));
        EXPECT_FALSE(holds(from - 0.01, y));
        EXPECT_FALSE(holds(from + width + 0.01, y));
        EXPECT_TRUE(holds(from - 0.01, y, 0.02));
        EXPECT_TRUE(holds(from + width + 0.01, y, 0.02));
      }
      EXPECT_FALSE(holds(from + 0.5, -0.01));
      EXPECT_FALSE(holds(from + 0.5, 40.01));
      EXPECT_TRUE(holds(from + 0.5, -0.01, 0.02));
      EXPECT_TRUE(holds(from + 0.5, 40.01, 0.02));
    }
  }
}

TEST(HingeBand, IsOnTheSameSideInAPatternSeenFromBehind) {
  Isometry2 mirrored = Isometry2::Identity();
  mirrored.linear()(1, 1) = -1.0;
  const Stated s = stated(
      strip({Straight{50}, Crease{Angle::degrees(90), BendDirection::up}, Straight{30}}, 40, 2),
      mirrored);
  const HingeBand band = sheet_detail::hinge_band(s.sheet, s.laid, s.sheet.joints.front(), 1.3);
  EXPECT_TRUE(band.holds({50.6, -20}, 1e-6));
  EXPECT_FALSE(band.holds({49.4, -20}, 1e-6));
}

TEST(HingeBand, CoversBothBordersWhereOneIsLonger) {
  SheetBuilder builder(2.0);
  const FaceId base = builder.flange({}, {rectangle(50, 40)});
  Rim rim = builder.crease(builder.rim(base, 1), {Angle::degrees(90), BendDirection::up});
  rim.frame.origin -= 10 * rim.frame.y;
  rim.length = 65;
  builder.flange_behind(rim, {rectangle(65, 30)});
  const Stated s = stated(builder.finish());
  const HingeBand band = sheet_detail::hinge_band(s.sheet, s.laid, s.sheet.joints.front(), 1.0);
  EXPECT_NEAR(band.length, 65.0, 1e-9);
  EXPECT_LT((band.origin - Vec2(50, -10)).norm(), 1e-9) << band.origin.transpose();
}

}  // namespace
}  // namespace planish::test
