#include "rule_checks.hpp"

#include <fmt/format.h>

#include <cmath>

namespace planish::inspect_detail {
namespace {

/// How far beside the corner of a bend zone material is sought: ten times a drawing's error, and
/// four times as far along the bend as across, so that an edge that continues straight but slanted
/// past the bend does not count as sheet beside it.
constexpr double kAcross = 10.0 * kDrawn;
constexpr double kBeside = 4.0 * kAcross;

/// How deep the bottom of a relief is sought, as a multiple of R + T. Deeper ones are cut-outs.
constexpr double kReach = 5.0;

/// A corner of a bend zone: an end of a tangent line.
struct ZoneCorner {
  Vec2 at;
  Vec2 beyond;   // unit vector along the tangent line, out of the bend
  Vec2 outward;  // unit vector across it, into the flange
};

/// The relief beside a corner. Width and depth are infinite if no material limits them.
struct Relief {
  Vec2 at = Vec2::Zero();
  bool missing = false;
  bool flush = false;  // missing, and the sheet beside the bend ends where the bend begins
  double width = std::numeric_limits<double>::infinity();
  double depth = std::numeric_limits<double>::infinity();  // beyond the tangent line
};

/// Limits for a relief; depth is beyond the tangent line.
struct Limits {
  double width = 0.0;
  double depth = 0.0;
};

/// The corners of a bend zone at the bend's end in `direction`.
std::vector<ZoneCorner> corners_towards(const Workpiece& workpiece, size_t bend,
                                        const Vec2& direction) {
  std::vector<ZoneCorner> corners;
  for (const BendSide& side : workpiece.sides_of(bend)) {
    if (side.length() <= 0.0) continue;
    const Vec2 along = (side.end - side.start) / side.length();
    const bool forward = along.dot(direction) > 0.0;
    corners.push_back(
        {forward ? side.end : side.start, forward ? along : Vec2(-along), side.outward});
  }
  return corners;
}

double free_way(const Workpiece& workpiece, const Vec2& from, const Vec2& direction, double reach) {
  return workpiece.contours.first_hit(from, direction, reach, [](size_t) { return true; });
}

bool uncut(const Workpiece& workpiece, const Vec2& from, const Vec2& to) {
  const double distance = (to - from).norm();
  return !std::isfinite(free_way(workpiece, from, (to - from) / distance, distance));
}

/// Whether the flange's own sheet lies beside the corner, `beside` along the bend and `depth` into
/// the flange: if so, a path from the bend into the flange and then aside crosses no cut.
bool flange_goes_on(const Workpiece& workpiece, const ZoneCorner& corner, double beside,
                    double depth) {
  const Vec2 inside = corner.at - kBeside * corner.beyond;
  const Vec2 start = inside + kAcross * corner.outward;
  const Vec2 turn = inside + (kAcross + depth) * corner.outward;
  const Vec2 goal = turn + (kBeside + beside) * corner.beyond;
  return workpiece.material(goal) && uncut(workpiece, start, turn) && uncut(workpiece, turn, goal);
}

/// The relief between a corner and the sheet beside it; infinite if the flange does not continue
/// beside the bend, not even around a relief: at free ends, and at the side of a tab, where the
/// slit beside it is not a relief.
Relief relief_at(const Workpiece& workpiece, const ZoneCorner& corner, const Limits& limits,
                 double outside) {
  const double reach = kReach * outside;
  Relief relief{corner.at};
  relief.missing = flange_goes_on(workpiece, corner, kBeside, 0.5 * kAcross);
  if (relief.missing) {
    relief.flush = !workpiece.material(corner.at + kBeside * corner.beyond -
                                       kQuarter * outside * corner.outward);
    return relief;
  }
  const Vec2 level = corner.at + kBeside * corner.beyond + kAcross * corner.outward;
  const double width = workpiece.material(level)
                           ? 0.0
                           : kBeside + free_way(workpiece, level, corner.beyond, limits.width);
  const double middle = std::max(kBeside, 0.5 * std::min(width, limits.width));
  bool bottom = false;
  for (double depth = kAcross; depth < reach && !bottom; depth *= 1.5)
    bottom = flange_goes_on(workpiece, corner, middle, depth);
  if (!bottom) return relief;
  relief.width = width;
  if (limits.depth > kAcross && width > 0.0)
    relief.depth = free_way(workpiece, corner.at + middle * corner.beyond, corner.outward,
                            limits.depth);
  return relief;
}

/// How far a relief falls short of the limits, negative if it does.
double excess(const Relief& relief, const Limits& limits) {
  if (relief.missing) return -std::max(limits.width, limits.depth);
  return std::min(relief.width - limits.width, relief.depth - limits.depth);
}

/// A bend beside sheet that goes on tears it; where that sheet's edge is flush with the bend, its
/// corner only bulges.
Severity severity(const FlatBend& bend, const Relief& relief, const Limits& limits,
                  const Rules& rules, double thickness) {
  if (rules.strict) return Severity::warning;
  if (relief.missing) return relief.flush ? Severity::info : Severity::warning;
  const double setback = measured_setback(bend, thickness);
  return severity_of(relief.depth + setback, limits.depth + setback, kHalf, rules);
}

std::string relief_text(const FlatBend& bend, const Relief& relief, const Limits& limits,
                        const Rules& rules, double thickness) {
  const double setback = measured_setback(bend, thickness);
  const std::string width = fmt::format("{} ({})", mm_text(limits.width),
                                        factors_text(rules.relief_width_t));
  const std::string depth = fmt::format("{} ({})", mm_text(limits.depth + setback),
                                        factors_text(rules.relief_depth_t, rules.relief_depth_r));
  if (relief.missing) {
    return fmt::format(
        "bend {} ends {} at {} without relief; it needs one {} wide and, from the "
        "outside of the bend, {} "
        "deep",
        bend.id, relief.flush ? "flush with an edge" : "inside an edge", point_text(relief.at),
        width, depth);
  }
  if (relief.width < limits.width - kDrawn) {
    return fmt::format("the relief of bend {} at {} is {} wide; at least {} is needed", bend.id,
                       point_text(relief.at), mm_text(relief.width), width);
  }
  return fmt::format(
      "the relief of bend {} at {} is {} deep from the outside of the bend; at least {} is needed",
      bend.id, point_text(relief.at), mm_text(relief.depth + setback), depth);
}

bool seen_already(const std::vector<Observation>& observations, const Vec2& p, double near) {
  return std::any_of(observations.begin(), observations.end(),
                     [&](const Observation& o) { return (o.place.at.front() - p).norm() <= near; });
}

}  // namespace

std::vector<Observation> observe_reliefs(const Workpiece& workpiece, const Rules& rules) {
  std::vector<Observation> result;
  if (rules.relief_width_t <= 0.0) return result;
  for (size_t b = 0; b < workpiece.pattern.bends.size(); ++b) {
    if (!workpiece.spans[b]) continue;
    const FlatBend& bend = workpiece.pattern.bends[b];
    const double outside = bend.inside_radius + workpiece.thickness;
    // Measured from the outside of the bend, like flanges: from there R + T reaches the tangent
    // line.
    const Limits limits{rules.relief_width_t * workpiece.thickness,
                        rules.relief_depth_t * workpiece.thickness +
                            rules.relief_depth_r * bend.inside_radius - outside};
    const Vec2 along = workpiece.spans[b]->end - workpiece.spans[b]->start;
    for (const bool forward : {false, true}) {
      Relief worst;
      for (const ZoneCorner& corner :
           corners_towards(workpiece, b, forward ? along : Vec2(-along))) {
        const Relief relief = relief_at(workpiece, corner, limits, outside);
        const bool same = worst.missing && relief.missing;
        if (same ? worst.flush && !relief.flush : excess(relief, limits) < excess(worst, limits))
          worst = relief;
      }
      // Bends that meet in a corner lack only one relief between them.
      if (excess(worst, limits) >= -kDrawn || seen_already(result, worst.at, workpiece.thickness))
        continue;
      result.push_back({"bend_relief",
                        {severity(bend, worst, limits, rules, workpiece.thickness),
                         relief_text(bend, worst, limits, rules, workpiece.thickness),
                         {worst.at}},
                        excess(worst, limits)});
    }
  }
  return result;
}

}  // namespace planish::inspect_detail
