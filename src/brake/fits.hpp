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

/// The narrowest V that is taken unasked: 4 T.
double narrowest_opening(double thickness);

/// The V that is wanted for a line: as given; of a large radius R 2.2 R + 2 T if there is a punch
/// of it, else the one that leaves it in air bending; or that for the thickness.
double wanted_opening(const BrakeLine& line, const BrakeTools& tools, const PlanOptions& options);

/// Force of air bending, N per mm of line, which is kN per metre.
double force_per_length(double tensile_strength, double thickness, double opening);

/// Of closing a hem: four times that of bending over the wanted V, as shops reckon.
double closing_force(double tensile_strength, double thickness);

/// kN that a stroke on a line takes over a die: of air bending, or of closing a hem.
double force_of(const BrakeLine& line, const Die& die, const PlanOptions& options);

/// Whether the V of a die is sharp enough for a line.
bool is_sharp_for(const BrakeLine& line, const Die& die, const PlanOptions& options);

/// The inside radius that is left: that of air bending over the V, or the tip's.
double made_radius(const Punch& punch, const Die& die, const PlanOptions& options);

/// Whether a radius is met in practice: within a third of the drawn one.
bool meets(double made, double drawn);

/// Whether the widest usual V leaves less than two thirds of a drawn radius.
bool is_large_radius(double radius, double thickness, const PlanOptions& options);

/// How far a hem is bent before it is closed: as far as the sharpest punch and die go. 0 without
/// flat tools to close it.
Angle angle_before_closing(const BrakeTools& tools, const PlanOptions& options);

/// How a workpiece is cut at its lines for these tools: radii of what is pressed without one of its
/// own are those of the wanted V.
WorkpieceOptions workpiece_options(double thickness, const BrakeTools& tools,
                                   const PlanOptions& options, std::vector<LargeBend> large = {});

/// A punch and a die that bend a line.
struct ToolPair {
  int punch = 0, die = 0;  ///< positions in the list of tools
  int v_away = 0;          ///< sizes of the catalogue between its V and the wanted one
  friend bool operator==(const ToolPair&, const ToolPair&) = default;
};

/// Which tools bend a line, whatever the stage (math.md#tool-fit).
struct FittingTools {
  std::vector<ToolPair> pairs;  ///< of the wanted V first
  /// If there is none: goes on from "there is".
  std::optional<Remark> why = {};
  double wider = 0.0;  ///< opening of a V that would do and is wider than usual, mm; 0: none
};
FittingTools fitting_tools(const BrakeLine& line, const BrakeTools& tools,
                           const PlanOptions& options);

}  // namespace planish::brake_detail
