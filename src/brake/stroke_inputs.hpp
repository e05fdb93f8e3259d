#pragma once

#include "fits.hpp"
#include "line_set.hpp"
#include "segments.hpp"

#include <planish/brake/stroke_search.hpp>

#include <vector>

namespace planish::brake_detail {

/// What all strokes of a workpiece are asked about: given, or following from what is given. Nothing
/// of it changes once it is made. The tools must outlive it.
struct StrokeInputs {
  Workpiece work;
  const BrakeTools& tools;
  PlanOptions options;
  std::vector<FittingTools> fitting;                      ///< by line
  std::vector<SegmentSums> punch_segments, die_segments;  ///< by tool
  std::vector<Vec2> directions;  ///< of the pattern, by the numbers of `StrokeChoice`
  /// By punch and die: what stands on the bed together has one number. That are punches of one
  /// height over dies of one V, whose flanks are alike: others would meet while these press.
  std::vector<std::vector<int>> beds = {};
  /// By line: those that continue it in the pattern and are bent alike, itself included.
  std::vector<std::vector<int>> on_one_line;

  int lines() const { return static_cast<int>(work.lines.size()); }
};
StrokeInputs stroke_inputs(Workpiece work, const BrakeTools& tools, const PlanOptions& options);

/// The number of a direction of the pattern; −1 if no line is bent that way.
int direction_number(const StrokeInputs& inputs, const Vec2& direction);

/// How far a line is turned in its stroke, springback included, radians.
double most_turn(const StrokeInputs& inputs, int line);

/// How much of each end of a bend line the tools may leave out, mm.
double shortfall(const StrokeInputs& inputs);

/// Lines pressed in a stage, with these tools and this way round.
struct Setting {
  const LineSet* formed = nullptr;  ///< the stage; not owned
  LineSet pressed;
  int line = 0;  ///< the first of those pressed
  int punch = 0, die = 0;
  int direction = 1;  ///< +1: the gauge is on the left of the line, −1: on its right
  bool ears = true;   ///< whether the punch may stand on them
};
Setting setting(const StrokeInputs& inputs, const LineSet& formed, const StrokeChoice& choice);

/// The ears of a punch as the operator sees them, from the left; none if it has none.
RowEars ears_of(const Punch& punch);
/// Those of a stroke's punch along its line; dies and beams have none.
RowEars ears_of(const StrokeInputs& inputs, const Setting& stroke, ToolKind kind);

/// How the sheet moves in a stroke.
PressMotion motion(const StrokeInputs& inputs, const Setting& stroke);
/// The same as the punch sees it: bent about a tip that is rounder than the drawn radius.
PressMotion motion_at_punch(const StrokeInputs& inputs, const Setting& stroke);

}  // namespace planish::brake_detail
