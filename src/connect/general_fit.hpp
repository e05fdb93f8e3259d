#pragma once

#include "bend_surface.hpp"

#include <planish/base/result.hpp>

#include <optional>

namespace planish::connect_detail {

/// Tangent lines of a general cone: through one apex on the intersection line, each side with the
/// slope that suits its own edges, so that smaller extensions are needed than with one slope for
/// both sides.
struct GeneralLines {
  double apex = 0.0;
  std::array<TangentLine, 2> lines;
  double area = 0.0;  ///< plate extension of both sides, mm²
};

/// Lines of least plate extension; the apex as given, or where the extension of one of the edges
/// meets the intersection line. Errors: `apex_in_span`, `no_bend_fits`; `where` is the key at
/// fault.
Result<GeneralLines> general_lines(const std::array<std::vector<Vec2>, 2>& corners, EdgeKind edges,
                                   std::optional<double> apex);

/// The general cone tangent to both plates along `lines`, over the arc that leaves the plates at
/// their ends far from the apex: elliptic, its end tangents meeting in `tangent_point` on the
/// intersection line (math.md#general-cone and math.md#corner-cone); by default the point from
/// which the arc is circular. Error: `no_bend_fits`.
Result<BendSurface> general_surface(const BendFrame& frame, const GeneralLines& lines,
                                    const std::array<std::vector<Vec2>, 2>& corners,
                                    const std::optional<Vec3>& tangent_point, double extent);

/// Smallest radius of curvature of the mid-surface in the middle of a ruling between two
/// boundaries.
double middle_radius(const BendSurface& surface, const Curve2& low, const Curve2& high);

/// The surface at a constant distance along the normal, with the same (u, v) on the same normals
/// (math.md#neutral-surface).
Ruled offset_surface(const BendSurface& surface, double offset);

}  // namespace planish::connect_detail
