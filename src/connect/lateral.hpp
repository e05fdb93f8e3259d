#pragma once

#include "bend_surface.hpp"

#include <planish/base/result.hpp>

#include <utility>
#include <vector>

namespace planish::connect_detail {

/// A part of a line, from one place to another.
using Spread = std::pair<double, double>;

/// One lateral boundary of a bend: where it meets the tangent rulings, and its curve in the (u, v)
/// of the mid-surface from azimuth 0 to `sweep`.
struct Boundary {
  std::array<double, 2> v{};  ///< by side
  Curve2 curve;
};

/// Both lateral boundaries: at lower and at higher v.
struct Boundaries {
  LateralBoundary kind = LateralBoundary::straight;
  Boundary low, high;
};

/// End corners of the selected runs, in the (v, h) of their sides.
struct RunEnds {
  std::array<Vec2, 2> low, high;  ///< by side
};

struct LateralOptions {
  double neutral_offset = 0.0;  ///< of the neutral surface from the mid-surface along its normal,
                                ///< mm
  /// Sections common to both tangent rulings on which the bend runs over neither plate
  /// (math.md#lateral-boundaries): intervals of levels, ascending.
  std::vector<Spread> legal;
  double extent = 0.0;  ///< of both plates, mm
};

/// Chooses the lateral boundaries (math.md#lateral-boundaries). Errors: `no_common_width` for a
/// boundary that was asked for but is impossible, and for bends without common width.
Result<Boundaries> lateral_boundaries(const BendSurface& surface, const RunEnds& ends,
                                      LateralBoundary wanted, const LateralOptions& options);

/// The boundary along the circle of one level.
Boundary along_directrix(const BendSurface& surface, double level, double extent);

/// Where there is material on a line that crosses the borders of a plate in these places.
std::vector<Spread> material_between(std::vector<double> crossings);

/// What parts of the range [low, high] leave free of it, ascending.
std::vector<Spread> left_free(std::vector<Spread> taken, double low, double high);

/// Sections of the ruling h = 0 next to which, at h < 0, an outline and its holes, in any order
/// and given in (v, h), have no material: intervals of v within [low, high], ascending (after
/// appendix 1 of bibliography.md#thesis).
std::vector<Spread> legal_sections(const std::vector<std::vector<Vec2>>& rings, double low,
                                   double high, double tolerance);

}  // namespace planish::connect_detail
