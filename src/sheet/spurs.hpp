#pragma once

#include <planish/sheet/flat_pattern.hpp>

namespace planish::sheet_detail {

/// A contour without the stretches that it runs there and back, and these stretches, each once. A
/// contour that consists only of such a stretch has no curves left. There is a corner where a slit
/// leaves the contour.
struct WithoutSpurs {
  Contour contour;
  std::vector<Segment> slits;
};

/// Removes, starting at their tips, straight stretches whose two banks lie within `tolerance` of
/// each other; collinear stretches that touch become one. O(n + slits²).
WithoutSpurs without_spurs(const Contour& contour, double tolerance);

}  // namespace planish::sheet_detail
