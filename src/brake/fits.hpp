#pragma once

#include "workpiece.hpp"

#include <planish/base/message.hpp>
#include <planish/brake/plan.hpp>
#include <planish/brake/tools.hpp>

#include <string>
#include <vector>

namespace planish::brake_detail {

/// The V opening for a thickness: 6 T up to 2.5 mm, 8 T to 8 mm, 10 T above.
double wanted_opening(double thickness);

/// Force of air bending, N per mm of line, which is kN per metre.
double force_per_length(double tensile_strength, double thickness, double opening);

/// Of closing a hem: four times that of bending over the wanted V, as shops reckon.
double closing_force(double tensile_strength, double thickness);

/// How far a hem is bent before it is closed: as far as the sharpest punch and die go. 0 without
/// flat tools to close it.
Angle angle_before_closing(const BrakeTools& tools, const PlanOptions& options);

/// How a workpiece is cut at its lines for these tools: radii of what is pressed without one of its
/// own are those of the wanted V.
WorkpieceOptions workpiece_options(double thickness, const BrakeTools& tools,
                                   const PlanOptions& options);

/// Which tools bear a line, whatever the stage (math.md#tool-fit).
struct FittingTools {
  std::vector<int> punches;  ///< positions in the list of tools
  std::vector<int> dies;     ///< all of one opening
  /// If one of them is empty: goes on from "there is".
  std::optional<Remark> why = {};
};
FittingTools fitting_tools(const BrakeLine& line, const BrakeTools& tools,
                           const PlanOptions& options);

}  // namespace planish::brake_detail
