#pragma once

#include "stage_book.hpp"
#include "stroke_bound.hpp"

#include <algorithm>
#include <chrono>
#include <memory>
#include <set>
#include <vector>

namespace planish::brake_detail {

/// What all parts of a search share: the stages, the bound, the best plan so far, and how far it
/// may go.
class StrokeWork {
 public:
  StrokeWork(const StrokeProblem& problem, const StrokeWeights& weights, const StrokeLimits& limits,
             const Progress& progress);

  StageBook& book() { return book_; }
  /// A bound on the costs that are to come from a stage on.
  double bound(const LineSet& formed, int set_up);
  /// Makes the bound narrower if more choices are known to be infeasible everywhere; whether it
  /// was.
  bool renew_bound();
  /// Lines that no stage can form, whatever is reached.
  const std::vector<int>& hopeless() const { return bound_->hopeless(); }

  double cheapest() const { return cheapest_; }
  /// How far inside the lines of a choice are; 0 if that is not known.
  int depth_of(const StrokeChoice& choice) const;
  bool knows_depth() const { return !problem_.depth.empty(); }
  const std::vector<int>& plan() const { return plan_; }  ///< numbers of choices
  bool has_plan() const { return !plan_.empty(); }
  /// Keeps a plan if it is cheaper than the best.
  void found(const std::vector<int>& strokes);
  /// Whether costs differ by more than rounding.
  bool cheaper(double cost, double than) const;

  /// No plan costs less than the largest of these.
  void prove(double bound) { proven_ = std::max(proven_, bound); }
  double proven() const { return proven_; }
  /// Whether every line that may be possible at all has been formed in a stage that can be reached.
  bool all_seen() const;

  /// Whether some stroke can be the last, as far as is known (StageBook).
  bool can_end() {
    knows_no_end_ = !book_.can_end();
    return !knows_no_end_;
  }
  bool knows_no_end() const { return knows_no_end_; }

  bool wants_reasons() const { return limits_.reasons; }

  /// Why the search ends before it is done.
  enum class Stop { none, limit, time, cancelled };
  Stop stopped();
  /// What was done so far, counted in checks.
  std::int64_t checks() const;
  /// Grants the search for reasons a share of the work besides.
  void look_for_reasons();

 private:
  const StrokeProblem& problem_;
  StrokeWeights weights_;
  StrokeLimits limits_;
  const Progress& progress_;
  int lines_;
  std::chrono::steady_clock::time_point end_;
  std::int64_t most_checks_;
  StageBook book_;
  std::unique_ptr<StrokeBound> bound_;
  std::set<std::size_t> refuted_rows_;
  std::int64_t learned_known_ = 0;
  bool knows_no_end_ = false;
  double cheapest_;
  double proven_ = 0.0;
  std::vector<int> plan_;
};

/// Which stroke is the most promising: the one by which the plan may become cheapest, the one
/// that is farthest outside, or that of the first or last line: one end of the part to the other.
enum class Guide { cost, outside_in, first_line, last_line };

/// Goes down from the stage that strokes lead to, the most promising stroke first, until all lines
/// are formed. Where no stroke can be made it turns back, but not once it has looked at
/// `most_stages` new ones. Returns whether it ended by itself: with a plan, or with nothing left to
/// try because there is none.
bool search_depth_first(StrokeWork& work, const std::vector<int>& strokes, std::int64_t most_stages,
                        Guide guide);

/// A*: finds the cheapest plan, or that there is none. Returns whether it was not stopped.
bool search_best_first(StrokeWork& work);

/// Goes to all stages that can be reached, until every line is formed in one that may be formed in
/// any. Returns whether there is nothing left to see; it ends early after a while.
bool search_reachable(StrokeWork& work);

/// Cost of a sequence of choices.
double cost_of(const StageBook& book, const std::vector<int>& strokes);

/// Strokes as what a search found, with their changes and cost.
void tell_strokes(std::vector<StrokeChoice> strokes, const StrokeWeights& weights,
                  StrokeSearch& result);

}  // namespace planish::brake_detail
