// From the strokes of a search to those on the bed. What must hold: of several ways to lay them the
// one counts that costs least with every set-up (math.md#stations).
#include "laid_strokes.hpp"

#include "fewer_set_ups.hpp"
#include "plan_search.hpp"
#include "preferred_sides.hpp"
#include "preferred_tools.hpp"
#include "stroke_work.hpp"

#include <planish/base/tolerance.hpp>

namespace planish::brake_detail {
namespace {

class LeastSetUps {
 public:
  explicit LeastSetUps(StageCache& cache) : cache_(cache) {}

  /// With what a shop prefers, as far as that takes no more set-ups.
  LaidStrokes run(const StrokeSearch& search) {
    const std::vector<StrokeChoice> square = with_square_gauges(cache_, search.strokes);
    const std::vector<StrokeChoice> held = with_little_behind(cache_, square);
    LaidStrokes best = laid(search, with_preferred_tools(cache_, held));
    for (const std::vector<StrokeChoice>* strokes : {&held, &square, &search.strokes})
      if (best.is_dearer)
        if (LaidStrokes other = laid(search, *strokes); is_cheaper(other, best))
          best = std::move(other);
    return best;
  }

  static bool is_cheaper(const LaidStrokes& one, const LaidStrokes& than) {
    return one.search.cost < than.search.cost - tolerance::kComputed * (1.0 + than.search.cost);
  }

 private:
  LaidStrokes laid(const StrokeSearch& search, const std::vector<StrokeChoice>& strokes) {
    LaidStrokes made;
    made.search = search;
    LineSet formed = no_lines(cache_.inputs().lines());
    for (const StrokeChoice& choice : strokes) {
      made.chosen.push_back({formed, choice});
      formed = joined(formed, choice.lines);
    }
    made.bed = bed_of(cache_, made.chosen);
    const double weight = cache_.inputs().options.weights.tool_change;
    const bool more = made.bed.count_more(weight, made.search.tool_changes, made.search.cost);
    made.is_dearer = more && weight > 0.0;
    return made;
  }

  StageCache& cache_;
};

}  // namespace

LaidStrokes laid_strokes(StageCache& cache, const StrokeSearch& search, const Progress& progress) {
  LeastSetUps least(cache);
  LaidStrokes first = least.run(search);
  const PlanOptions& options = cache.inputs().options;
  if (!first.is_dearer || options.limits.first) return first;
  StrokeSearch other = search;
  tell_strokes(with_fewer_set_ups(cache, problem_of(cache), first.search.cost, progress),
               options.weights, other);
  if (other.strokes.empty()) return first;
  LaidStrokes second = least.run(other);
  if (!LeastSetUps::is_cheaper(second, first)) return first;
  second.is_dearer = second.search.cost > search.cost * (1.0 + tolerance::kComputed);
  return second;
}

}  // namespace planish::brake_detail
