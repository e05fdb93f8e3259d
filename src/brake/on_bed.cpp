// Which tools stand on the bed at the same time. Within a set-up the longest line chooses its
// segments first, and a line that a station can press needs none of its own. Where that finds no
// room the strokes choose in other orders, rows look ahead to the walls of later strokes, and
// punches share a die. What must hold: each segment stands once, and no workpiece reaches the tools
// of the next station (math.md#stations).
#include "on_bed.hpp"

#include "check.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace planish::brake_detail {
namespace {

using DemandPtr = std::shared_ptr<const Demand>;

/// How a stroke that no station presses gets tools of its own.
struct Manner {
  bool looks_ahead = false;  ///< its rows keep clear of the walls of later strokes on alike lines
  bool shares_die = false;   ///< over a die that stands already, rather than over one of its own
};

bool is_alike(const Demand& a, const Demand& b) {
  return a.choice.punch == b.choice.punch && a.choice.die == b.choice.die &&
         std::ranges::equal(a.pieces, b.pieces, [](const Interval& p, const Interval& q) {
           return std::abs(p.lo - q.lo) < kSameLength && std::abs(p.hi - q.hi) < kSameLength;
         });
}

bool has_tools_for(const StationTools& station, const Demand& demand) {
  return station.punch == demand.choice.punch && station.die == demand.choice.die;
}

/// The stations of one set-up while they are chosen.
class SetUpTools {
 public:
  SetUpTools(StageCache& cache, const std::vector<DemandPtr>& order, const Manner& manner)
      : cache_(cache), inputs_(cache.inputs()), order_(order), manner_(manner) {}

  const std::vector<StationTools>& stations() const { return stations_; }

  /// Whether each stroke finds a station.
  bool serve_all() {
    return std::ranges::all_of(order_, [&](const DemandPtr& one) { return serve(one); });
  }

 private:
  bool serve(const DemandPtr& demand) {
    const double left_out = shortfall(inputs_);
    for (StationTools& station : stations_) {
      if (!has_tools_for(station, *demand)) continue;
      if (const auto at = station.where(*demand, left_out)) {
        station.add(demand, *at);
        return true;
      }
    }
    if (manner_.shares_die && shares_die(demand)) return true;
    return adds_station(demand) || (!manner_.shares_die && shares_die(demand));
  }

  bool adds_station(const DemandPtr& demand) {
    Used used = used_;
    StationTools fresh{demand->choice.punch, demand->choice.die};
    for (const bool above : {true, false}) {
      std::vector<ToolRow>& rows = fresh.rows[above ? 0 : 1];
      rows = take(above, *demand, used);
      if (rows.empty()) return false;
    }
    fresh.add(demand, 0.0);
    stations_.push_back(std::move(fresh));
    used_ = std::move(used);
    return true;
  }

  bool shares_die(const DemandPtr& demand) {
    for (StationTools& station : stations_) {
      if (!has_tools_for(station, *demand)) continue;
      Used used = used_;
      const std::vector<ToolRow> punch = take(true, *demand, used);
      if (punch.empty() || !station.stand_beside(punch, demand, shortfall(inputs_))) continue;
      used_ = std::move(used);
      return true;
    }
    return false;
  }

  using Used = std::map<std::pair<bool, int>, SegmentSums::Chosen>;  ///< by row and tool

  /// Rows of segments that do not stand yet, and notes that they do.
  std::vector<ToolRow> take(bool above, const Demand& demand, Used& all_used) {
    const int tool = above ? demand.choice.punch : demand.choice.die;
    SegmentSums::Chosen& used = all_used[{above, tool}];
    const SegmentSums& left = cache_.segments_left(above ? ToolKind::punch : ToolKind::die, tool,
                                                   used);
    RowRequest request{demand.pieces, shortfall(inputs_), demand.walls[above ? 0 : 1],
                       inputs_.tools.machine.length};
    if (above) {
      request.ears = ears_left(tool);
      request.blocked_foot = demand.foot_walls;
    }
    auto rows = manner_.looks_ahead ? tool_rows(left, looking_ahead(request, above, demand))
                                    : std::vector<ToolRow>();
    if (rows.empty()) rows = tool_rows(left, request);
    for (const ToolRow& row : rows)
      for (const double length : row.plain())
        used |= one_of(left.segments(), used, length);
    return rows;
  }

  RowRequest looking_ahead(RowRequest request, bool above, const Demand& demand) const {
    for (const DemandPtr& other : order_) {
      if (!is_alike(demand, *other)) continue;
      std::ranges::copy(other->walls[above ? 0 : 1], std::back_inserter(request.blocked));
      if (above) std::ranges::copy(other->foot_walls, std::back_inserter(request.blocked_foot));
    }
    request.blocked = joined(std::move(request.blocked), 0.0);
    request.blocked_foot = joined(std::move(request.blocked_foot), 0.0);
    return request;
  }

  /// Those that do not stand yet.
  RowEars ears_left(int punch) const {
    RowEars ears = ears_of(inputs_.tools.punches[punch]);
    for (const StationTools& station : stations_)
      for (const ToolRow& row : station.rows[0]) {
        if (station.punch != punch) continue;
        if (row.ears.lo > 0.0) ears.lo = 0.0;
        if (row.ears.hi > 0.0) ears.hi = 0.0;
      }
    return ears;
  }

  /// A segment of that length that is not used yet.
  static SegmentSums::Chosen one_of(const std::vector<double>& segments, SegmentSums::Chosen used,
                                    double length) {
    for (std::size_t i = 0; i < segments.size(); ++i)
      if (segments[i] == length && (used >> i & 1U) == 0) return SegmentSums::Chosen{1} << i;
    return 0;
  }

  StageCache& cache_;
  const StrokeInputs& inputs_;
  const std::vector<DemandPtr>& order_;
  Manner manner_;
  Used used_;
  std::vector<StationTools> stations_;
};

/// Puts stations in an order in which they find room: that of their first strokes, or the one that
/// takes the least.
bool arrange(std::vector<StationTools>& stations, double length) {
  constexpr std::size_t kMostOrdered = 6;  // 720 orders
  const auto fits = [&] { return starts_of(stations).back() <= length + kSameLength; };
  std::ranges::stable_sort(stations, {}, &StationTools::first_stroke);
  if (fits()) return true;
  if (stations.size() > kMostOrdered) return false;
  std::vector<std::size_t> order(stations.size());
  std::iota(order.begin(), order.end(), 0);
  const std::vector<StationTools> all = stations;
  std::vector<StationTools> best = stations;
  do {
    stations = mapped(order, [&](std::size_t i) { return all[i]; });
    if (starts_of(stations).back() < starts_of(best).back()) best = stations;
  } while (std::ranges::next_permutation(order).found);
  stations = best;
  return fits();
}

double pressed_length(const Demand& demand) {
  return std::accumulate(demand.pieces.begin(), demand.pieces.end(), 0.0,
                         [](double sum, const Interval& p) { return sum + p.hi - p.lo; });
}

/// The length of the longest row that finds room over a stroke's line.
double room_of(const Demand& demand) {
  constexpr double kFar = 1e9;  // mm
  double least = kFar;
  for (const std::vector<Interval>& walls : demand.walls) {
    Interval room{-kFar, kFar};
    for (const Interval& wall : walls)
      if (wall.lo > demand.pieces.back().lo)
        room.hi = std::min(room.hi, wall.lo);
      else
        room.lo = std::max(room.lo, wall.hi);
    least = std::min(least, room.hi - room.lo);
  }
  return least;
}

/// Orders in which strokes choose their segments: with the longest first there are the fewest
/// stations; a line between walls takes no other row than the one that fits.
std::vector<std::vector<DemandPtr>> orders_of(const std::vector<DemandPtr>& demands) {
  std::vector<std::vector<DemandPtr>> orders(3, demands);
  const auto length = [](const DemandPtr& one) { return pressed_length(*one); };
  std::ranges::stable_sort(orders[0], std::greater<>(), length);
  orders[1] = orders[0];
  std::ranges::stable_sort(orders[1], {}, [](const DemandPtr& one) { return room_of(*one); });
  std::ranges::stable_sort(orders[2], {}, length);
  return orders;
}

}  // namespace

std::vector<double> starts_of(const std::vector<StationTools>& stations) {
  std::vector<double> starts{0.0};
  for (std::size_t i = 0; i < stations.size(); ++i) {
    const StationTools& one = stations[i];
    const double end = starts.back() + one.tools.hi - one.tools.lo;
    const double beyond = one.reach.hi - one.tools.hi;
    const bool last = i + 1 == stations.size();
    const double before = last ? 0.0 : stations[i + 1].tools.lo - stations[i + 1].reach.lo;
    starts.push_back(last ? end : std::ceil(end + std::max(beyond, before)));
  }
  return starts;
}

std::optional<OnBed> with_stroke(StageCache& cache, const OnBed& before,
                                 std::shared_ptr<const Demand> demand) {
  if (!before.strokes.empty() && before.strokes.front()->choice.bed != demand->choice.bed)
    return std::nullopt;
  OnBed with = before;
  with.strokes.push_back(demand);
  const double length = cache.inputs().tools.machine.length;
  for (StationTools& station : with.stations) {
    if (!has_tools_for(station, *demand)) continue;
    const auto at = station.where(*demand, shortfall(cache.inputs()));
    if (!at) continue;
    station.add(demand, *at);
    if (arrange(with.stations, length)) return with;
    with.stations = before.stations;
    break;
  }
  const auto orders = orders_of(with.strokes);
  for (const Manner& manner :
       {Manner{}, Manner{true, false}, Manner{false, true}, Manner{true, true}})
    for (const std::vector<DemandPtr>& order : orders) {
      SetUpTools tools(cache, order, manner);
      if (!tools.serve_all()) continue;
      with.stations = tools.stations();
      if (arrange(with.stations, length)) return with;
    }
  return std::nullopt;
}

std::optional<OnBed> with_any_tools(StageCache& cache, const OnBed& before, ChosenStroke& stroke,
                                    std::shared_ptr<const Demand> demand) {
  const int number = demand->stroke;
  if (auto with = with_stroke(cache, before, std::move(demand))) return with;
  if (before.strokes.empty()) return std::nullopt;
  const StrokeInputs& inputs = cache.inputs();
  const StrokeChoice& chosen = stroke.choice;
  for (const ToolPair& pair : inputs.fitting[first_line(chosen.lines)].pairs) {
    const bool same = pair.punch == chosen.punch && pair.die == chosen.die;
    if (same || pair.v_away != chosen.v_away || inputs.beds[pair.punch][pair.die] != chosen.bed)
      continue;
    ChosenStroke other = stroke;
    other.choice.punch = pair.punch;
    other.choice.die = pair.die;
    if (!check(cache, other.formed, other.choice).feasible) continue;
    auto with = with_stroke(cache, before,
                            std::make_shared<Demand>(demand_of(cache, other, number)));
    if (!with) continue;
    stroke.choice = other.choice;
    return with;
  }
  return std::nullopt;
}

}  // namespace planish::brake_detail
