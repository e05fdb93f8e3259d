#pragma once

#include "periodic_spline.hpp"

#include <planish/base/result.hpp>
#include <planish/base/tolerance.hpp>
#include <planish/geometry/plane.hpp>

#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

namespace planish::transition_detail {

/// Corners that turn by less (sine) are straight; edges shorter than this share of the extent are
/// points.
inline constexpr double kNoCorner = tolerance::kComputed;

// `place` is where an error is in the request, "/from/profile/polygon".

/// Error: `invalid_input` for a size that is not positive and finite.
Result<void> check_sizes(std::initializer_list<double> sizes, const std::string& place);

/// Whether a curve of that smallest radius can be set `outwards` (mm). Error: `radius_too_small`.
Result<void> check_radius(double tightest, double outwards, const std::string& place);

/// Errors: `too_few_corners`, `repeated_corner`, `self_crossing`, `invalid_input` (not finite, no
/// area).
Result<void> check_polygon(const std::vector<Vec2>& corners, const std::string& place);

/// Of a ridge or an apex, two corners or one. Errors: `repeated_corner`, `invalid_input`.
Result<void> check_ridge(const std::vector<Vec2>& corners, const std::string& place);

/// For a polygon that runs counter-clockwise; `given` maps its corners to their original numbers.
/// Error: `profile_not_convex`.
Result<void> check_convex(const std::vector<Vec2>& corners, const std::function<int(int)>& given,
                          const std::string& place);

/// The same of a spline that is set `outwards`. Errors: `profile_not_convex`, `radius_too_small`.
Result<void> check_convex(const PeriodicSpline& spline, double outwards, const std::string& place);

/// Unit directions of the edges before and after a corner.
struct Turn {
  Vec2 in, out;
  double sine() const { return cross(in, out); }  ///< to the left
};
Turn turn_at(const std::vector<Vec2>& corners, int i);

}  // namespace planish::transition_detail
