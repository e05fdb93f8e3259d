#include "support/sheets.hpp"

#include <planish/sheet/allowance.hpp>
#include <planish/sheet/flat_pattern.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace planish::test {
namespace {

/// Length of a strip laid flat with a bend of another inside radius than the drawn one.
double length_made(const Sheet& sheet, double radius) {
  FlattenOptions options;
  options.allowance = ConstantK{0.4, "test"};
  options.made_radius = {{sheet.bends.ids().front(), radius}};
  const auto flat = flat_sheet(sheet, options);
  EXPECT_TRUE(flat) << flat.error().message;
  return flat ? blank_size(flat->pattern).x() : 0.0;
}

/// Between flanges in the same planes the outside lengths stay: both, less the deduction of the
/// radius that is made. A K-table is read at that radius too.
TEST(MadeRadius, KeepsTheOutsideLengths) {
  for (const double degrees : {30.0, 90.0, 120.0})
    for (const double drawn : {1.0, 3.0})
      for (const double made : {0.5, 2.0, 3.0}) {
        const double thickness = 2.0, leg = 60.0;
        const Angle angle = Angle::degrees(degrees);
        const double half = std::tan(0.5 * angle.radians());
        const Sheet sheet = strip(
            {Straight{leg - (drawn + thickness) * half}, Turn{angle, drawn, BendDirection::up},
             Straight{leg - (drawn + thickness) * half}},
            50, thickness);
        const double deduction = 2.0 * (made + thickness) * half -
                                 angle.radians() * (made + 0.4 * thickness);
        EXPECT_NEAR(length_made(sheet, made), 2.0 * leg - deduction, 1e-9)
            << degrees << " " << drawn << " " << made;
      }
}

/// So does a fold that is drawn sharp, on the inside skin or in the middle of the sheet.
TEST(MadeRadius, KeepsTheOutsideLengthsOfASharpFold) {
  const Sheet sheet = strip(
      {Straight{60}, Crease{Angle::degrees(90), BendDirection::up}, Straight{40}}, 50, 2.0);
  const double reference = sheet.reference_depth;
  const double inside = sheet[sheet.bends.ids().front()].reference_inside ? reference
                                                                          : 2.0 - reference;
  // Both legs from where the reference surfaces meet; the inside corner is `inside` nearer.
  const double legs = 100.0 + 2.0 * (2.0 - inside);
  const double deduction = 2.0 * (1.5 + 2.0) - std::numbers::pi / 2.0 * (1.5 + 0.8);
  EXPECT_NEAR(length_made(sheet, 1.5), legs - deduction, 1e-9);
}

/// A radius that takes more of the flanges than the bend gives back has no pattern; by how much is
/// said.
TEST(MadeRadius, RefusesWhatTakesTheFlanges) {
  const Sheet sheet = strip(
      {Straight{60}, Turn{Angle::degrees(150), 1.0, BendDirection::up}, Straight{60}}, 50, 2.0);
  FlattenOptions options;
  options.made_radius = {{sheet.bends.ids().front(), 20.0}};
  const auto flat = flat_sheet(sheet, options);
  ASSERT_FALSE(flat);
  EXPECT_EQ(flat.error().code, code::bad_option);
  const double angle = Angle::degrees(150).radians(),
               k = flat_sheet(sheet)->pattern.bends.front().allowance.k_factor;
  const double short_by = 2.0 * (20.0 - 1.0) * std::tan(angle / 2.0) - angle * (20.0 + k * 2.0);
  const std::string& message = flat.error().message;
  const auto at = message.find("needs ");
  ASSERT_NE(at, std::string::npos) << message;
  constexpr double kRounded = 6e-3;
  EXPECT_NEAR(std::stod(message.substr(at + 6)), short_by, kRounded) << message;
}

}  // namespace
}  // namespace planish::test
