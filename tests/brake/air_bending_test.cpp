#include "air_bending.hpp"

#include <gtest/gtest.h>

namespace planish::test {
namespace {

using namespace brake_detail;

/// math.md#tool-fit.
TEST(AirBending, WantsASixFoldVForThinSheetAndMoreForThick) {
  EXPECT_DOUBLE_EQ(wanted_opening(1.0), 6.0);
  EXPECT_DOUBLE_EQ(wanted_opening(2.5), 15.0);
  EXPECT_DOUBLE_EQ(wanted_opening(3.0), 24.0);
  EXPECT_DOUBLE_EQ(wanted_opening(8.0), 64.0);
  EXPECT_DOUBLE_EQ(wanted_opening(9.0), 90.0);
}

TEST(AirBending, ReckonsForcesAsShopsDo) {
  EXPECT_DOUBLE_EQ(force_per_length(450.0, 2.0, 16.0), 1.42 * 450.0 * 4.0 / 16.0);
  EXPECT_DOUBLE_EQ(closing_force(450.0, 2.0), 4.0 * 1.42 * 450.0 * 4.0 / 12.0);
}

/// A radius is large if a V of 12 T leaves less than two thirds of it.
TEST(AirBending, CallARadiusLargeThatNoUsualVLeaves) {
  PlanOptions options;
  EXPECT_FALSE(is_large_radius(0.16 * 24.0 * 1.5 - 1e-6, 2.0, options));
  EXPECT_TRUE(is_large_radius(0.16 * 24.0 * 1.5 + 1e-6, 2.0, options));
}

}  // namespace
}  // namespace planish::test
