#include "tangent_pieces.hpp"

#include "support/bent_bracket.hpp"
#include "support/unfolded_shape.hpp"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace planish::test {
namespace {

using std::numbers::pi;

constexpr double kDrilled = 2.5;

TopoDS_Shape drill_at(double x) {
  return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(x, 25, -1), gp_Dir(0, 0, 1)), kDrilled, 7).Shape();
}

/// The area of a round hole across a tangent line or over the bend, its middle `beyond` the
/// line: towards the flange the wall's end on the inside is innermost over the bend, on the other
/// side the one on the outside, at the radii 6 and 8 of the bend.
double area_between_ends(double beyond) {
  constexpr int kSteps = 200000;
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double a = pi * (i + 0.5) / kSteps, half = kDrilled * std::sin(a);
    const double low = beyond - half, high = beyond + half;
    const double from = low < 0 ? low : 7 * std::asin(low / 6), to = 7 * std::asin(high / 8);
    sum += std::max(0.0, to - from) * kDrilled * std::sin(a);
  }
  return sum * pi / kSteps;
}

TEST(NarrowToCell, CutsWhereEitherEndOfTheWallIsInnermost) {
  const BentBracket wide{2, 6, 40, 30, 50};
  const double blank = 50 * (40 + 30 + pi / 2 * 7);
  for (const double beyond : {0.3, 0.9, 1.8}) {
    const auto made = unfolded_shape(
        BRepAlgoAPI_Cut(bent_bracket(wide), drill_at(wide.first + beyond)));
    ASSERT_TRUE(made) << made.error().message;
    EXPECT_NEAR(blank - made->flat.area, area_between_ends(beyond), 1e-4) << beyond;
    EXPECT_LT(made->certificate.opening_error.value_or(0), 1e-3);
  }
}

}  // namespace
}  // namespace planish::test
