// Whether a station makes a stroke. Rows press a line where each of its pieces lies within one of
// them, and stand clear of what is beside it; the few places where a line just does so, at an end
// of a row or at a wall, bound the ranges where it may lie (math.md#stations).
#include "station.hpp"

#include "closing.hpp"
#include "one_line.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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
  demand.foot_walls = seen(demand, joined(around.walls.foot, 0.0));
  demand.part = seen(demand, around.part);
  return demand;
}

namespace {

/// What stands at a station, and what it keeps away from.
struct Kept {
  Interval tool;
  const std::vector<Interval>& walls;
};

std::vector<Kept> keeping_away(const Rows& rows, const Demand& demand) {
  std::vector<Kept> all;
  for (std::size_t kind = 0; kind < 2; ++kind)
    for (const ToolRow& row : rows[kind]) {
      all.push_back({body(row), demand.walls[kind]});
      if (row.ears.any()) all.push_back({extent(row), demand.foot_walls});
    }
  return all;
}

/// A tool may stand in a wall as deep as anything may.
bool is_clear(const Interval& tool, const Interval& wall, double at, double by) {
  constexpr double kFound = 0.02;  // mm: to which the walls of two strokes are found
  const double in = kPenetration + kFound - by;
  return tool.hi <= wall.lo + at + in || tool.lo >= wall.hi + at - in;
}

bool is_within(const Interval& pressed, const Interval& tool, double at) {
  return tool.lo <= pressed.lo + at + kSameLength && tool.hi >= pressed.hi + at - kSameLength;
}

}  // namespace

bool StationTools::stands(const Demand& demand, double shortfall, double at, double by) const {
  for (const std::vector<ToolRow>& kind : rows)
    for (const Interval& piece : demand.pieces) {
      const Interval pressed = covered(piece, shortfall);
      if (std::ranges::none_of(
              kind, [&](const ToolRow& row) { return is_within(pressed, extent(row), at); }))
        return false;
    }
  return std::ranges::all_of(keeping_away(rows, demand), [&](const Kept& one) {
    return std::ranges::all_of(
        one.walls, [&](const Interval& wall) { return is_clear(one.tool, wall, at, by); });
  });
}

constexpr double kClearly = 5.0;  // mm: from what is beside a line, if there is room

std::optional<double> StationTools::where(const Demand& demand, double shortfall) const {
  std::vector<double> ways{
      0.5 * (tools.lo + tools.hi - demand.pieces.front().lo - demand.pieces.back().hi)};
  for (const std::vector<ToolRow>& kind : rows)
    for (const ToolRow& row : kind)
      for (const Interval& piece : demand.pieces) {
        const Interval pressed = covered(piece, shortfall), tool = extent(row);
        ways.push_back(tool.lo - pressed.lo);
        ways.push_back(tool.hi - pressed.hi);
      }
  for (const auto& [tool, walls] : keeping_away(rows, demand))
    for (const Interval& wall : walls) {
      ways.push_back(tool.hi - wall.lo - kPenetration);
      ways.push_back(tool.lo - wall.hi + kPenetration);
    }
  const auto can = [&](double at) { return stands(demand, shortfall, at); };
  const double middle = ways.front();
  if (stands(demand, shortfall, middle, kClearly)) return middle;
  std::erase_if(ways, [&](double at) { return !can(at); });
  if (ways.empty()) return std::nullopt;
  const auto [least, most] = std::ranges::minmax(ways);
  const double between = 0.5 * (least + most);
  return can(between) ? between : *std::ranges::min_element(ways, {}, [&](double at) {
    return std::abs(at - middle);
  });
}

void StationTools::add(std::shared_ptr<const Demand> demand, double at) {
  strokes.push_back({std::move(demand), at});
  fit_ends();
}

int StationTools::first_stroke() const {
  int first = strokes.front().demand->stroke;
  for (const Made& made : strokes)
    first = std::min(first, made.demand->stroke);
  return first;
}

namespace {

bool are_apart(std::vector<ToolRow>& rows) {
  std::ranges::sort(rows, {}, &ToolRow::from);
  for (std::size_t i = 1; i < rows.size(); ++i)
    if (extent(rows[i - 1]).hi > rows[i].from + kSameLength) return false;
  return true;
}

/// So far from the first row of a station that whole millimetres lie between, no nearer.
double at_whole(const StationTools& station, const Interval& own, double at) {
  const double from = station.rows[0].front().from, distance = own.lo + at - from;
  return from - own.lo +
         (distance > 0.0 ? std::ceil(distance - kSameLength) : std::floor(distance + kSameLength));
}

/// Where a line may begin so that punches for it stand beside those of a station: next to them, or
/// just clear of what strokes have beside their lines.
std::vector<double> beside(const StationTools& station, const std::vector<ToolRow>& punches,
                           const Demand& demand) {
  const Interval own{punches.front().from, extent(punches.back()).hi};
  std::vector<double> ways;
  for (const ToolRow& row : station.rows[0]) {
    const Interval there = extent(row);
    ways.insert(ways.end(), {there.hi - own.lo, there.lo - own.hi});
    for (const Interval& wall : demand.walls[0])
      ways.insert(ways.end(),
                  {there.lo - wall.hi + kPenetration, there.hi - wall.lo - kPenetration});
  }
  for (const StationTools::Made& made : station.strokes)
    for (const Interval& wall : made.demand->walls[0])
      ways.insert(ways.end(), {wall.hi + made.at - kPenetration - own.lo,
                               wall.lo + made.at + kPenetration - own.hi});
  for (double& at : ways)
    at = at_whole(station, own, at);
  return ways;
}

/// Where the die may begin for all strokes: in the middle of the range, or at one end.
std::vector<double> places_of_die(const StationTools& station, double shortfall) {
  const double length = station.rows[1].front().length();
  Interval range{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  for (const StationTools::Made& made : station.strokes)
    for (const Interval& piece : made.demand->pieces) {
      const Interval pressed = covered(piece, shortfall);
      range.lo = std::max(range.lo, pressed.hi + made.at - length);
      range.hi = std::min(range.hi, pressed.lo + made.at);
    }
  if (range.lo > range.hi + kSameLength) return {};
  const double middle = 0.5 * (range.lo + range.hi), first = station.rows[0].front().from;
  return {first + std::round(middle - first), middle, range.lo, range.hi};
}

}  // namespace

bool StationTools::stand_beside(const std::vector<ToolRow>& punches,
                                std::shared_ptr<const Demand> demand, double shortfall) {
  if (rows[1].size() != 1) return false;
  std::optional<StationTools> best;
  for (const double at : beside(*this, punches, *demand)) {
    StationTools with = *this;
    for (ToolRow row : punches) {
      row.from += at;
      with.rows[0].push_back(std::move(row));
    }
    if (!are_apart(with.rows[0])) continue;
    with.add(demand, at);
    for (const double from : places_of_die(with, shortfall)) {
      with.rows[1].front().from = from;
      if (!std::ranges::all_of(with.strokes, [&](const Made& made) {
            return with.stands(*made.demand, shortfall, made.at);
          }))
        continue;
      with.fit_ends();
      if (!best || with.tools.hi - with.tools.lo < best->tools.hi - best->tools.lo)
        best = std::move(with);
      break;
    }
  }
  if (best) *this = std::move(*best);
  return best.has_value();
}

void StationTools::fit_ends() {
  tools = {std::min(rows[0].front().from, rows[1].front().from),
           std::max(extent(rows[0].back()).hi, extent(rows[1].back()).hi)};
  reach = tools;
  for (const Made& made : strokes)
    reach = {std::min(reach.lo, made.demand->part.lo + made.at),
             std::max(reach.hi, made.demand->part.hi + made.at)};
}

}  // namespace planish::brake_detail
