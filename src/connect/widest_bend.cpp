#include "chain_pair.hpp"

#include <planish/base/search.hpp>
#include <planish/geometry/interval.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

// Best-first branch and bound. The span without its shift only grows with the runs, so the edges
// common to all runs of a node bound it from below; the combined cost of shift and width is least
// at a corner of their ranges.

namespace planish::connect_detail {
namespace {

/// Runs of one side: the first edge lies in [first.low, first.high], the last in [last.low,
/// last.high]. Where first.high > last.low they have no edge in common.
struct RunSet {
  struct Interval {
    int low = 0, high = 0;
    bool one() const { return low == high; }
  };
  Interval first, last;
  bool has_core() const { return first.high <= last.low; }
  bool one() const { return first.one() && last.one(); }
};
using RunSets = std::array<RunSet, 2>;

struct WidthProblem {
  const ChainPair& pair;
  double trade_off = 1.0;
  double noise = 0.0;   ///< mm: differences below it are rounding
  double budget = 0.0;  ///< upper bound of span − γ · width

  double left(int side, int edge) const { return pair.x(side, edge); }
  double right(int side, int edge) const { return pair.x(side, edge + 1); }
};

/// The span, without its shift, of the edges common to all runs, and the slope of that line.
struct Core {
  double span = 0.0;
  double slope = 0.0;
};

struct Node {
  RunSets sides;
  double widest = 0.0;  ///< width of its widest runs
  Core core;
  double least_span = 0.0;
};
struct Narrower {
  bool operator()(const Node& a, const Node& b) const { return a.widest < b.widest; }
};
struct Longer {
  bool operator()(const Node& a, const Node& b) const { return a.least_span > b.least_span; }
};

planish::Interval left_range(const WidthProblem& problem, const RunSets& sides, int side) {
  const RunSet& set = sides[side];
  return {problem.left(side, set.first.low), problem.left(side, set.first.high)};
}

planish::Interval mirrored_right_range(const WidthProblem& problem, const RunSets& sides,
                                       int side) {
  const RunSet& set = sides[side];
  return {-problem.right(side, set.last.high), -problem.right(side, set.last.low)};
}

// The shift of the left ends plus the cost of the width that they give up: the least of
// |a − b| + w (a + b) over both ranges. Right ends are mirrored.
double least_shift(const planish::Interval& a, const planish::Interval& b, double weight) {
  const auto at = [&](double p, double q) { return std::abs(p - q) + weight * (p + q); };
  const double follow_a = std::clamp(b.lo, a.lo, a.hi), follow_b = std::clamp(a.lo, b.lo, b.hi);
  return std::min({at(a.lo, b.lo), at(follow_a, b.lo), at(a.lo, follow_b)});
}

// A side whose runs share no edge costs at least what its lowest corner does: ½Ψ̃ h + |y − h|.
double least_alone(const ChainPair& pair, int side, const RunSet& set) {
  double lowest = std::numeric_limits<double>::infinity();
  for (int c = set.first.low; c <= set.last.high + 1; ++c)
    lowest = std::min(lowest, pair.sides[side]->corners[c].y());
  const double share = pair.kind == EdgeKind::facing ? std::min(0.5 * pair.factor, 1.0)
                                                     : 0.5 * pair.factor;
  return share * lowest;
}

/// Empty if not even the common edges admit a tangent line.
std::optional<Core> core_of(const ChainPair& pair, const RunSets& sides, double start) {
  std::array<CornerRange, 2> common;
  double apart = 0.0;
  for (int side = 0; side < 2; ++side) {
    const RunSet& set = sides[side];
    if (set.has_core())
      common[side] = pair.corners(side, set.first.high, set.last.low);
    else
      apart += least_alone(pair, side, set);
  }
  if (common[0].empty() && common[1].empty()) return Core{apart, start};
  const TangentCost cost{0.5 * pair.factor, 1.0, Vec2::Zero()};
  const auto best = cheapest_tangent(common, pair.kind, cost, pair.line, pair.size, start);
  if (!best) return std::nullopt;
  return Core{best->value + apart, best->line.slope};
}

bool same_core(const RunSet& a, const RunSet& b) {
  return a.has_core() && b.has_core() && a.first.high == b.first.high && a.last.low == b.last.low;
}

bool hopeless(const WidthProblem& problem, const Node& node,
              const std::optional<EdgeChoice>& best) {
  const double weight = 0.5 * problem.trade_off;
  const RunSets& sides = node.sides;
  const double ends = least_shift(left_range(problem, sides, 0), left_range(problem, sides, 1),
                                  weight) +
                      least_shift(mirrored_right_range(problem, sides, 0),
                                  mirrored_right_range(problem, sides, 1), weight);
  if (node.core.span + ends > problem.budget) return true;
  // Of equally wide ones only a smaller span is wanted, or the same with smaller edge numbers.
  return best && node.widest <= best->width + problem.noise &&
         node.least_span > best->span + problem.noise;
}

/// The node of these runs; empty if it cannot contain anything better than `best`.
std::optional<Node> opened(const WidthProblem& problem, const RunSets& sides, const Node* parent,
                           const std::optional<EdgeChoice>& best) {
  Node node{sides, 0.0, {}, 0.0};
  for (int side = 0; side < 2; ++side)
    node.widest += 0.5 * (problem.right(side, sides[side].last.high) -
                          problem.left(side, sides[side].first.low));
  if (best && node.widest < best->width - problem.noise) return std::nullopt;
  if (parent && same_core(parent->sides[0], sides[0]) && same_core(parent->sides[1], sides[1])) {
    node.core = parent->core;
  } else {
    const auto core = core_of(problem.pair, sides, parent ? parent->core.slope : 0.0);
    if (!core) return std::nullopt;
    node.core = *core;
  }
  node.least_span = node.core.span +
                    distance(left_range(problem, sides, 0), left_range(problem, sides, 1)) +
                    distance(mirrored_right_range(problem, sides, 0),
                             mirrored_right_range(problem, sides, 1));
  if (hopeless(problem, node, best)) return std::nullopt;
  return node;
}

/// The only runs of a node, if they fit and are better than `best`.
std::optional<EdgeChoice> taken(const WidthProblem& problem, const Node& node,
                                const std::optional<EdgeChoice>& best) {
  const auto choice = measured(problem.pair,
                               {std::pair{node.sides[0].first.low, node.sides[0].last.low},
                                std::pair{node.sides[1].first.low, node.sides[1].last.low}},
                               node.core.slope);
  if (!choice || choice->span - problem.trade_off * choice->width > problem.budget)
    return std::nullopt;
  if (best && !better(problem.pair, *choice, *best)) return std::nullopt;
  return choice;
}

// Runs that hold the middle edge of all, those to its left and those to its right.
std::vector<RunSets> by_middle(const RunSets& sides, int side) {
  const int low = sides[side].first.low, high = sides[side].last.high, middle = (low + high) / 2;
  std::vector<RunSets> parts;
  const auto add = [&](const RunSet& runs) { parts.emplace_back(sides)[side] = runs; };
  add({{low, middle}, {middle, high}});
  if (low < middle) add({{low, middle - 1}, {low, middle - 1}});
  if (middle < high) add({{middle + 1, high}, {middle + 1, high}});
  return parts;
}

/// Divides runs without a common edge on one side by their middle edge, others where their ends are
/// spread most.
std::vector<RunSets> divided(const WidthProblem& problem, const RunSets& sides) {
  for (int side = 0; side < 2; ++side)
    if (!sides[side].has_core()) return by_middle(sides, side);
  int side = 0;
  RunSet::Interval RunSet::*end = &RunSet::first;
  double widest = -1.0;
  const auto consider = [&](int s, RunSet::Interval RunSet::*which, double width) {
    if ((sides[s].*which).one() || width <= widest) return;
    widest = width;
    side = s;
    end = which;
  };
  for (int s = 0; s < 2; ++s) {
    const RunSet& set = sides[s];
    consider(s, &RunSet::first, problem.left(s, set.first.high) - problem.left(s, set.first.low));
    consider(s, &RunSet::last, problem.right(s, set.last.high) - problem.right(s, set.last.low));
  }
  std::vector<RunSets> halves{sides, sides};
  const RunSet::Interval whole = sides[side].*end;
  const int middle = (whole.low + whole.high) / 2;
  (halves[0][side].*end).high = middle;
  (halves[1][side].*end).low = middle + 1;
  return halves;
}

RunSets all_runs(const ChainPair& pair) {
  RunSets sides;
  for (int side = 0; side < 2; ++side) {
    const int last = pair.edge_count(side) - 1;
    sides[side] = {{0, last}, {0, last}};
    if (const auto& fixed = pair.fixed[side])
      sides[side] = {{fixed->first, fixed->first}, {fixed->second, fixed->second}};
  }
  return sides;
}

}  // namespace

std::optional<EdgeChoice> widest_bend(const ChainPair& pair, const EdgeChoice& reference,
                                      double trade_off, const std::optional<EdgeChoice>& best) {
  const double noise = kEqualWidths * pair.size;
  const WidthProblem problem{pair, trade_off, noise,
                             reference.span - trade_off * reference.width + noise};
  std::optional<EdgeChoice> known = best;
  bool found = false;
  Frontier<Node, Narrower> open;
  const auto add = [&](const RunSets& sides, const Node* parent) {
    if (const auto node = opened(problem, sides, parent, known)) open.add(*node);
  };
  add(all_runs(pair), nullptr);
  while (!open.empty()) {
    const Node node = open.take();
    if (known && node.widest < known->width - noise) break;
    if (hopeless(problem, node, known)) continue;
    if (node.sides[0].one() && node.sides[1].one()) {
      if (const auto choice = taken(problem, node, known)) {
        known = choice;
        found = true;
      }
      continue;
    }
    for (const RunSets& part : divided(problem, node.sides))
      add(part, &node);
  }
  return found ? known : std::nullopt;
}

std::optional<EdgeChoice> least_span(const ChainPair& pair, const std::optional<EdgeChoice>& best) {
  const double noise = kEqualWidths * pair.size;
  WidthProblem problem{pair, 0.0, noise, std::numeric_limits<double>::infinity()};
  std::optional<EdgeChoice> found;
  const auto shorter_than = [&](const EdgeChoice& choice) { problem.budget = choice.span - noise; };
  if (best) shorter_than(*best);
  Frontier<Node, Longer> open;
  const auto add = [&](const RunSets& sides, const Node* parent) {
    if (const auto node = opened(problem, sides, parent, std::nullopt)) open.add(*node);
  };
  add(all_runs(pair), nullptr);
  while (!open.empty()) {
    const Node node = open.take();
    if (node.least_span > problem.budget) break;
    if (node.sides[0].one() && node.sides[1].one()) {
      if (auto choice = taken(problem, node, std::nullopt)) shorter_than(*(found = choice));
      continue;
    }
    for (const RunSets& part : divided(problem, node.sides))
      add(part, &node);
  }
  return found;
}

}  // namespace planish::connect_detail
