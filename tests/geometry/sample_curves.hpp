#pragma once

#include <planish/geometry/curve.hpp>

#include <gtest/gtest.h>

#include <numbers>

namespace planish::test {

using std::numbers::pi;

inline Loop unit_square() {
  return {Segment{{0, 0}, {1, 0}}, Segment{{1, 0}, {1, 1}}, Segment{{1, 1}, {0, 1}},
          Segment{{0, 1}, {0, 0}}};
}

inline void expect_near(const Vec2& a, const Vec2& b, double bound) {
  EXPECT_LE((a - b).norm(), bound) << a.transpose() << " and " << b.transpose();
}

}  // namespace planish::test
