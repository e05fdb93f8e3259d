#pragma once

#include "mould_clear.hpp"

#include <planish/base/result.hpp>
#include <planish/slit/mould.hpp>

#include <vector>

namespace planish::slit_detail {

/// Panels turned by less from `up` are upright in the mould: rounding of folded frames, radians.
constexpr double kUprightPanel = 1e-9;

/// How the walls behind the panels stand, seen from above (in the plane of the base frame).
struct WallSetting {
  Frame plan;           ///< the base's, at any height
  double sign = -1.0;   ///< of the sheet's normal towards the mould
  double offset = 0.0;  ///< half the thickness
  double depth = 0.0;   ///< of the walls
};

/// A wall behind each panel that stands upright in the mould; footprints only. Panels that do not
/// have none. Error: `unsupported_shape`, if a wall would run through itself.
Result<std::vector<MouldWall>> walls_of(const FoldedSlitSheet& folded, const WallSetting& setting);

/// Whether a quad lies over the room of a wall, so that the wall and not a rib is below it.
bool is_over(const std::vector<MouldWall>& walls, const WholeStrip& strip, int quad,
             const WallSetting& setting);

/// Gives the walls their height: that of the panels, or less where strips come down over them.
/// Error: `unsupported_shape`, if less than a quarter of the panel is left.
Result<void> raise(std::vector<MouldWall>& walls,
                   const std::vector<std::vector<WholeStrip>>& strips, const WallSetting& setting);

/// Lowest point of the panels' facets in a direction.
double lowest_of_panels(const FoldedSlitSheet& folded, const Vec3& up);

/// A closed prism on the base plane.
Mesh wall_mesh(const MouldWall& wall, const Frame& base);

/// Ribs and walls on a plate: one closed body. The plate reaches `beyond` past them on all sides.
/// Error: `unsupported_shape`, if ribs or walls touch each other.
Result<Mesh> body_of(const Mould& mould, double plate, double beyond);

}  // namespace planish::slit_detail
