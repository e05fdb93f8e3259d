#include <planish/base/length_unit.hpp>

#include <gtest/gtest.h>

namespace planish {
namespace {

TEST(LengthUnit, IsSoManyMillimetres) {
  EXPECT_EQ(millimetres_in(LengthUnit::mm), 1.0);
  EXPECT_EQ(millimetres_in(LengthUnit::inch), 25.4);
  EXPECT_EQ(millimetres_in(LengthUnit::m), 1000.0);
  EXPECT_NEAR(12 * millimetres_in(LengthUnit::inch) / millimetres_in(LengthUnit::m), 0.3048, 1e-15)
      << "a foot";
}

}  // namespace
}  // namespace planish
