#pragma once

#include <planish/job/report.hpp>

#include <optional>
#include <span>
#include <vector>

namespace planish::job {

/// What a caliper shows once a stroke is made.
struct CheckDimension {
  FlangeId flange{};
  double length = 0.0;  ///< mm
};

/// Of each stroke, in order, the shorter side of the bend, as a caliper measures it: from the
/// outside of the bend to the far edge, or to the outside of the bend there (bend.md#check). Bends
/// that are not formed yet are flat. Empty where no side ends along the bend line, and of a stroke
/// that leaves its bend unfinished.
std::vector<std::optional<CheckDimension>> check_dimensions(const Report& report,
                                                            std::span<const Stroke> strokes);

}  // namespace planish::job
