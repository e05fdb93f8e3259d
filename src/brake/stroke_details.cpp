#include "stroke_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace planish::brake_detail {
namespace {

constexpr double kDepthFound = 0.005;  // mm
constexpr double kDeepest = 1000.0;    // mm: beyond any tool

constexpr double kNewtons = 1000.0;  // in a kN
constexpr double kFarAway = 1000.0;  // mm: distances above are not told apart

/// Rows as the operator sees them: with the gauge behind the line, x runs to the right.
std::vector<SegmentRow> seen_rows(const std::vector<ToolRow>& rows, const Interval& line,
                                  bool from_left) {
  std::vector<SegmentRow> seen;
  for (const ToolRow& row : rows)
    seen.push_back(
        {from_left ? row.from - line.lo : line.hi - (row.from + row.length()), row.segments});
  if (from_left) return seen;
  std::ranges::reverse(seen);
  for (SegmentRow& row : seen)
    std::ranges::reverse(row.segments);
  return seen;
}

}  // namespace

std::optional<FlangeId> StrokeModel::flange_of(int line, int part) {
  const PartTree& tree = room(line).tree;
  const PartTree::Part& at = tree.parts()[part];
  if (!at.is_zone) return work_.bodies[at.index].flange;
  const auto& bodies = work_.lines[at.index].bodies;
  const int before = at.before >= 0 ? tree.parts()[at.before].index : bodies[0];
  const int beyond = bodies[bodies[0] == before ? 1 : 0];
  const auto flange = work_.bodies[beyond].flange;
  return flange ? flange : work_.bodies[before].flange;
}

Stroke StrokeModel::stroke(const LineSet& formed, const StrokeChoice& choice) {
  const Setting setting = this->setting(formed, choice);
  const BrakeLine& line = work_.lines[setting.line];
  const Die& die = tools_.dies[setting.die];
  Rows rows;
  Stroke stroke;
  const auto obstruction = line.closes ? cannot_close(setting, &rows) : obstructed(setting, &rows);
  double length = 0.0;
  for (int i = 0; i < std::ssize(work_.lines); ++i) {
    if (!holds(setting.pressed, i)) continue;
    const auto& bends = work_.lines[i].bends;
    stroke.bends.insert(stroke.bends.end(), bends.begin(), bends.end());
    length += work_.lines[i].length();
  }
  stroke.press_line = line.press_line;
  stroke.flattening = line.closes.has_value();
  stroke.angle = line.closes ? line.closed - line.angle : line.angle;
  stroke.punch = tools_.punches[setting.punch].id;
  stroke.die = die.id;
  const std::vector<Interval> pieces = pressed_pieces(setting);
  const Interval whole{pieces.front().lo, pieces.back().hi};
  stroke.punch_rows = seen_rows(rows.punch, whole, setting.direction > 0);
  stroke.die_rows = seen_rows(rows.die, whole, setting.direction > 0);
  stroke.reference_up = line.reference_up;
  stroke.gauge_direction = setting.direction * line.across();
  stroke.to_gauge = work_.bodies[line.bodies[setting.direction > 0 ? 1 : 0]].flange;
  if (choice.gauged && !line.closes) stroke.gauge = gauge(setting);
  stroke.force = length / kNewtons *
                 (line.closes
                      ? closing_force(options_.tensile_strength, work_.thickness)
                      : force_per_length(options_.tensile_strength, work_.thickness, die.opening));
  if (!line.closes && !obstruction) stroke.clearance = clearance(setting, rows);
  return stroke;
}

/// The least distance between tools and workpiece where it counts, over all turns. Punch and die
/// count as far as their rows reach.
double StrokeModel::clearance(const Setting& stroke, const Rows& rows) {
  double least = kFarAway;
  const PartTree& tree = room(stroke.line).tree;
  const PressMotion motion = this->motion(stroke);
  const double most = most_turn(stroke.line);
  for (int part = 0; part < std::ssize(tree.parts()); ++part) {
    const PlacedPart& placed = parts_in(stroke)[part]->placed;
    for (const ToolKind kind : kToolKinds) {
      const bool above = kind == ToolKind::punch || kind == ToolKind::upper_beam;
      const SidedObstacle body = room_of_tools_->body(
          kind, above ? stroke.punch : stroke.die, nearness(part, kind, stroke), stroke.direction);
      const Obstacle& obstacle = placed.left ? *body.left : *body.right;
      const std::vector<ToolRow>* row = kind == ToolKind::punch ? &rows.punch
                                        : kind == ToolKind::die ? &rows.die
                                                                : nullptr;
      const auto look = [&](const Block3& block, double lo, double hi) {
        const Convex cut = section(block, lo, hi);
        if (cut.empty()) return;
        const Moving moving = turned_with_side(motion, cut);
        least = std::min(least, closest(motion, moving, obstacle, most, least).distance);
      };
      for (const Block3& block : placed.blocks) {
        const Interval along = extent(block);
        if (!row) look(block, along.lo, along.hi);
        for (const ToolRow& tool : row ? *row : std::vector<ToolRow>()) {
          const double lo = std::max(along.lo, tool.from - least),
                       hi = std::min(along.hi, tool.from + tool.length() + least);
          if (lo > hi) continue;
          look(block, std::max(along.lo, tool.from), std::min(along.hi, tool.from + tool.length()));
        }
      }
    }
  }
  return least;
}

/// How deep the part that hits is in the tool at the worst turn, where the row has to stand.
/// Outside `told` it is only said on which side it is: at most its lower end, or at least its upper
/// one.
BlockedBend StrokeModel::deepest(const Setting& stroke, const Obstruction& obstruction,
                                 const Interval& told) {
  BlockedBend blocked{work_.lines[stroke.line].bends.front(), {}, {}, 0.0, {}, obstruction.why};
  if (obstruction.part >= 0) blocked.with = flange_of(stroke.line, obstruction.part);
  if (!obstruction.hits || obstruction.part < 0) return blocked;
  const ToolKind kind = *obstruction.hits;
  const bool above = kind == ToolKind::punch || kind == ToolKind::upper_beam;
  const int tool = above ? stroke.punch : stroke.die;
  const PlacedPart& placed = parts_in(stroke)[obstruction.part]->placed;
  const std::vector<Interval> pieces = pressed_pieces(stroke);
  Interval along = kEverywhere;
  if (kind == ToolKind::punch || kind == ToolKind::die)
    along = {pieces.front().lo + shortfall(), pieces.back().hi - shortfall()};
  const auto turn_deeper = [&](double depth) {
    const Obstacle& plain = room_of_tools_->deeper(kind, tool, depth);
    const Obstacle other = mirrored(plain);
    const bool same = stroke.direction > 0;
    return hit_within(motion(stroke), placed, same ? plain : other, same ? other : plain, along,
                      most_turn(stroke.line));
  };
  double lo = 0.0, hi = kPenetration;
  std::optional<double> turn;
  blocked.hits = room_of_tools_->name(kind, tool);
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
  if (turn) blocked.at_turn = Angle::radians(*turn);
  return blocked;
}

/// Of all parts that are in a tool the one that is deepest; one that is at least `most` deep will
/// do.
BlockedBend StrokeModel::deepest_of_all(const Setting& stroke, double most) {
  BlockedBend worst{work_.lines[stroke.line].bends.front(), {}, {}, 0.0, {}, {}};
  for (const Obstruction& obstruction : collisions(stroke)) {
    BlockedBend found = deepest(stroke, obstruction, {worst.depth, most});
    if (found.depth > worst.depth || worst.hits.empty()) worst = std::move(found);
    if (worst.depth >= most) break;
  }
  return worst;
}

BlockedBend StrokeModel::blocked(const LineSet& formed, int line, Clock::time_point until) {
  LineSet alone = no_lines(static_cast<int>(work_.lines.size()));
  insert(alone, line);
  return blocked_way(formed, alone, until).bend;
}

StrokeModel::BlockedWay StrokeModel::blocked_way(const LineSet& formed, const LineSet& pressed,
                                                 Clock::time_point until) {
  LineSet key = formed;
  key.insert(key.end(), pressed.begin(), pressed.end());
  const auto known = blocked_ways_.find(key);
  if (known != blocked_ways_.end()) return known->second;
  BlockedWay way = nearest_way(formed, pressed, until);
  if (Clock::now() <= until) blocked_ways_.emplace(std::move(key), way);
  return way;
}

/// Of all ways to make a stroke that cannot be made the one in which least is in the way.
StrokeModel::BlockedWay StrokeModel::nearest_way(const LineSet& formed, const LineSet& pressed,
                                                 Clock::time_point until) {
  const int line = members(pressed).front();
  const BrakeLine& first = work_.lines[line];
  const FittingTools& fitting = fitting_[line];
  const bool closes = first.closes.has_value();
  BlockedBend best{first.bends.front(), {}, {}, kDeepest, {}, fitting.why};
  Setting way{&formed, pressed, line, 0, 0, 1};
  for (const int punch : fitting.punches)
    for (const int die : fitting.dies)
      for (const int direction : {1, -1}) {
        if (Clock::now() > until && (!best.hits.empty() || !best.why.empty())) continue;
        const Setting stroke{&formed, pressed, line, punch, die, direction};
        auto obstruction = closes ? cannot_close(stroke, nullptr) : too_short(stroke);
        if (!obstruction && !closes) obstruction = obstructed(stroke, nullptr);
        if (!obstruction) continue;
        const double most = best.hits.empty() ? kDeepest : best.depth;
        BlockedBend found = obstruction->part >= 0 && obstruction->hits
                                ? deepest_of_all(stroke, most)
                                : deepest(stroke, *obstruction, {0.0, most});
        const bool collides = !found.hits.empty(), best_collides = !best.hits.empty();
        if (!collides && (best_collides || !best.why.empty())) continue;
        if (collides && best_collides && found.depth >= best.depth) continue;
        best = std::move(found);
        way = stroke;
      }
  if (best.hits.empty()) best.depth = 0.0;
  StrokeChoice choice{pressed, way.punch, way.die, first.reference_up};
  choice.direction = direction_number(way.direction * first.across());
  choice.gauged = closes || gauge(way).has_value();
  return {std::move(best), std::move(choice)};
}

}  // namespace planish::brake_detail
