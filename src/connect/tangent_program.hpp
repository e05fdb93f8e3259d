#pragma once

#include "run_envelope.hpp"

#include <planish/connect/edge_search.hpp>

#include <array>
#include <optional>

namespace planish::connect_detail {

/// Corners first … last of a chain.
struct CornerRange {
  const RunEnvelope* chain = nullptr;
  int first = 0, last = -1;
  bool empty() const { return last < first; }
  double left() const { return chain->corners()[first].x(); }
  double right() const { return chain->corners()[last].x(); }
};

/// The cost of a tangent line: Σ over both sides of weights · (largest height of the line over the
/// intersection line, largest extension), or an area. An empty side costs nothing.
struct TangentCost {
  double height = 0.0;     ///< of max_j (k x_j − q)
  double extension = 0.0;  ///< of max_j (y_j − k x_j + q), averted max_j (k x_j − q − y_j)
  Vec2 linear = Vec2::Zero();  ///< of (k, q)
};

/// A tangent line and what it costs.
struct TangentOptimum {
  TangentLine line;
  double value = 0.0;
};

/// Least cost over all tangent lines that math.md#tangent-lines allows for the corners of both
/// sides, subject to the given values. For each slope the best offset is at a bound; the remaining
/// cost is convex and piecewise linear in the slope (math.md#widest-bend). `size` is the extent of
/// the corners; `start` a slope near the optimum, if known.
std::optional<TangentOptimum> cheapest_tangent(const std::array<CornerRange, 2>& sides,
                                               EdgeKind kind, const TangentCost& cost,
                                               const GivenLine& given, double size,
                                               double start = 0.0);

/// Extent of corners: the largest |x − x₀| or y.
double size_of(const std::array<CornerRange, 2>& sides);

}  // namespace planish::connect_detail
