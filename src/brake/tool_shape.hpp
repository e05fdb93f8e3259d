#pragma once

#include "press_motion.hpp"

#include <planish/brake/tools.hpp>

#include <vector>

namespace planish::brake_detail {

/// What a workpiece may penetrate without harm, mm (math.md#stroke-clearance).
inline constexpr double kPenetration = 0.05;

/// The section of a tool in the machine frame: rounded, and moved to where it stands.
struct ToolSection {
  std::vector<Vec2> outline;  ///< counter-clockwise
};

/// The punch with its tip rounded, its lowest point at height 0.
ToolSection section_of(const Punch& punch);
/// What of it reaches to the outer ends of its ears; empty if it has none.
ToolSection foot_of(const Punch& punch);
/// How far the punch moves down because its tip is rounded, and the upper beam with it.
double lowered(const Punch& punch);
/// The upper beam as it stands when it holds that punch.
ToolSection upper_beam_over(const Punch& punch, const PressBrake& machine);
ToolSection section_of(const Die& die);
ToolSection section_of(const ToolProfile& profile, double lowered = 0.0);
/// The rounded corner of the V.
Shoulder shoulder_of(const Die& die);

/// What a part of the workpiece keeps away from: convex pieces, and by how much.
struct Obstacle {
  std::vector<Convex> pieces;
  std::vector<double> keeps;  ///< by piece, mm
  std::vector<Box2> boxes;    ///< of the pieces
  Box2 box;                   ///< of all
  double keep = 0.0;          ///< the largest of `keeps`
  bool moves = false;         ///< with the die
};

/// `clearance` 0: what is deeper in the tool than `depth`. Above: the tool itself, kept away from.
Obstacle obstacle_of(const ToolSection& section, double depth, double clearance);
/// The same, of what of the punch stands out beyond the wedge of its tip, prolonged.
Obstacle obstacle_beside_tip(const Punch& punch, double clearance);
/// What of it is at most that high.
Obstacle up_to(Obstacle obstacle, double height);
/// Both at once.
Obstacle united(Obstacle a, const Obstacle& b);
Obstacle mirrored(const Obstacle& obstacle);
/// Moved by that much.
Obstacle moved(Obstacle obstacle, const Vec2& by);
/// Whether it is its own mirror image.
bool is_symmetric(const ToolSection& section);

}  // namespace planish::brake_detail
