// Whether a station makes a stroke. Rows press a line where each of its pieces lies within one of
// them, and stand clear of what is beside it; the few places where a line just does so, at an end
// of a row or at a wall, bound the ranges where it may lie (math.md#stations).
#include "station.hpp"

#include "closing.hpp"
#include "one_line.hpp"

#include <algorithm>

namespace planish::brake_detail {
namespace {

/// A range of x as the operator sees it.
Interval seen(const Demand& demand, const Interval& range) {
  const Interval& line = demand.line;
  return demand.from_left ? Interval{range.lo - line.lo, range.hi - line.lo}
                          : Interval{line.hi - range.hi, line.hi - range.lo};
}

std::vector<Interval> seen(const Demand& demand, const std::vector<Interval>& ranges) {
  auto all = mapped(ranges, [&](const Interval& range) { return seen(demand, range); });
  if (!demand.from_left) std::ranges::reverse(all);
  return all;
}

}  // namespace

Demand demand_of(StageCache& cache, const ChosenStroke& chosen, int number) {
  const Setting stroke = setting(cache.inputs(), chosen.formed, chosen.choice);
  const std::vector<Interval> pieces = pressed_pieces(cache, stroke);
  const Surroundings around = surroundings(cache, stroke);
  Demand demand{number, chosen.choice};
  demand.line = {pieces.front().lo, pieces.back().hi};
  demand.from_left = stroke.direction > 0;
  demand.pieces = seen(demand, pieces_to_press(cache, stroke));
  for (std::size_t row = 0; row < 2; ++row)
    demand.walls[row] = seen(demand, joined(around.walls.walls[row], 0.0));
  demand.part = seen(demand, around.part);
  return demand;
}

Interval extent(const ToolRow& row) { return {row.from, row.from + row.length()}; }

bool StationTools::stands(const Demand& demand, double shortfall, double at) const {
  for (std::size_t kind = 0; kind < 2; ++kind) {
    for (const Interval& piece : demand.pieces) {
      const Interval pressed = covered(piece, shortfall);
      const bool covered_by_one = std::ranges::any_of(rows[kind], [&](const ToolRow& row) {
        const Interval tool = extent(row);
        return tool.lo <= pressed.lo + at + kSameLength && tool.hi >= pressed.hi + at - kSameLength;
      });
      if (!covered_by_one) return false;
    }
    for (const Interval& wall : demand.walls[kind])
      for (const ToolRow& row : rows[kind]) {
        const Interval tool = extent(row);
        // A tool may stand in a wall as deep as anything may.
        if (tool.hi > wall.lo + at + kPenetration + kSameLength &&
            tool.lo < wall.hi + at - kPenetration - kSameLength)
          return false;
      }
  }
  return true;
}

std::optional<double> StationTools::where(const Demand& demand, double shortfall) const {
  std::vector<double> ways{
      0.5 * (tools.lo + tools.hi - demand.pieces.front().lo - demand.pieces.back().hi)};
  for (std::size_t kind = 0; kind < 2; ++kind)
    for (const ToolRow& row : rows[kind]) {
      const Interval tool = extent(row);
      for (const Interval& piece : demand.pieces) {
        const Interval pressed = covered(piece, shortfall);
        ways.push_back(tool.lo - pressed.lo);
        ways.push_back(tool.hi - pressed.hi);
      }
      for (const Interval& wall : demand.walls[kind]) {
        ways.push_back(tool.hi - wall.lo - kPenetration);
        ways.push_back(tool.lo - wall.hi + kPenetration);
      }
    }
  const auto can = [&](double at) { return stands(demand, shortfall, at); };
  if (can(ways.front())) return ways.front();
  std::erase_if(ways, [&](double at) { return !can(at); });
  if (ways.empty()) return std::nullopt;
  const auto [least, most] = std::ranges::minmax(ways);
  const double between = 0.5 * (least + most);
  return can(between) ? between : ways.front();
}

void StationTools::add(const Demand& demand, double at) {
  reach = {std::min(reach.lo, demand.part.lo + at), std::max(reach.hi, demand.part.hi + at)};
  strokes.push_back({demand.stroke, at});
}

}  // namespace planish::brake_detail
