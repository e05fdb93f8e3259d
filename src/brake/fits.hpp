#pragma once

#include "air_bending.hpp"

#include <planish/base/message.hpp>
#include <planish/brake/plan.hpp>
#include <planish/brake/tools.hpp>

#include <string>
#include <vector>

namespace planish::brake_detail {

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
  double wider = 0.0;      ///< opening of a V that would do and is wider than usual, mm; 0: none
  double shortfall = 0.0;  ///< with which the tools' segments would do, if it is little, mm; 0:
                           ///< none
};
FittingTools fitting_tools(const BrakeLine& line, const BrakeTools& tools,
                           const PlanOptions& options);

}  // namespace planish::brake_detail
