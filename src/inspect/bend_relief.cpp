// Reliefs at the ends of bends (math.md#reliefs): at each corner of a bend zone rays look for sheet
// beside the bend that belongs to its flange. A path from the bend into the flange and then aside
// that crosses no cut says that the flange goes on; width and depth of the air beside the corner
// are measured from there. Free ends, sides of tabs and cut-outs deeper than 5 (R + T) have nothing
// to relieve.

#include "rule_checks.hpp"

#include <planish/inspect/missing_relief.hpp>

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
  bool flush = false;  // missing, and the sheet beside the bend ends near to where the bend begins
  bool clear = false;  // exactly there: nothing of it is beside the bend
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
  const auto any = [](std::size_t) { return true; };
  return std::min(workpiece.contours.first_hit(from, direction, reach, any),
                  workpiece.slits.first_hit(from, direction, reach, any));
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
    const auto beside = [&](double behind) {
      return workpiece.material(corner.at + kBeside * corner.beyond - behind * corner.outward);
    };
    relief.flush = !beside(kQuarter * outside);
    relief.clear = relief.flush && !beside(kAcross);
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
  // From just beyond the tangent line, where a relief may begin or have a step.
  if (limits.depth > kAcross && width > 0.0)
    relief.depth = kAcross + free_way(workpiece,
                                      corner.at + middle * corner.beyond + kAcross * corner.outward,
                                      corner.outward, limits.depth);
  return relief;
}

/// Where the sheet beside the bend ends at the tangent line, a relief no deeper than that is air.
bool asks_for_cut(const Relief& relief, const Limits& limits) {
  return !relief.clear || limits.depth > kDrawn;
}

/// How far a relief falls short of the limits, negative if it does; least where nothing is to be
/// cut.
double excess(const Relief& relief, const Limits& limits) {
  if (relief.missing)
    return asks_for_cut(relief, limits) ? -std::max(limits.width, limits.depth) : -2.0 * kDrawn;
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

FindingPlace relief_breach(const FlatBend& bend, const Relief& relief, const Limits& limits,
                           const Rules& rules, double thickness) {
  const double setback = measured_setback(bend, thickness), depth = limits.depth + setback;
  const std::string width_rule = factors_text(rules.relief_width_t),
                    depth_rule = factors_text(rules.relief_depth_t, rules.relief_depth_r);
  Facts facts{{"bend", place::at(place::bend(bend.id), relief.at)},
              {"at", place::point(relief.at)}};
  const auto say = [&](say::Sentence sentence, const Facts& more) {
    facts.insert(facts.end(), more.begin(), more.end());
    return breach(severity(bend, relief, limits, rules, thickness), sentence, facts, {relief.at});
  };
  if (relief.missing && !asks_for_cut(relief, limits)) return say(say::flush_bend, {});
  if (relief.missing)
    return say(relief.flush ? say::no_relief_at_flush_edge : say::no_relief,
               {{"wanted_width", limits.width, unit::mm},
                {"width_rule", width_rule},
                {"wanted_depth", depth, unit::mm},
                {"depth_rule", depth_rule}});
  if (relief.width < limits.width - kDrawn)
    return say(say::narrow_relief, {{"measured", relief.width, unit::mm},
                                    {"wanted", limits.width, unit::mm},
                                    {"rule", width_rule}});
  return say(say::shallow_relief, {{"measured", relief.depth + setback, unit::mm},
                                   {"wanted", depth, unit::mm},
                                   {"rule", depth_rule}});
}

/// What the rules ask for beside a bend. Measured from the outside of the bend, like flanges: from
/// there R + T reaches the tangent line.
Limits limits_for(const FlatBend& bend, const Rules& rules, double thickness) {
  return {rules.relief_width_t * thickness, rules.relief_depth_t * thickness +
                                                rules.relief_depth_r * bend.inside_radius -
                                                (bend.inside_radius + thickness)};
}

/// Sheet that goes on counts before a slit beside it, and before an edge that is flush.
bool is_worse(const Relief& relief, const Relief& than, const Limits& limits) {
  if (relief.missing && than.missing) return than.flush && !relief.flush;
  const double shorter = excess(than, limits) - excess(relief, limits);
  return std::abs(shorter) <= kDrawn ? relief.missing && !than.missing : shorter > 0.0;
}

/// An end of a bend that has no relief, or less than the rules ask for.
struct ShortRelief {
  const FlatBend* bend = nullptr;
  ZoneCorner corner;  // the worse one
  Relief relief;      // beside it
  Limits limits;
  double zone = 0.0;           // width of the bend zone
  bool on_both_sides = false;  // the other corner asks for a cut as well
};

/// That at the bend's end in `direction`, if it is short.
std::optional<ShortRelief> short_relief(const Workpiece& workpiece, size_t bend,
                                        const Vec2& direction, const Rules& rules) {
  const FlatBend& given = workpiece.pattern.bends[bend];
  const Limits limits = limits_for(given, rules, workpiece.thickness);
  ShortRelief worst{&given, {}, {}, limits};
  const auto corners = corners_towards(workpiece, bend, direction);
  int cuts = 0;
  for (const ZoneCorner& corner : corners) {
    const Relief relief = relief_at(workpiece, corner, limits,
                                    given.inside_radius + workpiece.thickness);
    if (excess(relief, limits) < -kDrawn && asks_for_cut(relief, limits)) ++cuts;
    if (is_worse(relief, worst.relief, limits)) {
      worst.relief = relief;
      worst.corner = corner;
    }
  }
  if (excess(worst.relief, limits) >= -kDrawn) return std::nullopt;
  for (const ZoneCorner& other : corners)
    worst.zone = std::max(worst.zone, (worst.corner.at - other.at).dot(worst.corner.outward));
  worst.on_both_sides = cuts > 1;
  return worst;
}

double excess(const ShortRelief& relief) { return excess(relief.relief, relief.limits); }

/// All of them, in the order of bends. Bends that meet in a corner lack only one relief between
/// them, which is the worse.
std::vector<ShortRelief> short_reliefs(const Workpiece& workpiece, const Rules& rules) {
  std::vector<ShortRelief> found;
  if (rules.relief_width_t <= 0.0) return found;
  const auto take = [&](const ShortRelief& relief) {
    for (ShortRelief& other : found) {
      if (other.bend == relief.bend ||
          (other.relief.at - relief.relief.at).norm() > workpiece.thickness)
        continue;
      if (excess(relief) < excess(other) - kDrawn) other = relief;
      return;
    }
    found.push_back(relief);
  };
  for (size_t b = 0; b < workpiece.pattern.bends.size(); ++b) {
    if (!workpiece.spans[b]) continue;
    const Vec2 along = workpiece.spans[b]->end - workpiece.spans[b]->start;
    for (const Vec2& direction : {Vec2(-along), along})
      if (const auto relief = short_relief(workpiece, b, direction, rules)) take(*relief);
  }
  return found;
}

/// How far the sheet beside the bend goes on behind the bend zone, if that is less than `limit`.
double web_behind(const Workpiece& workpiece, const ShortRelief& relief, double limit) {
  const ZoneCorner& corner = relief.corner;
  const Vec2 from = corner.at + kHalf * relief.limits.width * corner.beyond -
                    relief.zone * corner.outward;
  if (!workpiece.material(from)) return 0.0;
  const double web = free_way(workpiece, from, -corner.outward, limit);
  return std::isfinite(web) ? web : 0.0;
}

}  // namespace

std::vector<Observation> observe_reliefs(const Workpiece& workpiece, const Rules& rules) {
  return mapped(short_reliefs(workpiece, rules), [&](const ShortRelief& found) {
    return Observation{
        asks_for_cut(found.relief, found.limits) ? "bend_relief" : "flush_bend",
        relief_breach(*found.bend, found.relief, found.limits, rules, workpiece.thickness),
        excess(found)};
  });
}

}  // namespace planish::inspect_detail

namespace planish {

std::vector<MissingRelief> missing_reliefs(const Sheet& sheet, const FlatPattern& pattern,
                                           const Rules& rules) {
  using namespace inspect_detail;
  std::vector<MissingRelief> missing;
  const Workpiece workpiece(sheet, pattern);
  for (const ShortRelief& found : short_reliefs(workpiece, rules)) {
    if (!asks_for_cut(found.relief, found.limits)) continue;
    const ZoneCorner& corner = found.corner;
    const double narrow = rules.opening_to_edge_t * workpiece.thickness;
    const double web = found.on_both_sides ? 0.0 : web_behind(workpiece, found, narrow);
    missing.push_back({found.bend->id, corner.at, corner.beyond, corner.outward, found.limits.width,
                       std::max(found.limits.depth, 0.0), found.zone, web, found.on_both_sides});
  }
  return missing;
}

}  // namespace planish
