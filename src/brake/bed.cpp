// The tools of a plan as stations on the bed. Strokes are taken in their order; a set-up is closed
// where the next one finds no station and no room for one (on_bed.hpp, math.md#stations).
#include "bed.hpp"

#include "on_bed.hpp"

#include <algorithm>
#include <cmath>

namespace planish::brake_detail {
namespace {

std::vector<SegmentRow> moved(const std::vector<ToolRow>& rows, double by) {
  return mapped(rows, [&](const ToolRow& row) { return row_of(row, row.from + by); });
}

/// The rows of a station over a stroke's line, in the frame of the line.
PressRows along_line(const StationTools& station, const StationTools::Made& made) {
  const Demand& demand = *made.demand;
  const auto presses = [&](const ToolRow& row) {
    return std::ranges::any_of(demand.pieces, [&](const Interval& piece) {
      return extent(row).lo < piece.hi + made.at && extent(row).hi > piece.lo + made.at;
    });
  };
  const auto back = [&](std::vector<ToolRow> rows) {
    std::erase_if(rows, [&](const ToolRow& row) { return !presses(row); });
    for (ToolRow& row : rows) {
      const double from = row.from - made.at;
      row.from = demand.from_left ? demand.line.lo + from : demand.line.hi - from - row.length();
      if (!demand.from_left) row = turned(std::move(row));
    }
    if (!demand.from_left) std::ranges::reverse(rows);
    return rows;
  };
  return {back(station.rows[0]), back(station.rows[1])};
}

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
  void add(int number) {
    const auto stroke = std::make_shared<Wanted>(cache_, strokes_[number], number);
    auto with = with_stroke(cache_, now_, stroke);
    if (!with) {
      write();
      with = with_stroke(cache_, now_, stroke);
    }
    if (with) now_ = std::move(*with);
  }

  /// Where the stations begin: in the middle of the bed, and farther apart than they need be as far
  /// as it is free, since the operator puts the sheet there by eye.
  std::vector<double> spread_out() const {
    constexpr double kFarEnough = 100.0;  // mm
    std::vector<double> starts = starts_of(now_.stations, inputs_.options.clearance);
    const auto count = static_cast<double>(now_.stations.size());
    const double free = std::max(inputs_.tools.machine.length - starts.back(), 0.0);
    const double apart = std::floor(std::min(free / (count + 1.0), kFarEnough));
    const double first = std::floor(0.5 * (free - (count - 1.0) * apart));
    for (std::size_t i = 0; i < starts.size(); ++i)
      starts[i] += first + apart * static_cast<double>(i);
    return starts;
  }

  /// Closes a set-up.
  void write() {
    if (now_.stations.empty()) return;
    now_ = with_least_to_lay(cache_, std::move(now_));
    const std::vector<double> starts = spread_out();
    for (std::size_t i = 0; i < now_.stations.size(); ++i) {
      const StationTools& tools = now_.stations[i];
      Station station{bed_.set_ups, inputs_.tools.punches[tools.punch].id,
                      inputs_.tools.dies[tools.die].id};
      const double by = starts[i] - tools.tools.lo;
      station.punch_rows = moved(tools.rows[0], by);
      station.die_rows = moved(tools.rows[1], by);
      for (const StationTools::Made& made : tools.strokes) {
        station.strokes.push_back(made.demand->stroke);
        bed_.rows[made.demand->stroke] = along_line(tools, made);
        bed_.choices[made.demand->stroke] = made.demand->choice;
      }
      std::ranges::sort(station.strokes);
      bed_.stations.push_back(std::move(station));
    }
    ++bed_.set_ups;
    now_ = {};
  }

  StageCache& cache_;
  const StrokeInputs& inputs_;
  const std::vector<ChosenStroke>& strokes_;
  Bed bed_;
  OnBed now_;
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
