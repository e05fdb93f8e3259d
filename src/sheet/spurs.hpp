#pragma once

#include <planish/sheet/flat_pattern.hpp>

namespace planish::sheet_detail {

/// A contour without the stretches that it runs there and back, and these, each once. Whoever is
/// wholly such a stretch has no curves left. Where a slit leaves the contour there is a corner.
struct WithoutSpurs {
  Contour contour;
  std::vector<Segment> slits;
};

/// Takes back, from their tips on, straight stretches whose two banks lie within `tolerance` of
/// each other; stretches that lie in one line and touch are one. O(n), and the square of the slits.
WithoutSpurs without_spurs(const Contour& contour, double tolerance);

}  // namespace planish::sheet_detail
