// The tools of a plan as stations on the bed. Strokes are taken in their order; a set-up is closed
// where the next one finds no station and no room for one. Within a set-up the longest line chooses
// its segments first, and a line that a station can press needs none of its own. What must hold:
// each segment stands once, and no workpiece reaches the tools of the next station
// (math.md#stations).
#include "bed.hpp"

#include "check.hpp"
#include "station.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace planish::brake_detail {
namespace {

/// The segments of one set-up, and what stands of them.
class SetUpTools {
 public:
  explicit SetUpTools(const StrokeInputs& inputs) : inputs_(inputs) {}

  const std::vector<StationTools>& places() const { return places_; }

  /// A station for a stroke, one that stands already if it can be; whether there is any.
  bool serve(const Demand& demand) {
    const double left_out = shortfall(inputs_);
    for (StationTools& place : places_) {
      if (place.punch != demand.choice.punch || place.die != demand.choice.die) continue;
      if (const auto at = place.where(demand, left_out)) {
        place.add(demand, *at);
        return true;
      }
    }
    StationTools fresh{demand.choice.punch, demand.choice.die};
    for (const bool above : {true, false}) {
      std::vector<ToolRow>& rows = fresh.rows[above ? 0 : 1];
      rows = take(above, demand);
      if (rows.empty()) return false;
    }
    const auto& [punch, die] = fresh.rows;
    fresh.tools = {std::min(punch.front().from, die.front().from),
                   std::max(extent(punch.back()).hi, extent(die.back()).hi)};
    fresh.reach = fresh.tools;
    fresh.add(demand, 0.0);
    places_.push_back(std::move(fresh));
    return true;
  }

 private:
  std::vector<ToolRow> take(bool above, const Demand& demand) {
    const int tool = above ? demand.choice.punch : demand.choice.die;
    SegmentSums::Chosen& used = used_[{above, tool}];
    const SegmentSums& all = above ? inputs_.punch_segments[tool] : inputs_.die_segments[tool];
    const SegmentSums left(all.segments(), used);
    RowRequest request{demand.pieces, shortfall(inputs_), demand.walls[above ? 0 : 1],
                       inputs_.tools.machine.length};
    if (above) {
      request.ears = ears_left(tool);
      request.blocked_foot = demand.foot_walls;
    }
    auto rows = tool_rows(left, request);
    for (const ToolRow& row : rows)
      for (const double length : row.plain())
        used |= one_of(all.segments(), used, length);
    return rows;
  }

  /// Those that do not stand yet.
  RowEars ears_left(int punch) const {
    RowEars ears = ears_of(inputs_.tools.punches[punch]);
    for (const StationTools& place : places_)
      for (const ToolRow& row : place.rows[0]) {
        if (place.punch != punch) continue;
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

  const StrokeInputs& inputs_;
  std::map<std::pair<bool, int>, SegmentSums::Chosen> used_;
  std::vector<StationTools> places_;
};

/// Where stations begin on the bed if they stand in this order, each as near to the one before as
/// the workpieces allow; the last is where the bed must end.
std::vector<double> starts_of(const std::vector<StationTools>& places) {
  std::vector<double> starts{0.0};
  for (std::size_t i = 0; i < places.size(); ++i) {
    const StationTools& one = places[i];
    const double end = starts.back() + one.tools.hi - one.tools.lo;
    const double beyond = one.reach.hi - one.tools.hi;
    const bool last = i + 1 == places.size();
    const double before = last ? 0.0 : places[i + 1].tools.lo - places[i + 1].reach.lo;
    starts.push_back(last ? end : std::ceil(end + std::max(beyond, before)));
  }
  return starts;
}

/// Puts stations in an order in which they find room: that of their first strokes, or the one that
/// takes the least.
bool arrange(std::vector<StationTools>& places, double length) {
  constexpr std::size_t kMostOrdered = 6;  // 720 orders
  const auto fits = [&] { return starts_of(places).back() <= length + kSameLength; };
  std::ranges::stable_sort(places, {}, [](const StationTools& place) {
    return std::ranges::min(place.strokes, {}, &StationTools::Made::stroke).stroke;
  });
  if (fits()) return true;
  if (places.size() > kMostOrdered) return false;
  std::vector<std::size_t> order(places.size());
  std::iota(order.begin(), order.end(), 0);
  const std::vector<StationTools> all = places;
  std::vector<StationTools> best = places;
  do {
    places = mapped(order, [&](std::size_t i) { return all[i]; });
    if (starts_of(places).back() < starts_of(best).back()) best = places;
  } while (std::ranges::next_permutation(order).found);
  places = best;
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
std::vector<std::vector<const Demand*>> orders_of(const std::vector<const Demand*>& demands) {
  std::vector<std::vector<const Demand*>> orders(3, demands);
  std::ranges::stable_sort(orders[0], std::greater<>(),
                           [](const Demand* one) { return pressed_length(*one); });
  orders[1] = orders[0];
  std::ranges::stable_sort(orders[1], {}, [](const Demand* one) { return room_of(*one); });
  std::ranges::stable_sort(orders[2], {}, [](const Demand* one) { return pressed_length(*one); });
  return orders;
}

/// The stations of one set-up for these strokes; empty if they do not stand together.
std::vector<StationTools> together_on_bed(const StrokeInputs& inputs,
                                          const std::vector<const Demand*>& demands) {
  const int bed = demands.front()->choice.bed;
  if (std::ranges::any_of(demands, [&](const Demand* one) { return one->choice.bed != bed; }))
    return {};
  for (const std::vector<const Demand*>& order : orders_of(demands)) {
    SetUpTools tools(inputs);
    if (!std::ranges::all_of(order, [&](const Demand* one) { return tools.serve(*one); })) continue;
    std::vector<StationTools> places = tools.places();
    if (arrange(places, inputs.tools.machine.length)) return places;
  }
  return {};
}

/// Writes a set-up into the bed.
class Writer {
 public:
  Writer(const StrokeInputs& inputs, const std::vector<Demand>& demands, Bed& bed)
      : inputs_(inputs), demands_(demands), bed_(bed) {}

  void write(const std::vector<StationTools>& places) {
    const std::vector<double> starts = starts_of(places);
    const double first = std::floor(0.5 * (inputs_.tools.machine.length - starts.back()));
    for (std::size_t i = 0; i < places.size(); ++i) {
      const StationTools& place = places[i];
      Station station{bed_.set_ups, inputs_.tools.punches[place.punch].id,
                      inputs_.tools.dies[place.die].id};
      const double by = std::max(first, 0.0) + starts[i] - place.tools.lo;
      station.punch_rows = moved(place.rows[0], by);
      station.die_rows = moved(place.rows[1], by);
      for (const StationTools::Made& made : place.strokes) {
        station.strokes.push_back(made.stroke);
        bed_.rows[made.stroke] = along_line(place, made);
      }
      std::ranges::sort(station.strokes);
      bed_.stations.push_back(std::move(station));
    }
    ++bed_.set_ups;
  }

 private:
  static std::vector<SegmentRow> moved(const std::vector<ToolRow>& rows, double by) {
    return mapped(rows, [&](const ToolRow& row) { return row_of(row, row.from + by); });
  }

  /// The rows of a station in the frame of a stroke's line.
  PressRows along_line(const StationTools& place, const StationTools::Made& made) const {
    const auto demand = std::ranges::find(demands_, made.stroke, &Demand::stroke);
    const Interval& line = demand->line;
    const auto back = [&](std::vector<ToolRow> rows) {
      for (ToolRow& row : rows) {
        const double from = row.from - made.at;
        row.from = demand->from_left ? line.lo + from : line.hi - from - row.length();
        if (!demand->from_left) row = turned(std::move(row));
      }
      if (!demand->from_left) std::ranges::reverse(rows);
      return rows;
    };
    return {back(place.rows[0]), back(place.rows[1])};
  }

  const StrokeInputs& inputs_;
  const std::vector<Demand>& demands_;
  Bed& bed_;
};

/// Takes strokes one after the other.
class Laying {
 public:
  Laying(StageCache& cache, const std::vector<ChosenStroke>& strokes)
      : cache_(cache), inputs_(cache.inputs()), strokes_(strokes) {}

  Bed run() {
    bed_.rows.resize(strokes_.size());
    for (const ChosenStroke& stroke : strokes_)
      bed_.choices.push_back(stroke.choice);
    for (int i = 0; i < std::ssize(strokes_); ++i)
      if (!strokes_[i].blocked) add(i);
    write();
    return std::move(bed_);
  }

 private:
  void add(int stroke) {
    const Demand demand = demand_of(cache_, strokes_[stroke], stroke);
    if (joins(demand) || other_tools_join(stroke)) return;
    write();
    joins(demand);
  }

  /// Whether a stroke stands on the bed with those before.
  bool joins(const Demand& demand) {
    std::vector<const Demand*> all = mapped(now_, [](const Demand& one) { return &one; });
    all.push_back(&demand);
    auto more = together_on_bed(inputs_, all);
    if (more.empty()) return false;
    places_ = std::move(more);
    now_.push_back(demand);
    return true;
  }

  bool other_tools_join(int stroke) {
    if (now_.empty()) return false;
    ChosenStroke other = strokes_[stroke];
    const StrokeChoice chosen = other.choice;
    const int line = members(chosen.lines).front();
    for (const ToolPair& pair : inputs_.fitting[line].pairs) {
      const bool same = pair.punch == chosen.punch && pair.die == chosen.die;
      if (same || pair.v_away != chosen.v_away || inputs_.beds[pair.punch][pair.die] != chosen.bed)
        continue;
      other.choice.punch = pair.punch;
      other.choice.die = pair.die;
      if (!check(cache_, other.formed, other.choice).feasible) continue;
      if (!joins(demand_of(cache_, other, stroke))) continue;
      bed_.choices[stroke] = other.choice;
      return true;
    }
    return false;
  }

  void write() {
    if (!places_.empty()) Writer(inputs_, now_, bed_).write(places_);
    places_.clear();
    now_.clear();
  }

  StageCache& cache_;
  const StrokeInputs& inputs_;
  const std::vector<ChosenStroke>& strokes_;
  Bed bed_;
  std::vector<Demand> now_;           ///< of the set-up
  std::vector<StationTools> places_;  ///< its stations
};

}  // namespace

bool Bed::count_more(double weight, int& tool_changes, double& cost) const {
  const int more = set_ups - 1 - tool_changes;
  if (more <= 0) return false;
  tool_changes += more;
  cost += more * weight;
  return true;
}

Bed bed_of(StageCache& cache, const std::vector<ChosenStroke>& strokes) {
  return Laying(cache, strokes).run();
}

}  // namespace planish::brake_detail
