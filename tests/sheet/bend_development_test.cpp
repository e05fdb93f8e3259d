#include "bend_development.hpp"

#include "support/sheets.hpp"

#include <planish/sheet/codes.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace planish::test {
namespace {

using sheet_detail::allowances_of;
using sheet_detail::developments_of;
using sheet_detail::neutral_offsets_of;

constexpr double kThick = 2.0;

FlattenOptions with_k(double k) {
  FlattenOptions options;
  options.allowance = ConstantK{k, "test"};
  return options;
}

Sheet bent(double degrees, double radius, BendDirection direction) {
  return strip({Straight{50}, Turn{Angle::degrees(degrees), radius, direction}, Straight{30}}, 40,
               kThick);
}

/// A fold about a surface `depth` below the reference skin.
Sheet hinged(double degrees, BendDirection direction, double depth) {
  Sheet sheet = strip({Straight{50}, Crease{Angle::degrees(degrees), direction}, Straight{30}}, 40,
                      kThick);
  sheet.reference_depth = depth;
  return sheet;
}

TEST(BendDevelopment, IsAsLongAsTheNeutralArc) {
  for (const BendDirection direction : {BendDirection::up, BendDirection::down})
    for (const double k : {0.0, 0.3, 0.5, 1.0}) {
      const Sheet sheet = bent(70, 3.0, direction);
      const auto allowances = allowances_of(sheet, with_k(k));
      const auto developments = developments_of(sheet, *allowances);
      ASSERT_TRUE(developments);
      const BendId bend{0};
      const Box2 box = parameter_box(sheet[sheet[bend].faces.front()]);
      const Development& flat = *(*developments)[bend];
      const double arc = 70 * std::acos(-1.0) / 180 * (3.0 + k * kThick);
      EXPECT_NEAR((flat.develop({box.hi.x(), 5}) - flat.develop({box.lo.x(), 5})).norm(), arc,
                  1e-9);
      EXPECT_NEAR((*allowances)[bend].allowance, arc, 1e-9);
    }
}

TEST(BendDevelopment, OffsetsReachTheNeutralRadius) {
  for (const BendDirection direction : {BendDirection::up, BendDirection::down}) {
    const Sheet sheet = bent(70, 3.0, direction);
    const auto offsets = neutral_offsets_of(sheet, *allowances_of(sheet, with_k(0.3)));
    for (const FaceId id : sheet.faces.ids()) {
      const auto* surface = std::get_if<Developable>(&sheet[id].surface);
      if (surface == nullptr) {
        EXPECT_EQ(offsets[id], 0.0);
      } else {
        EXPECT_NEAR(std::get<Cylinder>(*surface).radius + offsets[id], 3.0 + 0.3 * kThick, 1e-12);
      }
    }
  }
}

TEST(BendDevelopment, TakesTheKOfOneBendForThatBendAlone) {
  const Sheet sheet = u_channel();
  FlattenOptions options = with_k(0.3);
  options.bend_k = {{BendId{1}, 0.45}};
  const auto allowances = allowances_of(sheet, options);
  EXPECT_EQ((*allowances)[BendId{0}].k_factor, 0.3);
  EXPECT_EQ((*allowances)[BendId{1}].k_factor, 0.45);
}

TEST(BendDevelopment, HingeTurnsAboutItsSurface) {
  const double turn = std::acos(-1.0) / 3, tangent = std::tan(turn / 2);
  for (const double depth : {0.5, 1.0, 1.7})
    for (const double k : {0.3, 0.5}) {
      // Seen from the inside, the neutral surface lies K T deep, the hinge `depth`.
      const Sheet up = hinged(60, BendDirection::up, depth);
      const BendAllowance inner = (*allowances_of(up, with_k(k)))[BendId{0}];
      EXPECT_NEAR(inner.allowance, turn * (k * kThick - depth), 1e-12);
      EXPECT_NEAR(inner.deduction, 2 * (kThick - depth) * tangent - inner.allowance, 1e-12);
      // The reference skin outside: the inside is T − depth from the hinge.
      const Sheet down = hinged(60, BendDirection::down, depth);
      const BendAllowance outer = (*allowances_of(down, with_k(k)))[BendId{0}];
      EXPECT_NEAR(outer.allowance, turn * (k * kThick - (kThick - depth)), 1e-12);
      EXPECT_NEAR(outer.deduction, 2 * depth * tangent - outer.allowance, 1e-12);
    }
}

TEST(BendDevelopment, OfASharpBendIsNone) {
  const Sheet sheet = hinged(60, BendDirection::up, 0.0);
  const auto allowances = allowances_of(sheet, with_k(0.4));
  EXPECT_NEAR((*allowances)[BendId{0}].allowance, std::acos(-1.0) / 3 * 0.4 * kThick, 1e-12);
  EXPECT_FALSE((*developments_of(sheet, *allowances))[BendId{0}]);
}

TEST(BendDevelopment, RefusesANeutralSurfaceWithoutARadius) {
  const Sheet sheet = bent(90, 0.0, BendDirection::down);
  const auto none = developments_of(sheet, *allowances_of(sheet, with_k(0.0)));
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code, code::bad_option);
  EXPECT_TRUE(developments_of(sheet, *allowances_of(sheet, with_k(0.01))));
  EXPECT_FALSE(allowances_of(sheet, with_k(1.5))) << "no such K";
}

TEST(BendDevelopment, RefusesAConeWhoseTipTheNeutralSurfaceReaches) {
  // Down: the reference skin is outside, 2 tan 20° = 0.73 mm from the axis where it begins.
  const auto cone = [](double k) {
    ConeJoint joint;
    joint.turn = {Angle::degrees(70), Angle::degrees(20), 2.0, BendDirection::down};
    const Sheet sheet = cone_joined(joint);
    return developments_of(sheet, *allowances_of(sheet, with_k(k))).has_value();
  };
  EXPECT_FALSE(cone(0.2)) << "0.8 · 1.5 = 1.2 mm further in";
  EXPECT_TRUE(cone(0.8)) << "0.3 mm further in";
}

}  // namespace
}  // namespace planish::test
