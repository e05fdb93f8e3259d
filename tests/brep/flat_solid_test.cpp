#include "solid_check.hpp"
#include "support/sheets.hpp"

#include <planish/brep/step.hpp>

#include <gtest/gtest.h>

#include <numbers>

namespace planish::test {
namespace {

using brep::SolidCheck;
using std::numbers::pi;

FlatPattern pattern(const Loop& outer, const std::vector<Loop>& openings, double thickness) {
  FlatPattern result;
  result.thickness = thickness;
  result.outer.loop = outer;
  for (const Loop& opening : openings)
    result.openings.push_back({opening, {}});
  return result;
}

SolidCheck flat(const FlatPattern& pattern) {
  const auto text = flat_solid_step(pattern, "flat");
  if (!text) {
    ADD_FAILURE() << text.error().message;
    return {};
  }
  const SolidCheck check = brep::check_step_solid(*text).value_or(SolidCheck{});
  EXPECT_EQ(check.solids, 1);
  EXPECT_TRUE(check.valid);
  EXPECT_TRUE(check.closed);
  EXPECT_EQ(check.product, "flat");
  return check;
}

TEST(FlatSolid, LiesBelowThePattern) {
  const SolidCheck check = flat(pattern(rectangle(100, 60), {}, 2.5));
  EXPECT_NEAR(check.volume, 100 * 60 * 2.5, 1e-8);
  EXPECT_LT((check.lo - Vec3(0, 0, -2.5)).norm(), 1e-6);
  EXPECT_LT((check.hi - Vec3(100, 60, 0)).norm(), 1e-6);
  EXPECT_EQ(check.planes, 6);
}

TEST(FlatSolid, MakesCylindersOfArcs) {
  const Loop rounded{Segment{{0, 0}, {100, 0}}, Segment{{100, 0}, {100, 50}},
                     Arc{{90, 50}, 10, 0.0, pi / 2}, Segment{{90, 60}, {0, 60}},
                     Segment{{0, 60}, {0, 0}}};
  const SolidCheck check = flat(pattern(
      rounded,
      {circular_opening({30, 30}, 5), obround_opening({60, 30}, 12, 4, Angle::degrees(30))}, 2));
  EXPECT_EQ(check.cylinders, 1 + 1 + 2);
  EXPECT_EQ(check.planes, 2 + 4 + 2);
  EXPECT_NEAR(check.volume, 2 * (6000 - (100 - 25 * pi) - 25 * pi - (12 * 8 + 16 * pi)), 1e-6);
}

TEST(FlatSolid, MakesExtrusionsOfSplines) {
  const CubicSpline ellipse = elliptic_arc({50, 30}, 20, 10, 0.0, -2 * pi);
  const SolidCheck check = flat(pattern(rectangle(100, 60), {{ellipse}}, 3));
  EXPECT_EQ(check.extrusions + check.splines, 1);
  EXPECT_NEAR(check.volume, 3 * (6000 + green_area(ellipse)), 1e-5);
  EXPECT_NEAR(check.volume, 3 * (6000 - 200 * pi), 1e-4);
}

TEST(FlatSolid, OfASplineOutlineIsSound) {
  const CubicSpline half = elliptic_arc({0, 0}, 40, 25, 0.0, pi);
  const SolidCheck check = flat(pattern({half, Segment{{-40, 0}, {40, 0}}}, {}, 1));
  EXPECT_NEAR(check.volume, 0.5 * pi * 40 * 25, 1e-4);
}

TEST(FlatSolid, OfACircleIsSound) {
  const SolidCheck check = flat(
      pattern({Arc{{5, 5}, 20, 0.3, 2 * pi}}, {circular_opening({5, 5}, 4)}, 1.5));
  EXPECT_NEAR(check.volume, 1.5 * pi * (400 - 16), 1e-6);
  EXPECT_EQ(check.cylinders, 2);
  EXPECT_EQ(check.planes, 2);
}

TEST(FlatSolid, KeepsCornersOfSplines) {
  // Two pieces that meet at a right angle: a pointed arch.
  const CubicSpline arch{{{20, 0}, {20, 10}, {10, 20}, {0, 20}, {0, 30}, {-20, 30}, {-20, 0}}};
  const SolidCheck check = flat(pattern({arch, Segment{{-20, 0}, {20, 0}}}, {}, 1));
  EXPECT_NEAR(check.volume, green_area(arch), 1e-6);
}

TEST(FlatSolid, RefusesAPatternWithoutThickness) {
  const auto text = flat_solid_step(pattern(rectangle(10, 10), {}, 0.0), "flat");
  ASSERT_FALSE(text);
  EXPECT_EQ(text.error().code, code::invalid_input);
}

}  // namespace
}  // namespace planish::test
