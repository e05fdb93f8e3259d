// Among plans of one cost that with the tools a shop would take: for each run of strokes whose
// tools stand on one bed, the preferred pair that makes all of them, else pairs of one bed, the
// preferred one, that make as many as can be. What must hold: the cost depends on which strokes
// share a bed and not on which tools stand there.
#include "preferred_tools.hpp"

#include "check.hpp"
#include "fits.hpp"

#include <planish/base/tolerance.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <tuple>

namespace planish::brake_detail {
namespace {

/// Strokes in a row whose tools stand on one bed.
struct Run {
  std::size_t from = 0, to = 0;
};

struct Pair {
  int punch = 0, die = 0;
  friend bool operator==(const Pair&, const Pair&) = default;
};

Pair tools_of(const StrokeChoice& stroke) { return {stroke.punch, stroke.die}; }

std::vector<Run> runs_of(const std::vector<StrokeChoice>& strokes) {
  std::vector<Run> runs;
  for (std::size_t s = 0; s < strokes.size(); ++s) {
    const bool same = s > 0 &&
                      (strokes[s].bed >= 0 ? strokes[s].bed == strokes[s - 1].bed
                                           : tools_of(strokes[s]) == tools_of(strokes[s - 1]));
    if (!same) runs.push_back({s, s});
    runs.back().to = s + 1;
  }
  return runs;
}

/// How far the radius that a pair makes is from the drawn one, if tools make it and it is told.
double off_radius(const StrokeInputs& inputs, int number, const Pair& pair) {
  const BrakeLine& line = inputs.work.lines[number];
  if (line.press_line || line.closes || line.closed_by) return 0.0;
  const double off = std::abs(
      made_radius(inputs.tools.punches[pair.punch], inputs.tools.dies[pair.die], inputs.options) -
      line.drawn_radius);
  return off > told_from(line.drawn_radius, inputs.work.thickness) ? off : 0.0;
}

/// How far the V of a pair is from the wanted one, for a bump, whose cost does not tell.
double off_opening(const StrokeInputs& inputs, int number, const Pair& pair) {
  const BrakeLine& line = inputs.work.lines[number];
  if (!line.bump_pitch) return 0.0;
  return std::abs(inputs.tools.dies[pair.die].opening -
                  wanted_opening(line, inputs.tools, inputs.options));
}

/// All pairs for the strokes of a run, the preferred first: those that leave the drawn radius, or
/// most nearly, then those of the wanted V, then the bluntest.
std::vector<Pair> pairs_of(const StrokeInputs& inputs, const std::vector<StrokeChoice>& strokes,
                           const Run& run) {
  const BrakeTools& tools = inputs.tools;
  std::vector<Pair> pairs;
  for (std::size_t s = run.from; s < run.to; ++s)
    for (const int line : members(strokes[s].lines))
      for (const ToolPair& pair : inputs.fitting[line].pairs)
        if (const Pair one{pair.punch, pair.die};
            pair.v_away == strokes[s].v_away && !std::ranges::count(pairs, one))
          pairs.push_back(one);
  const auto off = [&](const Pair& pair, const auto& off_one) {
    double sum = 0.0;
    for (std::size_t s = run.from; s < run.to; ++s)
      sum += off_one(inputs, first_line(strokes[s].lines), pair);
    return std::round(sum / tolerance::kWrittenDigits);
  };
  std::ranges::stable_sort(pairs, {}, [&](const Pair& pair) {
    const Punch& punch = tools.punches[pair.punch];
    return std::tuple(off(pair, off_radius), off(pair, off_opening),
                      -punch.angle.radians() - tools.dies[pair.die].angle.radians(),
                      -punch.tip_radius);
  });
  return pairs;
}

class Preferring {
 public:
  Preferring(StageCache& cache, std::vector<StrokeChoice> strokes)
      : cache_(cache), strokes_(std::move(strokes)) {
    LineSet formed = no_lines(cache.inputs().lines());
    for (const StrokeChoice& stroke : strokes_) {
      formed_.push_back(formed);
      formed = joined(formed, stroke.lines);
    }
  }

  std::vector<StrokeChoice> run() {
    for (const Run& run : runs_of(strokes_)) {
      const std::vector<Pair> pairs = pairs_of(cache_.inputs(), strokes_, run);
      if (!take_one_pair(run, pairs)) take_few(run, pairs);
    }
    return std::move(strokes_);
  }

 private:
  bool makes(std::size_t s, const Pair& pair) {
    StrokeChoice choice = strokes_[s];
    if (tools_of(choice) == pair) return true;
    choice.punch = pair.punch;
    choice.die = pair.die;
    for (const int line : members(choice.lines))
      if (!std::ranges::count(cache_.inputs().fitting[line].pairs,
                              ToolPair{pair.punch, pair.die, choice.v_away}))
        return false;
    return can_be_made(cache_, formed_[s], choice);
  }

  void take(std::size_t s, const Pair& pair) {
    strokes_[s].punch = pair.punch;
    strokes_[s].die = pair.die;
    if (strokes_[s].bed >= 0) strokes_[s].bed = bed_of(pair);
  }

  int bed_of(const Pair& pair) const { return cache_.inputs().beds[pair.punch][pair.die]; }

  bool take_one_pair(const Run& run, const std::vector<Pair>& pairs) {
    for (const Pair& pair : pairs) {
      bool all = true;
      for (std::size_t s = run.from; all && s < run.to; ++s)
        all = makes(s, pair);
      if (!all) continue;
      for (std::size_t s = run.from; s < run.to; ++s)
        take(s, pair);
      return true;
    }
    return false;
  }

  /// On the bed of the preferred pair on which all can be made.
  void take_few(const Run& run, const std::vector<Pair>& pairs) {
    if (strokes_[run.from].bed < 0) return;
    std::set<int> tried;
    for (const Pair& pair : pairs)
      if (tried.insert(bed_of(pair)).second && take_few_of(bed_of(pair), run, pairs)) return;
  }

  /// Each time the pair of a bed that makes the most of what is left; nothing unless all are made.
  bool take_few_of(int bed, const Run& run, const std::vector<Pair>& pairs) {
    std::vector<std::pair<std::size_t, Pair>> taken;
    std::vector<std::size_t> left;
    for (std::size_t s = run.from; s < run.to; ++s)
      left.push_back(s);
    while (!left.empty()) {
      std::vector<std::size_t> most;
      std::optional<Pair> best;
      for (const Pair& pair : pairs) {
        if (bed_of(pair) != bed) continue;
        std::vector<std::size_t> made;
        for (const std::size_t s : left)
          if (makes(s, pair)) made.push_back(s);
        if (made.size() <= most.size()) continue;
        most = std::move(made);
        best = pair;
      }
      if (!best) return false;
      for (const std::size_t s : most)
        taken.emplace_back(s, *best);
      std::erase_if(left, [&](std::size_t s) { return std::ranges::count(most, s) > 0; });
    }
    for (const auto& [s, pair] : taken)
      take(s, pair);
    return true;
  }

  StageCache& cache_;
  std::vector<StrokeChoice> strokes_;
  std::vector<LineSet> formed_;  ///< before each
};

}  // namespace

std::vector<StrokeChoice> with_preferred_tools(StageCache& cache,
                                               std::vector<StrokeChoice> strokes) {
  return Preferring(cache, std::move(strokes)).run();
}

}  // namespace planish::brake_detail
