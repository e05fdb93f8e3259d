// Among plans of one cost that with the tools a shop would take: for each run of strokes with one
// pair of tools, other pairs are tried in the order of preference. What must hold: the cost
// depends on which strokes share tools and not on which tools these are.
#include "preferred_tools.hpp"

#include "check.hpp"

#include <algorithm>
#include <tuple>

namespace planish::brake_detail {
namespace {

/// Strokes in a row that are made with the same tools, and the stage before the first of them.
struct Run {
  std::size_t from = 0, to = 0;
  LineSet formed;
};

struct Pair {
  int punch = 0, die = 0;
  friend bool operator==(const Pair&, const Pair&) = default;
};

Pair tools_of(const StrokeChoice& stroke) { return {stroke.punch, stroke.die}; }

std::vector<Run> runs_of(const std::vector<StrokeChoice>& strokes, int lines) {
  std::vector<Run> runs;
  LineSet formed = no_lines(lines);
  for (std::size_t s = 0; s < strokes.size(); ++s) {
    if (s == 0 || tools_of(strokes[s]) != tools_of(strokes[s - 1])) runs.push_back({s, s, formed});
    runs.back().to = s + 1;
    formed = joined(formed, strokes[s].lines);
  }
  return runs;
}

/// All pairs for the first stroke of a run, the preferred first.
std::vector<Pair> pairs_of(const FittingTools& fitting, int v_away, const BrakeTools& tools) {
  std::vector<Pair> pairs;
  for (const ToolPair& pair : fitting.pairs)
    if (pair.v_away == v_away) pairs.push_back({pair.punch, pair.die});
  std::ranges::stable_sort(pairs, {}, [&](const Pair& pair) {
    const Punch& punch = tools.punches[pair.punch];
    return std::tuple(-punch.angle.radians() - tools.dies[pair.die].angle.radians(),
                      -punch.tip_radius);
  });
  return pairs;
}

/// Whether a pair can make all strokes of a run.
bool makes(StageCache& cache, const std::vector<StrokeChoice>& strokes, const Run& run,
           const Pair& pair) {
  LineSet formed = run.formed;
  for (std::size_t s = run.from; s < run.to; ++s) {
    StrokeChoice choice = strokes[s];
    choice.punch = pair.punch;
    choice.die = pair.die;
    for (const int line : members(choice.lines))
      if (!std::ranges::count(cache.inputs().fitting[line].pairs,
                              ToolPair{pair.punch, pair.die, choice.v_away}))
        return false;
    if (!check(cache, formed, choice).feasible) return false;
    formed = joined(formed, choice.lines);
  }
  return true;
}

}  // namespace

std::vector<StrokeChoice> with_preferred_tools(StageCache& cache,
                                               std::vector<StrokeChoice> strokes) {
  const StrokeInputs& inputs = cache.inputs();
  for (const Run& run : runs_of(strokes, inputs.lines())) {
    const Pair now = tools_of(strokes[run.from]);
    const int line = members(strokes[run.from].lines).front();
    const int v_away = strokes[run.from].v_away;
    for (const Pair& pair : pairs_of(inputs.fitting[line], v_away, inputs.tools)) {
      if (pair != now && !makes(cache, strokes, run, pair)) continue;
      for (std::size_t s = run.from; s < run.to; ++s) {
        strokes[s].punch = pair.punch;
        strokes[s].die = pair.die;
      }
      break;
    }
  }
  return strokes;
}

}  // namespace planish::brake_detail
