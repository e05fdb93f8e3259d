// The cheapest order of strokes: first any plan depth first, with growing patience, then A*, both
// against a bound that is made again when more choices are known to be infeasible everywhere. A
// plan as cheap as the bound is proven without a search (math.md#bend-order, bend.md#search).
#include "refusals.hpp"
#include "stroke_work.hpp"

#include <planish/base/assert.hpp>
#include <planish/base/tolerance.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace planish {
namespace brake_detail {
namespace {

constexpr std::int64_t kQuickStages = 2'000;      // for a first plan
constexpr std::int64_t kMostOffers = 50'000'000;  // kept: 400 MB

}  // namespace

StrokeWork::StrokeWork(const StrokeProblem& problem, const StrokeWeights& weights,
                       const StrokeLimits& limits, const Progress& progress)
    : problem_(problem),
      weights_(weights),
      limits_(limits),
      progress_(progress),
      lines_(problem.lines),
      end_(limits.end(std::chrono::steady_clock::now())),
      most_checks_((problem.checks ? problem.checks() : 0) + limits.checks),
      book_(problem, weights),
      bound_(std::make_unique<StrokeBound>(problem, weights)),
      cheapest_(std::numeric_limits<double>::infinity()) {}

double StrokeWork::bound(const LineSet& formed, int set_up) {
  return (*bound_)(formed, set_up == kNoSetUp ? nullptr : &book_.set_up(set_up));
}

/// A possible choice of several lines may still be there for fewer of them.
bool StrokeWork::renew_bound() {
  if (book_.learned() == learned_known_) return false;
  learned_known_ = book_.learned();
  std::set<std::size_t> rows;
  for (std::size_t i = 0; i < problem_.possible.size(); ++i)
    if (count(problem_.possible[i].lines) == 1 && book_.is_refuted(problem_.possible[i]))
      rows.insert(i);
  if (rows == refuted_rows_) return false;
  refuted_rows_ = std::move(rows);
  bound_ = std::make_unique<StrokeBound>(problem_, weights_, refuted_rows_);
  return true;
}

void StrokeWork::found(const std::vector<int>& strokes) {
  const double cost = cost_of(book_, strokes);
  if (!cheaper(cost, cheapest_)) return;
  cheapest_ = cost;
  plan_ = strokes;
}

bool StrokeWork::cheaper(double cost, double than) const {
  if (std::isinf(than)) return !std::isinf(cost);
  return cost < than - tolerance::kComputed * (1.0 + std::abs(than));
}

/// Looking through this many offers takes as long as a check.
std::int64_t StrokeWork::checks() const {
  constexpr std::int64_t kOffers = 200;
  return (problem_.checks ? problem_.checks() : 0) + book_.offers_kept() / kOffers;
}

StrokeWork::Stop StrokeWork::stopped() {
  if (progress_.should_stop()) return Stop::cancelled;
  const bool over = book_.asked() >= limits_.stages || book_.offers_kept() > kMostOffers ||
                    (problem_.checks && checks() >= most_checks_);
  if (over) return Stop::limit;
  return std::chrono::steady_clock::now() > end_ ? Stop::time : Stop::none;
}

void StrokeWork::look_for_reasons() {
  // Shares of what the search may do. That no stroke can be the last is a reason by itself.
  constexpr std::int64_t kShare = 4, kShareBesides = 40;
  if (problem_.checks)
    most_checks_ = checks() + limits_.checks / (knows_no_end_ ? kShareBesides : kShare);
}

int StrokeWork::depth_of(const StrokeChoice& choice) const {
  if (!knows_depth()) return 0;
  int depth = std::numeric_limits<int>::max();
  for (const int line : members(choice.lines))
    depth = std::min(depth, problem_.depth[line]);
  return depth;
}

bool StrokeWork::all_seen() const {
  for (int line = 0; line < lines_; ++line)
    if (!book_.seen(line) && !std::ranges::binary_search(bound_->hopeless(), line)) return false;
  return true;
}

double cost_of(const StageBook& book, const std::vector<int>& strokes) {
  double cost = 0.0;
  int set_up = kNoSetUp;
  for (const int stroke : strokes) {
    const KnownChoice& known = book.choice(stroke);
    cost += book.change(set_up, known.set_up) + known.cost;
    set_up = known.set_up;
  }
  return cost;
}

void tell_strokes(std::vector<StrokeChoice> strokes, const StrokeWeights& weights,
                  StrokeSearch& result) {
  result.cost = 0.0;
  result.turn_overs = result.rotations = result.tool_changes = 0;
  result.ungauged = result.v_away = 0;
  std::optional<SetUp> before;
  for (const StrokeChoice& stroke : strokes) {
    const SetUp now = set_up_of(stroke);
    result.cost += weights.of(stroke) + (before ? before->change_to(now, weights) : 0.0);
    result.ungauged += stroke.gauged ? 0 : 1;
    result.v_away += stroke.v_away;
    if (before) {
      result.turn_overs += before->reference_up != now.reference_up ? 1 : 0;
      result.rotations += before->direction != now.direction ? 1 : 0;
      result.tool_changes += before->has_same_tools(now) ? 0 : 1;
    }
    before = now;
  }
  result.strokes = std::move(strokes);
}

}  // namespace brake_detail

std::chrono::steady_clock::time_point StrokeLimits::end(
    std::chrono::steady_clock::time_point start) const {
  constexpr double kLongest = 1e6;  // s: clocks count in 64 bits
  const std::chrono::duration<double> taken(std::min(seconds, kLongest));
  return std::min(until,
                  start + std::chrono::duration_cast<std::chrono::steady_clock::duration>(taken));
}

namespace {

using namespace brake_detail;

bool is_weight(double weight) { return weight >= 0.0 && std::isfinite(weight); }

Result<void> check_input(const StrokeProblem& problem, const StrokeWeights& weights) {
  PLANISH_ASSERT(problem.lines >= 0 && problem.choices);
  PLANISH_ASSERT(problem.depth.empty() || std::ssize(problem.depth) == problem.lines);
  for (const double weight : {weights.turn_over, weights.rotate, weights.tool_change,
                              weights.stroke, weights.ungauged, weights.v})
    if (!is_weight(weight))
      return fail(refuse::bad_weight, {{"value", weight, unit::none}}, "weights");
  for (const int line : problem.begin_with)
    PLANISH_ASSERT(line >= 0 && line < problem.lines);
  return {};
}

/// Looks for any plan, with more and more patience. Returns whether it is known that there is none.
/// Mostly there is one, and it is found at once; who wants no reasons tries what mostly is of no
/// use, so that first it is asked whether any stroke can be the last.
bool look_for_plan(StrokeWork& work) {
  if (!work.wants_reasons() && !work.can_end()) return true;
  for (const std::int64_t patience : {std::int64_t{0}, kQuickStages / 20, kQuickStages}) {
    for (const Guide guide :
         {Guide::cost, Guide::outside_in, Guide::first_line, Guide::last_line}) {
      if (guide == Guide::outside_in && !work.knows_depth()) continue;
      const bool ended = search_depth_first(work, {}, patience, guide);
      if (work.has_plan()) return false;
      work.renew_bound();
      if (ended || !work.hopeless().empty()) return true;
    }
    if (patience == 0 && work.wants_reasons() && !work.can_end()) return true;
  }
  return false;
}

/// Whether the search ended by itself: with the cheapest plan, or knowing that there is none.
bool run(StrokeWork& work, const StrokeLimits& limits) {
  const bool exhausted = look_for_plan(work);
  work.renew_bound();
  work.prove(work.bound(LineSet(work.book().full().size()), kNoSetUp));
  if (exhausted || !work.hopeless().empty()) return true;
  if (work.has_plan() && (limits.first || !work.cheaper(work.proven(), work.cheapest())))
    return !work.cheaper(work.proven(), work.cheapest());
  return search_best_first(work);
}

void tell_plan(StrokeSearch& result, StrokeWork& work, const StrokeWeights& weights) {
  std::vector<StrokeChoice> strokes;
  for (const int stroke : work.plan())
    strokes.push_back(work.book().choice(stroke).choice);
  tell_strokes(std::move(strokes), weights, result);
}

void tell_blocked(StrokeSearch& result, StrokeWork& work, int lines) {
  result.status = PlanStatus::infeasible;
  result.none_last = work.knows_no_end();
  const bool all = work.wants_reasons() && search_reachable(work);
  result.blocked_all = all;
  for (int line = 0; line < lines; ++line)
    if (all ? !work.book().seen(line) : std::ranges::binary_search(work.hopeless(), line))
      result.blocked.push_back(line);
}

}  // namespace

Result<StrokeSearch> search_strokes(const StrokeProblem& problem, const StrokeWeights& weights,
                                    const StrokeLimits& limits, const Progress& progress) {
  if (auto fine = check_input(problem, weights); !fine) return pass_on(fine);
  StrokeSearch result;
  if (problem.lines == 0) {
    result.status = PlanStatus::optimal;
    return result;
  }
  StrokeWork work(problem, weights, limits, progress);
  const bool ended = run(work, limits);
  if (work.stopped() == StrokeWork::Stop::cancelled) return fail(refuse::ordering_cancelled);
  if (work.has_plan()) {
    result.status = ended ? PlanStatus::optimal : PlanStatus::feasible;
    tell_plan(result, work, weights);
  } else {
    if (ended) tell_blocked(result, work, problem.lines);
    result.furthest = work.book().furthest();
  }
  const bool complete = ended && result.blocked_all;
  result.timed_out = !complete && work.stopped() == StrokeWork::Stop::time;
  result.stages = work.book().asked();
  result.bound = work.has_plan() && ended ? result.cost : work.proven();
  return result;
}

}  // namespace planish
