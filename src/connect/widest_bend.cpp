#include "chain_pair.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace planish::connect_detail {
namespace {

/// Runs of one side: the first edge lies in [first.low, first.high], the last in [last.low,
/// last.high]. Where first.high > last.low no edge is common to them all.
struct RunSet {
  struct Interval {
    int low = 0, high = 0;
    bool one() const { return low == high; }
  };
  Interval first, last;
  bool has_core() const { return first.high <= last.low; }
  bool one() const { return first.one() && last.one(); }
};

struct Node {
  std::array<RunSet, 2> sides;
  double widest = 0.0;  ///< no run of the node is wider
  double core = 0.0;    ///< span without shift of the edges common to all runs
  double slope = 0.0;   ///< at which that is
  double least_span = 0.0;
};
struct Narrower {
  bool operator()(const Node& a, const Node& b) const { return a.widest < b.widest; }
};

/// Best-first branch and bound. The span without its shift only grows with the runs, so that the
/// edges common to all runs of a node bound it from below; what shift and width cost together is
/// least at a corner of their ranges.
class Search {
 public:
  Search(const ChainPair& pair, const EdgeChoice& reference, double trade_off,
         const std::optional<EdgeChoice>& best)
      : pair_(pair), trade_off_(trade_off), best_(best), noise_(kEqualWidths * pair.size) {
    budget_ = reference.span - trade_off * reference.width + noise_;
    cost_ = {0.5 * pair.factor, 1.0, Vec2::Zero()};
  }

  std::optional<EdgeChoice> run() {
    Node root;
    for (int side = 0; side < 2; ++side) {
      const auto i = static_cast<std::size_t>(side);
      const int last = pair_.edge_count(side) - 1;
      root.sides[i] = {{0, last}, {0, last}};
      if (pair_.fixed[i])
        root.sides[i] = {{pair_.fixed[i]->first, pair_.fixed[i]->first},
                         {pair_.fixed[i]->second, pair_.fixed[i]->second}};
    }
    open(root, std::nullopt);
    while (!open_.empty()) {
      const Node node = open_.top();
      open_.pop();
      if (best_ && node.widest < best_->width - noise_) break;
      if (hopeless(node)) continue;
      if (node.sides[0].one() && node.sides[1].one())
        take(node);
      else
        split(node);
    }
    return found_ ? best_ : std::nullopt;
  }

 private:
  double left(int side, int edge) const { return pair_.x(side, edge); }
  double right(int side, int edge) const { return pair_.x(side, edge + 1); }

  // Least of |a − b| + weight·(sign of growth) over two ranges, where moving outward widens the
  // bend.
  struct Range {
    double low = 0.0, high = 0.0;
  };
  // Left ends: min |a − b| + w (a + b); right ends are mirrored.
  static double least_shift(const Range& a, const Range& b, double weight) {
    const auto at = [&](double p, double q) { return std::abs(p - q) + weight * (p + q); };
    const double follow_a = std::clamp(b.low, a.low, a.high),
                 follow_b = std::clamp(a.low, b.low, b.high);
    return std::min({at(a.low, b.low), at(follow_a, b.low), at(a.low, follow_b)});
  }

  Range left_range(const Node& node, int side) const {
    const RunSet& set = node.sides[side];
    return {left(side, set.first.low), left(side, set.first.high)};
  }
  Range mirrored_right_range(const Node& node, int side) const {
    const RunSet& set = node.sides[side];
    return {-right(side, set.last.high), -right(side, set.last.low)};
  }
  static double distance(const Range& a, const Range& b) {
    return std::max({0.0, a.low - b.high, b.low - a.high});
  }

  // Costs of the core, none where a side has no common edge: that side's own least.
  bool measure_core(Node& node, double start) const {
    std::array<CornerRange, 2> core;
    double apart = 0.0;
    for (int side = 0; side < 2; ++side) {
      const RunSet& set = node.sides[side];
      if (set.has_core())
        core[side] = pair_.corners(side, set.first.high, set.last.low);
      else
        apart += least_alone(side, set);
    }
    node.core = apart;
    node.slope = start;
    if (core[0].empty() && core[1].empty()) return true;
    const auto best = cheapest_tangent(core, pair_.kind, cost_, pair_.line, pair_.size, start);
    if (!best) return false;
    node.core = best->value + apart;
    node.slope = best->line.slope;
    return true;
  }

  // A side whose runs share no edge costs at least what its lowest corner does: ½Ψ̃ h + |y − h|.
  double least_alone(int side, const RunSet& set) const {
    double lowest = std::numeric_limits<double>::infinity();
    for (int c = set.first.low; c <= set.last.high + 1; ++c)
      lowest = std::min(lowest, pair_.sides[side]->corners[c].y());
    return (pair_.kind == EdgeKind::facing ? std::min(0.5 * pair_.factor, 1.0)
                                           : 0.5 * pair_.factor) *
           lowest;
  }

  void open(Node node, const std::optional<Node>& parent) {
    node.widest = 0.0;
    for (int side = 0; side < 2; ++side) {
      const RunSet& set = node.sides[side];
      node.widest += 0.5 * (right(side, set.last.high) - left(side, set.first.low));
    }
    if (best_ && node.widest < best_->width - noise_) return;
    const bool same_core = parent && same(parent->sides[0], node.sides[0]) &&
                           same(parent->sides[1], node.sides[1]);
    if (same_core) {
      node.core = parent->core;
      node.slope = parent->slope;
    } else if (!measure_core(node, parent ? parent->slope : 0.0)) {
      return;  // not even the common edges admit a tangent line
    }
    node.least_span = node.core + distance(left_range(node, 0), left_range(node, 1)) +
                      distance(mirrored_right_range(node, 0), mirrored_right_range(node, 1));
    if (!hopeless(node)) open_.push(node);
  }

  static bool same(const RunSet& a, const RunSet& b) {
    return a.has_core() && b.has_core() && a.first.high == b.first.high && a.last.low == b.last.low;
  }

  bool hopeless(const Node& node) const {
    const double weight = 0.5 * trade_off_;
    const double ends = least_shift(left_range(node, 0), left_range(node, 1), weight) +
                        least_shift(mirrored_right_range(node, 0), mirrored_right_range(node, 1),
                                    weight);
    if (node.core + ends > budget_) return true;
    // Of equally wide ones only a smaller span is wanted, or the same with smaller edge numbers.
    return best_ && node.widest <= best_->width + noise_ && node.least_span > best_->span + noise_;
  }

  void take(const Node& node) {
    const auto choice = measured(pair_,
                                 {std::pair{node.sides[0].first.low, node.sides[0].last.low},
                                  std::pair{node.sides[1].first.low, node.sides[1].last.low}},
                                 node.slope);
    if (!choice || choice->span - trade_off_ * choice->width > budget_) return;
    if (best_ && !better(pair_, *choice, *best_)) return;
    best_ = choice;
    found_ = true;
  }

  // Halves the widest range of the node's ends. Sides without a common edge are first divided into
  // runs that hold their middle edge and those to its left and right.
  void split(const Node& node) {
    for (int side = 0; side < 2; ++side)
      if (!node.sides[side].has_core()) return split_by_middle(node, side);
    int side = 0;
    bool first = true;
    double widest = -1.0;
    for (int s = 0; s < 2; ++s) {
      const RunSet& set = node.sides[s];
      if (const double w = left(s, set.first.high) - left(s, set.first.low);
          !set.first.one() && w > widest) {
        widest = w;
        side = s;
        first = true;
      }
      if (const double w = right(s, set.last.high) - right(s, set.last.low);
          !set.last.one() && w > widest) {
        widest = w;
        side = s;
        first = false;
      }
    }
    Node low = node, high = node;
    RunSet& a = low.sides[side];
    RunSet& b = high.sides[side];
    RunSet::Interval& range_a = first ? a.first : a.last;
    RunSet::Interval& range_b = first ? b.first : b.last;
    const int middle = (range_a.low + range_a.high) / 2;
    range_a.high = middle;
    range_b.low = middle + 1;
    open(low, node);
    open(high, node);
  }

  void split_by_middle(const Node& node, int side) {
    const RunSet& set = node.sides[side];
    const int low = set.first.low, high = set.last.high, middle = (low + high) / 2;
    const auto with = [&](const RunSet& runs) {
      Node child = node;
      child.sides[side] = runs;
      open(child, node);
    };
    with({{low, middle}, {middle, high}});
    if (low < middle) with({{low, middle - 1}, {low, middle - 1}});
    if (middle < high) with({{middle + 1, high}, {middle + 1, high}});
  }

  const ChainPair& pair_;
  double trade_off_;
  std::optional<EdgeChoice> best_;
  bool found_ = false;
  double noise_;
  double budget_ = 0.0;
  TangentCost cost_;
  std::priority_queue<Node, std::vector<Node>, Narrower> open_;
};

}  // namespace

std::optional<EdgeChoice> widest_bend(const ChainPair& pair, const EdgeChoice& reference,
                                      double trade_off, const std::optional<EdgeChoice>& best) {
  return Search(pair, reference, trade_off, best).run();
}

}  // namespace planish::connect_detail
