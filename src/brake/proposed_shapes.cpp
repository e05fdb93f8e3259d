// Parts that could be bent. The least change is found by doubling and halving, which takes for
// granted that more of it helps no less, until it does harm elsewhere (bend.md#proposals).
#include "proposed_shapes.hpp"

#include "obstruction.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace planish::brake_detail {
namespace {

using Kind = Proposal::Kind;

constexpr double kFinest = 0.1;        // mm: to which a flange is told
constexpr double kMostOfFlange = 0.5;  // by which one may be shorter: else it is another part
constexpr double kMostOfWeb = 10.0;    // thicknesses by which one may be wider

bool resizes(Trying& trying, const ChangedBody& one, Kind kind) {
  const auto [body, near] = one;
  const double most = kind == Kind::shorter_flange
                          ? kMostOfFlange * most_shorter(trying.work(), body, near)
                          : kMostOfWeb * trying.work().thickness;
  const auto steps = static_cast<int>(most / kFinest);
  const auto does = [&](int step) {
    const double by = step * kFinest;
    return trying.can_bend(kind == Kind::shorter_flange ? shortened(trying.work(), body, near, by)
                                                        : widened(trying.work(), one, by));
  };
  if (steps < 1 || !trying.work().bodies[body].flange) return false;
  // Too much makes it shorter than the die needs.
  int little = 0, enough = 0;
  for (int step = 10; enough == 0 && little < steps; step *= 2) {
    step = std::min(step, steps);
    (does(step) ? enough : little) = step;
  }
  if (enough == 0) return false;
  while (enough - little > 1) {
    const int middle = (little + enough) / 2;
    (does(middle) ? enough : little) = middle;
  }
  trying.propose(
      {.kind = kind, .by = enough * kFinest, .flanges = {*trying.work().bodies[body].flange}});
  return true;
}

/// A body that ends too near to a line for its die, seen from there.
struct ShortSide {
  int line = 0;
  double reach = 0.0, lacks = 0.0;
};

/// Those that are in the way when each told before is longer `by`; false if there are none.
bool add_short_sides(const Trying& trying, const std::vector<BlockedBend>& blocked, double by,
                     std::map<int, ShortSide>& sides) {
  bool any = false;
  for (const BlockedBend& one : blocked) {
    const int body = one.with ? trying.body_of(*one.with) : -1, line = trying.line_of(one.bend);
    if (one.needed <= one.reach || body < 0 || line < 0) continue;
    const double lacks = kFinest * std::ceil((one.needed - one.reach) / kFinest);
    const bool is_new = sides.try_emplace(body, ShortSide{line, one.reach, 0.0}).second;
    sides[body].lacks = std::max(sides[body].lacks, is_new ? lacks : by + lacks);
    any = true;
  }
  return any;
}

}  // namespace

/// The flange that hits, one on the way from it to the bend, or another: with another tool it is
/// another that hits.
void try_shorter(Trying& trying) {
  std::set<ChangedBody> tried;
  for (const BlockedBend& hit : trying.hits()) {
    if (!hit.with) continue;
    const int line = trying.line_of(hit.bend), body = trying.body_of(*hit.with);
    if (line < 0 || body < 0) continue;
    for (const ChangedBody& one : bodies_to_change(trying.work(), body, line))
      if (tried.insert(one).second && resizes(trying, one, Kind::shorter_flange)) return;
  }
}

/// The web of a narrow Z.
void try_wider(Trying& trying) {
  if (trying.has(Kind::longer_flanges)) return;
  for (const BlockedBend& one : trying.blocked()) {
    const int line = trying.line_of(one.bend);
    if (line < 0 || (one.hits && is_above(one.hits->kind))) continue;
    for (const int side : trying.work().lines[line].bodies)
      if (is_web(trying.work(), {side, line}) &&
          resizes(trying, {side, line}, Kind::longer_flanges))
        return;
  }
}

/// All that end too near to a bend for its die, each by what the shortest of them lacks. Behind a
/// side that is long enough another may show that is not.
void try_longer(Trying& trying) {
  constexpr int kMostRounds = 4;
  std::map<int, ShortSide> sides;  // by body
  double by = 0.0;
  std::vector<BlockedBend> blocked = trying.blocked();
  for (int round = 0; round < kMostRounds && add_short_sides(trying, blocked, by, sides); ++round) {
    for (const auto& [body, side] : sides)
      by = std::max(by, side.lacks);
    Workpiece work = trying.work();
    Proposal proposal{.kind = Kind::longer_flanges, .by = by};
    for (const auto& [body, side] : sides) {
      if (!can_lengthen(work, body, side.line)) return;
      work = lengthened(work, body, side.line, side.reach, by);
      proposal.flanges.push_back(*trying.work().bodies[body].flange);
    }
    if (!trying.can_bend(std::move(work), trying.tools(), trying.options(), &blocked)) continue;
    trying.propose(std::move(proposal));
    return;
  }
}

void try_split(Trying& trying) {
  if (trying.work().lines.size() < 2) return;  // two plates are no plan
  std::vector<int> lines;
  const auto add = [&](BendId bend) {
    const int line = trying.line_of(bend);
    if (line >= 0 && !std::ranges::count(lines, line)) lines.push_back(line);
  };
  for (const BlockedBend& one : trying.plan().blocked)
    add(one.bend);
  for (const BendId bend : trying.plan().unformed)
    add(bend);
  for (const BendId bend : trying.sheet().bends.ids())
    add(bend);
  for (const int line : lines) {
    if (trying.work().lines[line].press_line) continue;
    const auto halves = split_at(trying.work(), line);
    const bool both = std::ranges::all_of(
        halves, [&](const Workpiece& half) { return half.lines.empty() || trying.can_bend(half); });
    if (!both) continue;
    trying.propose({.kind = Kind::split, .bends = trying.work().lines[line].bends});
    return;
  }
}

}  // namespace planish::brake_detail
