// Why a line cannot be pressed. Of all ways to press it the one counts in which least is in the
// way: of all parts that hit tools the deepest one, measured by how far the tool's section can be
// shrunk until it is clear, found by doubling and halving. What must hold: a tool shrunk more is
// hit less (math.md#bend-order).
#include "blocked_way.hpp"

#include "check.hpp"
#include "fits.hpp"
#include "gauge.hpp"
#include "one_line.hpp"
#include "plane_side.hpp"
#include "prepared.hpp"
#include "sentences.hpp"
#include "standing.hpp"
#include "sweep.hpp"

#include <planish/geometry/region.hpp>

#include <algorithm>
#include <limits>

namespace planish::brake_detail {
namespace {

constexpr double kDepthFound = 0.005;  // mm
constexpr double kDeepest = 1000.0;    // mm: beyond any tool
constexpr int kMostMeasured = 100;     // ways of one stroke, those over the wanted V first

/// The flange that a part belongs to, or of a zone the one behind it.
std::optional<FlangeId> flange_of(StageCache& cache, int line, int part) {
  const Workpiece& work = cache.inputs().work;
  const PartTree& tree = cache.tree(line);
  const PartTree::Part& at = tree.parts()[part];
  if (!at.is_zone) return work.bodies[at.index].flange;
  const auto& bodies = work.lines[at.index].bodies;
  const int before = at.before >= 0 ? tree.parts()[at.before].index : bodies[0];
  const int beyond = bodies[bodies[0] == before ? 1 : 0];
  const auto flange = work.bodies[beyond].flange;
  return flange ? flange : work.bodies[before].flange;
}

/// A section of a tool that counts, and where along x.
struct Counting {
  CrossSection of = CrossSection::whole;
  Interval along = kEverywhere;
};

/// Beams count everywhere, rows where they must press; of a row with ears the feet, and the body
/// between them.
std::vector<Counting> what_counts(StageCache& cache, const Setting& stroke, ToolKind kind) {
  if (!is_row(kind)) return {{}};
  const std::vector<Interval> pieces = pieces_to_press(cache, stroke);
  const double left_out = shortfall(cache.inputs());
  const Interval row{pieces.front().lo + left_out, pieces.back().hi - left_out};
  const RowEars ears = ears_of(cache.inputs(), stroke, kind);
  if (!ears.any()) return {{CrossSection::whole, row}};
  const Interval body = stood_back(row, ears);
  std::vector<Counting> counting{{CrossSection::foot, row}};
  if (body.lo < body.hi) counting.push_back({CrossSection::whole, body});
  return counting;
}

/// What would take a side that is too short for a die: the widest of the catalogue, or, where none
/// would, the widest V with the shoulders of this one.
struct TakingV {
  double opening = 0.0;  ///< 0: none
  const Die* die = nullptr;
};

TakingV taking(const StrokeInputs& inputs, int line, double is, const Die& refused) {
  TakingV taking;
  for (const Die& die : inputs.tools.dies)
    if (die.opening > taking.opening && die.opening < refused.opening &&
        is_sharp_for(inputs.work.lines[line], die, inputs.options) &&
        needed_side(inputs, line, die) <= is)
      taking = {die.opening, &die};
  if (taking.die) return taking;
  double narrow = 0.0, wide = refused.opening;
  while (wide - narrow > kDepthFound) {
    const double middle = 0.5 * (narrow + wide);
    (needed_side(inputs, line, refused, refused.opening - middle) <= is ? narrow : wide) = middle;
  }
  return {narrow, nullptr};
}

/// What a stroke lacks on a side, with what would help if that is known.
Remark remark_on(const StrokeInputs& inputs, int line, const Lack& lack, const Place& side,
                 const ToolName& tool, const Die& die) {
  Facts facts{{"tool", text_of(tool)}, {"is", lack.is, unit::mm}};
  switch (lack.kind) {
    case Lack::Kind::segments:
    case Lack::Kind::no_room:
      if (!lack.room) return remark_of(say::no_segments_fit, facts);
      facts.emplace_back("room", *lack.room, unit::mm);
      return remark_of(say::no_segments_in_room, facts);
    case Lack::Kind::bed:
      facts.emplace_back("most", lack.needs, unit::mm);
      return remark_of(say::bed_too_short, facts);
    case Lack::Kind::plane_sides:
      return remark_of(say::shoulders_touch_bend, facts);
    case Lack::Kind::room:
      return remark_of(say::beam_at_hem, {facts.front()});
    default:
      break;
  }
  facts.emplace_back("side", side);
  facts.emplace_back("needed", lack.needs, unit::mm);
  const TakingV taken = taking(inputs, line, lack.is, die);
  if (taken.opening <= 0.0) return remark_of(say::short_of_any, facts);
  const double force = force_per_length(inputs.options.tensile_strength, inputs.work.thickness,
                                        taken.opening);
  const bool usual = taken.opening >= narrowest_opening(inputs.work.thickness);
  if (usual && taken.die && taken.die->max_force && *taken.die->max_force < force) {
    facts.emplace_back("other", text_of({ToolKind::die, taken.die->id}));
    facts.emplace_back("most", *taken.die->max_force, say::kPerMetre);
    facts.emplace_back("force", force, say::kPerMetre);
    return remark_of(say::short_of_strong, facts);
  }
  facts.emplace_back("opening", taken.opening, unit::mm);
  return remark_of(usual ? say::short_side : say::short_of_usual, facts);
}

/// Whether a part has no corner in the tool that it hits, and so comes out on the other side.
bool goes_through(const PressMotion& motion, const PlacedPart& part, double turn,
                  const Obstacle& tool) {
  return std::ranges::none_of(part.sections, [&](const Convex& section) {
    return std::ranges::any_of(turned_with_side(motion, section).at(turn), [&](const Vec2& p) {
      return std::ranges::any_of(tool.pieces,
                                 [&](const Convex& piece) { return inside({piece}, p); });
    });
  });
}

/// How deep the part that hits is in the tool at the worst turn, where the row has to stand.
/// Outside `told` it is only said on which side it is: at most its lower end, or at least its upper
/// one.
BlockedBend deepest(StageCache& cache, const Setting& stroke, const Obstruction& obstruction,
                    const Interval& told) {
  const StrokeInputs& inputs = cache.inputs();
  const ToolKind kind = obstruction.tool;
  const int tool = tool_of(kind, stroke);
  const ToolName name = cache.tools().name(kind, tool);
  BlockedBend blocked{inputs.work.lines[stroke.line].bends.front()};
  if (obstruction.part >= 0) blocked.with = flange_of(cache, stroke.line, obstruction.part);
  if (obstruction.lack.kind != Lack::Kind::nothing) {
    const Place side = blocked.with ? place::flange(index_of(*blocked.with) + 1)
                                    : place::bend(name_of(blocked.bend));
    blocked.why = remark_on(inputs, stroke.line, obstruction.lack, side, name,
                            inputs.tools.dies[stroke.die]);
    if (obstruction.lack.kind == Lack::Kind::reach) {
      blocked.reach = obstruction.lack.is;
      blocked.needed = obstruction.lack.needs;
    }
    return blocked;
  }
  const PlacedPart& placed = *cache.parts(stroke)[obstruction.part];
  const std::vector<Counting> counting = what_counts(cache, stroke, kind);
  const auto turn_deeper = [&](double depth) {
    std::optional<double> turn;
    for (const auto& [of, along] : counting) {
      const Obstacle& plain = cache.tools().deeper(kind, tool, depth, of);
      const Obstacle other = mirrored(plain);
      const bool same = stroke.direction > 0;
      if (!turn)
        turn = hit_within(motion_at(inputs, stroke, kind), placed, same ? plain : other,
                          same ? other : plain, along, most_turn(inputs, stroke.line));
    }
    return turn;
  };
  double lo = 0.0, hi = kPenetration;
  std::optional<double> turn;
  blocked.hits = name;
  // Most ways are told apart from the best one by a single look.
  if (told.hi < kDeepest && turn_deeper(told.hi)) {
    blocked.depth = told.hi;
    return blocked;
  }
  if (told.lo > 0.0 && !turn_deeper(told.lo)) return blocked;
  while (hi < kDeepest) {
    const auto deeper = turn_deeper(hi);
    if (!deeper) break;
    turn = deeper;
    lo = hi;
    hi *= 2.0;
  }
  while (hi - lo > kDepthFound) {
    const double middle = 0.5 * (lo + hi);
    if (const auto deeper = turn_deeper(middle)) {
      turn = deeper;
      lo = middle;
    } else {
      hi = middle;
    }
  }
  blocked.depth = lo;
  if (!turn) return blocked;
  const Obstacle& whole = cache.tools().deeper(kind, tool, 0.0, counting.front().of);
  blocked.through = goes_through(motion_at(inputs, stroke, kind), placed, *turn,
                                 placed.left == (stroke.direction > 0) ? whole : mirrored(whole));
  blocked.at_turn = Angle::radians(*turn);
  return blocked;
}

/// Of all parts that are in a tool the one that is deepest; one that is at least `most` deep will
/// do.
BlockedBend deepest_of_all(StageCache& cache, const Setting& stroke, double most) {
  BlockedBend worst{cache.inputs().work.lines[stroke.line].bends.front()};
  for (const Obstruction& obstruction : collisions(cache, stroke)) {
    BlockedBend found = deepest(cache, stroke, obstruction, {worst.depth, most});
    if (found.depth > worst.depth || !worst.hits) worst = std::move(found);
    if (worst.depth >= most) break;
  }
  return worst;
}

/// What tells most why a line cannot be pressed: a narrower V cures a short side, so where that one
/// fails otherwise it is told why.
enum class Telling { short_side, lack, hit };

Telling telling_of(const Lack& lack) {
  if (lack.kind == Lack::Kind::nothing) return Telling::hit;
  return lack.kind == Lack::Kind::reach ? Telling::short_side : Telling::lack;
}

/// With all tools that fit and from both sides.
std::vector<Setting> ways_to_press(const StrokeInputs& inputs, const LineSet& formed,
                                   const LineSet& pressed) {
  const int line = members(pressed).front();
  std::vector<Setting> ways;
  for (const ToolPair& pair : inputs.fitting[line].pairs)
    for (const int direction : {1, -1})
      ways.push_back({&formed, pressed, line, pair.punch, pair.die, direction});
  return ways;
}

/// A way as it is told why it fails. Where ears find no place in what stands beside the line, it is
/// told what a punch without them would hit.
Setting told_of(StageCache& cache, const Setting& stroke, Obstruction& obstruction) {
  Setting plain = stroke;
  plain.ears = false;
  if (obstruction.lack.kind != Lack::Kind::no_room ||
      !ears_of(cache.inputs(), stroke, obstruction.tool).any())
    return stroke;
  const auto hits = collisions(cache, plain);
  if (hits.empty()) return stroke;
  obstruction = hits.front();
  return plain;
}

/// Of all ways to make a stroke that cannot be made the one in which least is in the way.
BlockedWay nearest_way(StageCache& cache, const LineSet& formed, const LineSet& pressed,
                       Clock::time_point until) {
  const StrokeInputs& inputs = cache.inputs();
  const int line = members(pressed).front();
  const BrakeLine& first = inputs.work.lines[line];
  BlockedBend best{first.bends.front(), {}, {}, kDeepest, {}, inputs.fitting[line].why};
  Setting way{&formed, pressed, line, 0, 0, 1};
  std::optional<Telling> told;
  double missing = 0.0;  // by what is told: the first, or of short sides the least
  int measured = 0;
  for (Setting stroke : ways_to_press(inputs, formed, pressed)) {
    const bool enough = measured >= kMostMeasured || Clock::now() > until;
    if (enough && (best.hits || best.why)) continue;
    auto obstruction = obstruction_of(cache, stroke);
    if (!obstruction) continue;
    stroke = told_of(cache, stroke, *obstruction);
    const Lack& lack = obstruction->lack;
    const Telling telling = telling_of(lack);
    const double lacks = lack.needs - lack.is;
    const bool no_more = telling != Telling::hit && lacks >= missing;
    if (told && (telling < *told || (telling == *told && no_more))) continue;
    measured += telling == Telling::short_side ? 0 : 1;
    const double most = best.hits ? best.depth : kDeepest;
    const bool hits = telling == Telling::hit;
    BlockedBend found = hits ? deepest_of_all(cache, stroke, most)
                             : deepest(cache, stroke, *obstruction, {0.0, most});
    if (hits && (!found.hits || (best.hits && found.depth >= best.depth))) continue;
    told = telling;
    missing = lacks;
    best = std::move(found);
    way = stroke;
  }
  if (!best.hits) best.depth = 0.0;
  StrokeChoice choice{pressed, way.punch, way.die, first.reference_up};
  choice.direction = direction_number(inputs, way.direction * first.across());
  choice.gauged = first.closes || is_gauged(cache, way);
  return {std::move(best), std::move(choice)};
}

}  // namespace

BlockedWay blocked_way(StageCache& cache, const LineSet& formed, const LineSet& pressed,
                       Clock::time_point until) {
  LineSet key = formed;
  key.insert(key.end(), pressed.begin(), pressed.end());
  if (const BlockedWay* known = cache.blocked_way(key)) return *known;
  BlockedWay way = nearest_way(cache, formed, pressed, until);
  if (Clock::now() <= until) cache.keep(std::move(key), way);
  return way;
}

BlockedBend blocked(StageCache& cache, const LineSet& formed, int line, Clock::time_point until) {
  return blocked_way(cache, formed, only(cache.inputs().lines(), line), until).bend;
}

}  // namespace planish::brake_detail
