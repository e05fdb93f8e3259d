#pragma once

#include <planish/connect/connect.hpp>
#include <planish/sheet/flat_pattern.hpp>

#include <gtest/gtest.h>

namespace planish::test {

/// Area of the flat pattern at K = ½, mm².
inline double area_when_flat(const Connection& connection) {
  const auto pattern = flatten(connection.sheet,
                               {.allowance = ConstantK{0.5, "test"}, .root = connection.root});
  EXPECT_TRUE(pattern);
  return pattern ? pattern->area : 0.0;
}

}  // namespace planish::test
