#pragma once

#include "hull.hpp"

#include <planish/geometry/developable.hpp>

#include <array>
#include <optional>

namespace planish::transition_detail {

/// A right cone or cylinder through both sides of a patch.
struct RightSurface {
  Developable surface;
  double u0 = 0.0, u1 = 0.0;  ///< where the patch begins and ends
  std::array<double, 2> v{};  ///< of both profiles
};

/// The surface of a patch between two coaxial circles, or between a circle and a point of its axis;
/// empty if the patch is not a part of such a surface. Requires: a patch that is not a plane.
std::optional<RightSurface> right_surface(const Hull& hull, const HullPatch& patch);

}  // namespace planish::transition_detail
