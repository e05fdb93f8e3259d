// Orders of many lines: first those from the outside in, which are few and mostly contain a good
// one, within a share of the time, then all. The cheaper plan counts; the bound is that of the
// whole search (math.md#bend-order).
#include "plan_search.hpp"

#include "check.hpp"
#include "choices.hpp"
#include "line_depth.hpp"

#include <algorithm>
#include <chrono>

namespace planish::brake_detail {
namespace {

std::vector<StrokeChoice> outermost(StageCache& cache, const LineSet& formed) {
  std::vector<StrokeChoice> all = choices(cache, formed);
  std::erase_if(all, [&](const auto& choice) { return !is_outermost(cache, formed, choice); });
  return all;
}

}  // namespace

StrokeProblem problem_of(StageCache& cache) {
  const StrokeInputs& inputs = cache.inputs();
  StrokeProblem problem;
  problem.lines = inputs.lines();
  problem.choices = [&cache](const LineSet& formed) { return choices(cache, formed); };
  problem.check = [&cache](const LineSet& formed, const StrokeChoice& choice) {
    return check(cache, formed, choice);
  };
  problem.checks = [&cache] { return cache.checks(); };
  problem.possible = possible(inputs);
  problem.depth = line_depths(inputs.work);
  for (const BendId bend : inputs.options.begin_with)
    for (int i = 0; i < problem.lines; ++i) {
      const auto& bends = inputs.work.lines[i].bends;
      if (std::ranges::count(bends, bend)) problem.begin_with.push_back(i);
    }
  return problem;
}

Result<StrokeSearch> search_plan(StageCache& cache, const Progress& progress) {
  constexpr int kMany = 14;           // lines: fewer are searched whole in a moment
  constexpr double kOutsideIn = 0.4;  // share of the work and of the time
  const PlanOptions& options = cache.inputs().options;
  const StrokeProblem whole = problem_of(cache);
  StrokeLimits limits = options.limits;
  std::optional<StrokeSearch> outside_in;
  const auto start = std::chrono::steady_clock::now();
  const std::int64_t before = whole.checks();
  if (whole.lines > kMany) {
    StrokeProblem narrow = whole;
    narrow.choices = [&cache](const LineSet& formed) { return outermost(cache, formed); };
    limits.seconds *= kOutsideIn;
    limits.checks = static_cast<std::int64_t>(kOutsideIn * static_cast<double>(limits.checks));
    limits.reasons = false;
    auto found = search_strokes(narrow, options.weights, limits, progress);
    // What is outermost does not matter to the last stroke.
    if (!found || found->none_last) return found;
    if (!found->strokes.empty()) outside_in = std::move(*found);
    if (outside_in && options.limits.first) return *outside_in;
  }
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  const std::int64_t done = whole.checks() - before;
  limits = options.limits;
  limits.checks -= done;
  limits.seconds = std::max(0.0, options.limits.seconds - taken.count());
  auto found = search_strokes(whole, options.weights, limits, progress);
  const bool better = found && outside_in &&
                      (found->strokes.empty() || outside_in->cost < found->cost) &&
                      found->status != PlanStatus::optimal;
  if (!better) return found;
  outside_in->status = PlanStatus::feasible;
  outside_in->bound = found->bound;
  outside_in->stages += found->stages;
  return *outside_in;
}

}  // namespace planish::brake_detail
