#include "chain_pair.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace planish::connect_detail {
namespace {

/// One edge, or the fixed run of a side.
struct Unit {
  int first = 0, last = 0;
  double left = 0.0, right = 0.0, mean_x = 0.0, mean_y = 0.0;
};

std::vector<Unit> units_of(const ChainPair& pair, int side) {
  const auto i = static_cast<std::size_t>(side);
  std::vector<std::pair<int, int>> runs;
  if (pair.fixed[i])
    runs.push_back(*pair.fixed[i]);
  else
    for (int e = 0; e < pair.edge_count(side); ++e)
      runs.emplace_back(e, e);
  std::vector<Unit> units;
  for (const auto& [first, last] : runs) {
    Unit unit{first, last, pair.x(side, first), pair.x(side, last + 1), 0.0, 0.0};
    for (int c = first; c <= last + 1; ++c) {
      unit.mean_x += pair.sides[i]->corners[static_cast<std::size_t>(c)].x();
      unit.mean_y += pair.sides[i]->corners[static_cast<std::size_t>(c)].y();
    }
    unit.mean_x /= last - first + 2;
    unit.mean_y /= last - first + 2;
    units.push_back(unit);
  }
  // Near ones first: lengths grow with the mean height.
  std::stable_sort(units.begin(), units.end(), [](const Unit& a, const Unit& b) { return a.mean_y < b.mean_y; });
  return units;
}

double shift(const Unit& a, const Unit& b) { return std::abs(a.left - b.left) + std::abs(a.right - b.right); }

/// The objective of MATH 3.6 without the shift, minimised over the tangent lines.
std::optional<double> length(const ChainPair& pair, const Unit& a, const Unit& b, double start, double& slope) {
  // Means of k x − q are linear in (k, q); those of y are constants.
  const double weight = pair.kind == EdgeKind::facing ? 0.5 * pair.factor - 1.0 : 0.5 * pair.factor + 1.0;
  const double constant = pair.kind == EdgeKind::facing ? a.mean_y + b.mean_y : -(a.mean_y + b.mean_y);
  TangentCost cost;
  cost.linear = weight * Vec2(a.mean_x + b.mean_x, -2.0);
  const std::array<CornerRange, 2> sides{pair.corners(0, a.first, a.last), pair.corners(1, b.first, b.last)};
  const auto best = cheapest_tangent(sides, pair.kind, cost, pair.line, pair.size, start);
  if (!best) return std::nullopt;
  slope = best->line.slope;
  // Evaluated at the line itself: the program's value is about another origin.
  return constant + cost.linear.dot(Vec2(best->line.slope, best->line.offset));
}

/// Below this no pair of these mean heights can be: the line is as near to the plates as it can be.
double least_length(const ChainPair& pair, double heights) {
  return (pair.kind == EdgeKind::facing ? std::min(0.5 * pair.factor, 1.0) : 0.5 * pair.factor) * heights;
}

}  // namespace

std::optional<ReferenceBend> reference_bend(const ChainPair& pair, double bound) {
  const std::vector<Unit> left = units_of(pair, 0), right = units_of(pair, 1);
  std::optional<ReferenceBend> best;
  const double noise = kEqualWidths * pair.size;
  double start = 0.0;
  for (const Unit& a : left) {
    if (least_length(pair, a.mean_y + right.front().mean_y) > bound + noise) break;
    for (const Unit& b : right) {
      const double least = least_length(pair, a.mean_y + b.mean_y);
      if (least > bound + noise) break;
      if (least + shift(a, b) > bound + noise) continue;
      const auto straight = length(pair, a, b, start, start);
      if (!straight) continue;
      const double whole = *straight + shift(a, b);
      if (best ? whole >= best->length + noise : whole >= bound) continue;
      const auto choice = measured(pair, {std::pair{a.first, a.last}, std::pair{b.first, b.last}}, start);
      if (!choice) continue;
      // Equal lengths: the wider, the smaller span, the smaller edge numbers.
      if (best && whole > best->length - noise && !better(pair, *choice, best->choice)) continue;
      best = ReferenceBend{*choice, std::min(whole, best ? best->length : whole)};
      bound = std::min(bound, whole);
    }
  }
  return best;
}

std::optional<EdgeChoice> measured(const ChainPair& pair, const std::array<std::pair<int, int>, 2>& runs,
                                   double start) {
  const std::array<CornerRange, 2> sides{pair.corners(0, runs[0].first, runs[0].second),
                                         pair.corners(1, runs[1].first, runs[1].second)};
  const TangentCost cost{0.5 * pair.factor, 1.0, Vec2::Zero()};
  const auto best = cheapest_tangent(sides, pair.kind, cost, pair.line, pair.size, start);
  if (!best) return std::nullopt;
  EdgeChoice choice;
  choice.kind = pair.kind;
  choice.line = best->line;
  choice.span = best->value + std::abs(sides[0].left() - sides[1].left()) + std::abs(sides[0].right() - sides[1].right());
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
    return std::array{c.runs[0].chain, c.runs[0].first, c.runs[0].last, c.runs[1].chain, c.runs[1].first, c.runs[1].last};
  };
  return rank(a) < rank(b);
}

}  // namespace planish::connect_detail
