// The least distance left in a stroke. Every block of the workpiece is swept past every tool where
// both are: past beams whole, past punch and die as far as their rows reach. What must hold: a pair
// farther apart than the least so far need not be told apart (math.md#stroke-clearance).
#include "clearance.hpp"

#include "standing.hpp"
#include "sweep.hpp"

#include <algorithm>

namespace planish::brake_detail {
namespace {

constexpr double kFarAway = 1000.0;  // mm: distances above are not told apart

/// A section of a tool that stands along a range of x.
struct Beside {
  CrossSection of = CrossSection::whole;
  Interval along;
};

/// What of a tool stands beside a block.
std::vector<Beside> beside(const Interval& block, ToolKind kind, const PressRows& rows) {
  if (!is_row(kind)) return {{CrossSection::whole, block}};
  std::vector<Beside> all;
  const auto add = [&](CrossSection of, const Interval& along) {
    const Interval range{std::max(block.lo, along.lo), std::min(block.hi, along.hi)};
    if (range.lo <= range.hi) all.push_back({of, range});
  };
  for (const ToolRow& row : kind == ToolKind::punch ? rows.punch : rows.die) {
    add(CrossSection::whole, body(row));
    if (row.ears.any()) add(CrossSection::foot, extent(row));
  }
  return all;
}

}  // namespace

double clearance(StageCache& cache, const Setting& stroke, const PressRows& rows) {
  double least = kFarAway;
  const PressMotion at_die = motion(cache.inputs(), stroke),
                    at_punch = motion_at_punch(cache.inputs(), stroke);
  const double most = most_turn(cache.inputs(), stroke.line);
  const std::vector<const PlacedPart*>& parts = cache.parts(stroke);
  for (int part = 0; part < std::ssize(parts); ++part) {
    const PlacedPart& placed = *parts[part];
    for (const ToolKind kind : kToolKinds) {
      const Nearness near = nearness(cache, stroke, part, kind);
      const PressMotion& motion = is_above(kind) ? at_punch : at_die;
      for (const Block3& block : placed.blocks)
        for (const auto& [of, along] : beside(extent(block), kind, rows)) {
          const Convex cut = section(block, along.lo, along.hi);
          if (cut.empty()) continue;
          const SidedObstacle body = cache.tools().body(kind, tool_of(kind, stroke), near,
                                                        stroke.direction, of);
          const Obstacle& obstacle = placed.left ? *body.left : *body.right;
          const Moving moving = turned_with_side(motion, cut);
          least = std::min(least, closest(motion, moving, obstacle, most, least).distance);
        }
    }
  }
  return least;
}

}  // namespace planish::brake_detail
