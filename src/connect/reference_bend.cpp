#include "chain_pair.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

// The bend of least average length (math.md#shortest-bend) between single edges or given runs.
// Units are sorted by mean height, with which lengths grow: pairs are looked at until the bound for
// a pair of heights exceeds the best, and of the rest a hull of four corners bounds most. Only what
// is left is solved. Of equal lengths the wider counts, then the smaller span, then the smaller
// numbers, so the result does not hang on the order.

namespace planish::connect_detail {
namespace {

/// One edge, or the fixed run of a side.
struct Unit {
  int first = 0, last = 0;
  Vec2 left = Vec2::Zero(), right = Vec2::Zero(), mean = Vec2::Zero();
};

std::vector<Unit> units_of(const ChainPair& pair, int side) {
  std::vector<std::pair<int, int>> runs;
  if (pair.fixed[side])
    runs.push_back(*pair.fixed[side]);
  else
    for (int e = 0; e < pair.edge_count(side); ++e)
      runs.emplace_back(e, e);
  std::vector<Unit> units;
  for (const auto& [first, last] : runs) {
    const auto corner = pair.sides[side]->corners.begin() + first;
    const int count = last - first + 2;
    units.push_back({first, last, corner[0], corner[count - 1],
                     std::accumulate(corner, corner + count, Vec2(0.0, 0.0)) / count});
  }
  // Nearest first: lengths grow with the mean height.
  std::ranges::stable_sort(units, {}, [](const Unit& unit) { return unit.mean.y(); });
  return units;
}

double shift(const Unit& a, const Unit& b) {
  return std::abs(a.left.x() - b.left.x()) + std::abs(a.right.x() - b.right.x());
}

/// The objective of math.md#shortest-bend without the shift: of tangent lines (k, q), `of_height` ·
/// 2 H + `constant` where H = k x̄ − q is the height of the line over the mean x of all corners.
struct Length {
  double of_height = 0.0, constant = 0.0, mean_x = 0.0;

  Length(const ChainPair& pair, const Unit& a, const Unit& b)
      : mean_x(0.5 * (a.mean.x() + b.mean.x())) {
    const double sign = pair.kind == EdgeKind::facing ? 1.0 : -1.0;
    of_height = 0.5 * pair.factor - sign;
    constant = sign * (a.mean.y() + b.mean.y());
  }
};

std::optional<double> shortest(const ChainPair& pair, const Unit& a, const Unit& b, double start,
                               double& slope) {
  const Length length(pair, a, b);
  TangentCost cost;
  cost.linear = 2.0 * length.of_height * Vec2(length.mean_x, -1.0);
  const std::array<CornerRange, 2> sides{pair.corners(0, a.first, a.last),
                                         pair.corners(1, b.first, b.last)};
  const auto best = cheapest_tangent(sides, pair.kind, cost, pair.line, pair.size, start);
  if (!best) return std::nullopt;
  slope = best->line.slope;
  // Evaluated at the line itself: the program's value refers to another origin.
  return length.constant + cost.linear.dot(Vec2(best->line.slope, best->line.offset));
}

/// Facing: the greatest height at x of a line below the ends of both units; averted: the smallest
/// height of one above them. A hull of four corners.
double extreme_height(EdgeKind kind, const Unit& a, const Unit& b, double x) {
  const double sign = kind == EdgeKind::facing ? 1.0 : -1.0;
  const std::array<const Vec2*, 4> corners{&a.left, &a.right, &b.left, &b.right};
  double least = std::numeric_limits<double>::infinity();
  for (const Vec2* p : corners)
    for (const Vec2* q : corners) {
      if (p->x() > x || q->x() < x) continue;
      const double across = q->x() - p->x();
      const double share = across > 0.0 ? (x - p->x()) / across : 0.0;
      least = std::min(least, sign * (p->y() + share * (q->y() - p->y())));
    }
  return sign * least;
}

/// A lower bound for the length of a bend between the two, whatever else constrains its tangent
/// line; nearly always its length.
double least_length(const ChainPair& pair, const Unit& a, const Unit& b) {
  const Length length(pair, a, b);
  const double height = pair.kind == EdgeKind::facing && length.of_height >= 0.0
                            ? 0.0
                            : extreme_height(pair.kind, a, b, length.mean_x);
  return length.constant + 2.0 * length.of_height * height + shift(a, b);
}

/// The same for all pairs of these mean heights: the line is as near to the plates as it can be.
double least_length(const ChainPair& pair, double heights) {
  return (pair.kind == EdgeKind::facing ? std::min(0.5 * pair.factor, 1.0) : 0.5 * pair.factor) *
         heights;
}

}  // namespace

std::optional<ReferenceBend> reference_bend(const ChainPair& pair, double bound) {
  const std::vector<Unit> left = units_of(pair, 0), right = units_of(pair, 1);
  std::optional<ReferenceBend> best;
  const double noise = kEqualWidths * pair.size;
  double start = 0.0;
  for (const Unit& a : left) {
    if (least_length(pair, a.mean.y() + right.front().mean.y()) > bound + noise) break;
    for (const Unit& b : right) {
      if (least_length(pair, a.mean.y() + b.mean.y()) > bound + noise) break;
      if (least_length(pair, a, b) > bound + noise) continue;
      const auto straight = shortest(pair, a, b, start, start);
      if (!straight) continue;
      const double whole = *straight + shift(a, b);
      if (best ? whole >= best->length + noise : whole >= bound) continue;
      const auto choice = measured(pair, {std::pair{a.first, a.last}, std::pair{b.first, b.last}},
                                   start);
      if (!choice) continue;
      // Equal lengths: the wider, the smaller span, the smaller edge numbers.
      if (best && whole > best->length - noise && !better(pair, *choice, best->choice)) continue;
      best = ReferenceBend{*choice, std::min(whole, best ? best->length : whole)};
      bound = std::min(bound, whole);
    }
  }
  return best;
}

std::optional<EdgeChoice> measured(const ChainPair& pair,
                                   const std::array<std::pair<int, int>, 2>& runs, double start) {
  const std::array<CornerRange, 2> sides{pair.corners(0, runs[0].first, runs[0].second),
                                         pair.corners(1, runs[1].first, runs[1].second)};
  const TangentCost cost{0.5 * pair.factor, 1.0, Vec2::Zero()};
  const auto best = cheapest_tangent(sides, pair.kind, cost, pair.line, pair.size, start);
  if (!best) return std::nullopt;
  EdgeChoice choice;
  choice.kind = pair.kind;
  choice.line = best->line;
  choice.span = best->value + std::abs(sides[0].left() - sides[1].left()) +
                std::abs(sides[0].right() - sides[1].right());
  for (std::size_t i = 0; i < 2; ++i) {
    choice.runs[i] = {pair.chains[i], runs[i].first, runs[i].second};
    choice.width += 0.5 * (sides[i].right() - sides[i].left());
  }
  return choice;
}

bool better(const ChainPair& pair, const EdgeChoice& a, const EdgeChoice& b) {
  const double noise = kEqualWidths * pair.size;
  if (std::abs(a.width - b.width) > noise) return a.width > b.width;
  if (std::abs(a.span - b.span) > noise) return a.span < b.span;
  const auto rank = [](const EdgeChoice& c) {
    return std::array{c.runs[0].chain, c.runs[0].first, c.runs[0].last,
                      c.runs[1].chain, c.runs[1].first, c.runs[1].last};
  };
  return rank(a) < rank(b);
}

}  // namespace planish::connect_detail
