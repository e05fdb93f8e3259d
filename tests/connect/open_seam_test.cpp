#include "sample_plates.hpp"

#include <planish/connect/connect.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace planish::test {
namespace {

using std::numbers::pi;

double turn_of(const Sheet& sheet) {
  double turn = 0.0;
  for (const Border& border : sheet.faces.front().loops[0])
    turn = std::max(turn, bounds(border.curve).hi.x());
  return turn;
}

TEST(WithOpenSeam, LeavesAHundredthOfAMillimetreOfAPipe) {
  PlateStructure pipe;
  pipe.thickness = 2.0;
  pipe.bends = {{.inside_radius = 50.0, .angle = Angle::degrees(360), .length = 200.0}};
  const auto made = connect(pipe);
  ASSERT_TRUE(made);
  // The reference skin is the outer one, of radius 52.
  EXPECT_NEAR(turn_of(with_open_seam(made->sheet)), 2 * pi - 0.01 / 52, 1e-12);
}

TEST(WithOpenSeam, LeavesItAtTheNarrowEndOfACone) {
  PlateStructure cone;
  cone.thickness = 2.0;
  cone.bends = {
      {.inside_radii = std::array{60.0, 30.0}, .angle = Angle::degrees(360), .length = 100.0}};
  const auto made = connect(cone);
  ASSERT_TRUE(made);
  const double cosine = 1 / std::hypot(1, 0.3), radius = 30 + 2 * cosine;  // of the outer skin
  EXPECT_NEAR(turn_of(with_open_seam(made->sheet)), 2 * pi - 0.01 / radius, 1e-9);
}

TEST(WithOpenSeam, LeavesOtherSheetsAsTheyAre) {
  PlateStructure part;
  part.thickness = 2.0;
  part.bends = {{.inside_radius = 50.0, .angle = Angle::degrees(359), .length = 200.0}};
  const auto made = connect(part);
  ASSERT_TRUE(made);
  EXPECT_EQ(turn_of(with_open_seam(made->sheet)), turn_of(made->sheet));
}

}  // namespace
}  // namespace planish::test
