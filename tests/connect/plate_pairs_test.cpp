#include "plate_pairs.hpp"

#include "sample_fits.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace planish::test {
namespace {

using namespace connect_detail;

PlacedPlate floor_plate() {
  return laid(rectangle_plate("A", {0, 0, 0}, {200, 0, 0}, {0, 100, 0}));
}
PlacedPlate upright(const Vec3& o, double width = 100, double height = 100) {
  return laid(rectangle_plate("B", o, {width, 0, 0}, {0, 0, height}));
}

TEST(Intersection, IsInTheMiddleOfWhatTwoPlatesShare) {
  const auto at = intersection(floor_plate(), upright({50, 40, -30}), kPlanarity);
  ASSERT_TRUE(at);
  EXPECT_LT((*at - Vec3(100, 40, 0)).norm(), 1e-9);
}

TEST(Intersection, IsNotThereWherePlatesOnlyTouch) {
  EXPECT_FALSE(intersection(floor_plate(), upright({50, 40, 0}), kPlanarity)) << "stands on it";
  EXPECT_FALSE(intersection(floor_plate(), upright({50, 100, -30}), kPlanarity)) << "at its border";
  EXPECT_FALSE(intersection(floor_plate(), upright({300, 40, -30}), kPlanarity)) << "beside it";
}

TEST(Intersection, IsNotThereWhereAPlateStandsInAnOpening) {
  Plate holed = rectangle_plate("A", {0, 0, 0}, {200, 0, 0}, {0, 100, 0});
  holed.holes = {{{40, 20, 0}, {160, 20, 0}, {160, 60, 0}, {40, 60, 0}}};
  EXPECT_FALSE(intersection(laid(holed), upright({50, 40, -30}), kPlanarity));
  EXPECT_TRUE(intersection(laid(holed), upright({50, 80, -30}), kPlanarity)) << "behind it";
  const auto wider = intersection(laid(holed), upright({30, 40, -30}), kPlanarity);
  ASSERT_TRUE(wider) << "into both sides of it";
  EXPECT_NEAR(wider->x(), 35.0, 1e-9);
  const PlacedPlate inlay = laid(rectangle_plate("B", {50, 25, 0}, {50, 0, 0}, {0, 30, 0}));
  EXPECT_FALSE(intersection(laid(holed), inlay, kPlanarity)) << "in one plane";
}

TEST(Intersection, OfPlatesInOnePlaneIsACommonArea) {
  const auto beside = [](double x) {
    return laid(rectangle_plate("B", {x, 50, 0}, {100, 0, 0}, {0, 100, 0}));
  };
  const auto at = intersection(floor_plate(), beside(150), kPlanarity);
  ASSERT_TRUE(at);
  EXPECT_TRUE(at->x() > 150 - 1e-6 && at->x() < 200 + 1e-6);
  EXPECT_FALSE(intersection(floor_plate(), beside(200), kPlanarity));
}

TEST(TooNearTo, APlateIsWhatStandsInItsSheet) {
  // 0.5 mm over the middle of a sheet of 2 mm that stands square on it: half a thickness is needed.
  const auto near = too_near(floor_plate(), upright({50, 40, 0.5}), 2.0);
  ASSERT_TRUE(near);
  EXPECT_NEAR(near->distance, 0.5, 1e-12);
  EXPECT_NEAR(near->needed, 1.0, 1e-12);
  EXPECT_FALSE(too_near(floor_plate(), upright({50, 40, 1.0}), 2.0));
}

TEST(TooNearTo, APlateNeedsMoreOfOneThatLeansOverIt) {
  const double slope = std::numbers::pi / 6;
  const PlacedPlate leaning = laid(rectangle_plate("B", {50, 40, 1.5}, {100, 0, 0},
                                                   50 * Vec3(0, std::cos(slope), std::sin(slope))));
  const auto near = too_near(floor_plate(), leaning, 2.0);
  ASSERT_TRUE(near);
  EXPECT_NEAR(near->needed, 1.0 + std::cos(slope), 1e-12);
}

TEST(TooNearTo, APlateIsNothingBesideItsBorderOrInItsHoles) {
  EXPECT_FALSE(too_near(floor_plate(), upright({50, 98.5, 0.5}), 2.0)) << "a weld at the border";
  Plate holed = rectangle_plate("A", {0, 0, 0}, {200, 0, 0}, {0, 100, 0});
  holed.holes = {{{40, 20, 0}, {160, 20, 0}, {160, 60, 0}, {40, 60, 0}}};
  EXPECT_FALSE(too_near(laid(holed), upright({50, 40, 0.5}), 2.0));
}

}  // namespace
}  // namespace planish::test
