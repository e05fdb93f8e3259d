#pragma once

#include <planish/geometry/curve.hpp>

#include <limits>
#include <vector>

namespace planish::inspect_detail {

/// The nearest points of two shapes.
struct Gap {
  double distance = std::numeric_limits<double>::infinity();
  Vec2 a = Vec2::Zero();
  Vec2 b = Vec2::Zero();
};

/// A loop with the boxes of its curves.
struct BoxedLoop {
  explicit BoxedLoop(const Loop& loop);

  const Loop* loop;
  std::vector<Box2> boxes;
  Box2 box;
};

/// Nearest points of two curves, a on the first. Exact if one is a full circle outside the other
/// curve or both are segments; else sampled and refined to rounding, which can only miss a second
/// place that is equally near. Crossing curves have distance 0 if both are segments, and a small
/// one otherwise.
Gap gap_between(const Curve2& a, const Curve2& b);

/// Nearest points of two loops if they are closer than `reach`, else an infinite distance.
Gap gap_between(const BoxedLoop& a, const BoxedLoop& b, double reach);
Gap gap_between(const BoxedLoop& a, const Curve2& b, double reach);

}  // namespace planish::inspect_detail
