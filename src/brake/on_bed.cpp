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
#include <ranges>
#include <tuple>

namespace planish::brake_detail {
namespace {

/// The ways to make each stroke of a set-up that are tried.
using Ways = std::vector<std::vector<DemandPtr>>;

/// How a stroke that no station presses gets tools of its own.
struct Manner {
  bool looks_ahead = false;  ///< its rows keep clear of the walls of later strokes on alike lines
  bool shares_die = false;   ///< over a die that stands already, rather than over one of its own
  bool from_last = false;    ///< between walls the last row chooses its segments first
  bool shortest = false;     ///< its rows stand on ears if they are shorter then
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

/// Whether a station makes a stroke; it is added to those that it makes.
bool station_serves(StationTools& station, const DemandPtr& demand, double shortfall) {
  if (!has_tools_for(station, *demand)) return false;
  const auto at = station.where(*demand, shortfall);
  if (at) station.add(demand, *at);
  return at.has_value();
}

/// The stations of one set-up while they are chosen.
class SetUpTools {
 public:
  SetUpTools(StageCache& cache, const Ways& order, const Manner& manner)
      : cache_(cache), inputs_(cache.inputs()), order_(order), manner_(manner) {}

  const std::vector<StationTools>& stations() const { return stations_; }

  /// Whether each stroke finds a station.
  bool serve_all() {
    return std::ranges::all_of(order_, [&](const auto& ways) { return serve(ways); });
  }

 private:
  bool serve(const std::vector<DemandPtr>& ways) {
    const auto any = [&](const auto& serves) { return std::ranges::any_of(ways, serves); };
    const auto shared = [&](const DemandPtr& way) { return shares_die(way); };
    return any([&](const DemandPtr& way) { return stands_already(way); }) ||
           (manner_.shares_die && any(shared)) ||
           any([&](const DemandPtr& way) { return adds_station(way); }) ||
           (!manner_.shares_die && any(shared));
  }

  bool stands_already(const DemandPtr& demand) {
    for (StationTools& station : stations_)
      if (station_serves(station, demand, shortfall(inputs_))) return true;
    return false;
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
    request.from_last = manner_.from_last;
    request.shortest = manner_.shortest;
    auto rows = manner_.looks_ahead ? tool_rows(left, looking_ahead(request, above, demand))
                                    : std::vector<ToolRow>();
    if (rows.empty()) rows = tool_rows(left, request);
    for (const ToolRow& row : rows)
      for (const double length : row.plain())
        used |= one_of(left.segments(), used, length);
    return rows;
  }

  RowRequest looking_ahead(RowRequest request, bool above, const Demand& demand) const {
    for (const DemandPtr& other : order_ | std::views::join) {
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
  const Ways& order_;
  Manner manner_;
  Used used_;
  std::vector<StationTools> stations_;
};

/// Puts stations in an order in which they find room: that of their first strokes, or the one that
/// takes the least.
bool arrange(std::vector<StationTools>& stations, const StrokeInputs& inputs) {
  constexpr std::size_t kMostOrdered = 6;  // 720 orders
  const auto end_of = [&](const std::vector<StationTools>& all) {
    return starts_of(all, inputs.options.clearance).back();
  };
  const auto fits = [&] { return end_of(stations) <= inputs.tools.machine.length + kSameLength; };
  std::ranges::stable_sort(stations, {}, &StationTools::first_stroke);
  if (fits()) return true;
  if (stations.size() > kMostOrdered) return false;
  std::vector<std::size_t> order(stations.size());
  std::iota(order.begin(), order.end(), 0);
  const std::vector<StationTools> all = stations;
  std::vector<StationTools> best = stations;
  do {
    stations = mapped(order, [&](std::size_t i) { return all[i]; });
    if (end_of(stations) < end_of(best)) best = stations;
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
std::vector<Ways> orders_of(const Ways& strokes) {
  std::vector<Ways> orders(3, strokes);
  const auto length = [](const auto& ways) { return pressed_length(*ways.front()); };
  std::ranges::stable_sort(orders[0], std::greater<>(), length);
  orders[1] = orders[0];
  std::ranges::stable_sort(orders[1], {}, [](const auto& ways) { return room_of(*ways.front()); });
  std::ranges::stable_sort(orders[2], {}, length);
  return orders;
}

/// The manners in which strokes may be laid, the plain one first.
std::vector<Manner> manners_for(const StrokeInputs& inputs, const Ways& strokes) {
  const auto any = [&](const auto& is) {
    return std::ranges::any_of(strokes | std::views::join, is);
  };
  const bool apart = any([](const DemandPtr& way) { return way->pieces.size() > 1; });
  const bool eared = any([&](const DemandPtr& way) {
    return inputs.tools.punches[way->choice.punch].ears.has_value();
  });
  std::vector<Manner> manners;
  for (const bool from_last : {false, true})
    for (const bool shares_die : {false, true})
      for (const bool looks_ahead : {false, true})
        if (apart || !from_last) manners.push_back({looks_ahead, shares_die, from_last});
  if (eared)
    for (const bool shares_die : {false, true})
      manners.push_back({true, shares_die, false, true});
  return manners;
}

/// Offers the stations of each order and manner that finds room on an empty bed, until one is
/// taken.
template <typename Take>
void lay(StageCache& cache, const Ways& strokes, const Take& take) {
  const auto orders = orders_of(strokes);
  for (const Manner& manner : manners_for(cache.inputs(), strokes))
    for (const Ways& order : orders) {
      SetUpTools tools(cache, order, manner);
      if (!tools.serve_all()) continue;
      std::vector<StationTools> stations = tools.stations();
      if (arrange(stations, cache.inputs()) && take(std::move(stations))) return;
    }
}

/// Stations for all strokes on an empty bed; none if none of the orders and manners finds room.
std::vector<StationTools> laid(StageCache& cache, const Ways& strokes) {
  std::vector<StationTools> first;
  lay(cache, strokes, [&](std::vector<StationTools> stations) {
    first = std::move(stations);
    return true;
  });
  return first;
}

/// What there is to lay: stations, ears, mm of tools.
std::tuple<std::size_t, int, double> work_of(const std::vector<StationTools>& stations) {
  int ears = 0;
  double length = 0.0;
  for (const StationTools& station : stations)
    for (const std::vector<ToolRow>& rows : station.rows)
      for (const ToolRow& row : rows) {
        ears += row.ears.count();
        length += row.length();
      }
  return {stations.size(), ears, length};
}

/// As the strokes stand on the bed.
Ways as_they_stand(const OnBed& bed) {
  std::map<int, DemandPtr> standing;
  for (const StationTools& station : bed.stations)
    for (const StationTools::Made& made : station.strokes)
      standing.emplace(made.demand->stroke, made.demand);
  return mapped(bed.strokes, [&](const WantedPtr& stroke) {
    return std::vector{standing.at(stroke->chosen()->stroke)};
  });
}

}  // namespace

std::vector<double> starts_of(const std::vector<StationTools>& stations, double clearance) {
  std::vector<double> starts{0.0};
  for (std::size_t i = 0; i < stations.size(); ++i) {
    const StationTools& one = stations[i];
    const double end = starts.back() + one.tools.hi - one.tools.lo;
    const double beyond = one.reach.hi - one.tools.hi;
    const bool last = i + 1 == stations.size();
    const double before = last ? 0.0 : stations[i + 1].tools.lo - stations[i + 1].reach.lo;
    starts.push_back(last ? end : std::ceil(end + std::max(beyond, before) + clearance));
  }
  return starts;
}

Wanted::Wanted(StageCache& cache, ChosenStroke stroke, int number)
    : stroke_(std::move(stroke)),
      ways_{std::make_shared<Demand>(demand_of(cache, *stroke_, number))} {}

const std::vector<DemandPtr>& Wanted::ways(StageCache& cache) {
  if (!stroke_) return ways_;
  const StrokeInputs& inputs = cache.inputs();
  const StrokeChoice chosen = stroke_->choice;
  for (const ToolPair& pair : inputs.fitting[first_line(chosen.lines)].pairs) {
    const bool same = pair.punch == chosen.punch && pair.die == chosen.die;
    if (same || pair.v_away != chosen.v_away || inputs.beds[pair.punch][pair.die] != chosen.bed)
      continue;
    stroke_->choice.punch = pair.punch;
    stroke_->choice.die = pair.die;
    if (can_be_made(cache, stroke_->formed, stroke_->choice))
      ways_.push_back(std::make_shared<Demand>(demand_of(cache, *stroke_, ways_.front()->stroke)));
  }
  stroke_.reset();
  return ways_;
}

std::optional<OnBed> with_stroke(StageCache& cache, const OnBed& before, WantedPtr stroke) {
  const DemandPtr chosen = stroke->chosen();
  const bool is_first = before.strokes.empty();
  if (!is_first && before.strokes.front()->chosen()->choice.bed != chosen->choice.bed)
    return std::nullopt;
  OnBed with = before;
  with.strokes.push_back(stroke);
  for (StationTools& station : with.stations)
    if (station_serves(station, chosen, shortfall(cache.inputs()))) {
      if (arrange(with.stations, cache.inputs())) return with;
      break;
    }
  const auto stands = [&](const Ways& strokes) {
    with.stations = laid(cache, strokes);
    return !with.stations.empty();
  };
  Ways ways = as_they_stand(before);
  ways.push_back({chosen});
  if (stands(ways)) return with;
  if (is_first) return std::nullopt;
  for (const DemandPtr& way : stroke->ways(cache)) {
    ways.back() = {way};
    if (way != chosen && stands(ways)) return with;
  }
  ways = mapped(with.strokes, [&](const WantedPtr& one) { return one->ways(cache); });
  const bool has_others = std::ranges::any_of(ways, [](const auto& one) { return one.size() > 1; });
  if (has_others && stands(ways)) return with;
  return std::nullopt;
}

OnBed with_least_to_lay(StageCache& cache, OnBed bed) {
  lay(cache, as_they_stand(bed), [&](std::vector<StationTools> stations) {
    if (work_of(stations) < work_of(bed.stations)) bed.stations = std::move(stations);
    return false;
  });
  return bed;
}

}  // namespace planish::brake_detail
