#pragma once

#include <planish/brake/plan.hpp>

#include <vector>

namespace planish {

/// A stroke seen along the bend line, as math.md#machine-frame has it: y towards the back gauge and
/// z up, mm, from the lowest point of the inside skin.
struct StrokePicture {
  std::vector<ToolProfile> lying;  ///< the workpiece before the stroke: convex, may overlap; empty
                                   ///< for one that closes a hem
  std::vector<ToolProfile> bent;   ///< after it, without springback
  ToolProfile punch, upper_beam;   ///< a beam is empty if the machine has none
  ToolProfile die, lower_beam;     ///< where they stand after the stroke
  double die_drop = 0.0;           ///< how much higher they stand before it
  ToolProfile finger;              ///< where it touches; empty if ungauged
};

/// The pictures of a plan's strokes, in order. Requires the sheet, layout, tools and options that
/// the plan was made with.
std::vector<StrokePicture> stroke_pictures(const Sheet& sheet, const Layout& layout,
                                           const BrakeTools& tools, const PlanOptions& options,
                                           const Plan& plan);

}  // namespace planish
