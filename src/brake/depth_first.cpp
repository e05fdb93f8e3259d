// Looks for any plan: from a stage the most promising stroke first, until all lines are formed;
// where no stroke leads on it turns back, and the stage is dead. What must hold: a dead stage
// stays dead, since what can be formed from it does not depend on how it was reached
// (math.md#stages, bend.md#search).
#include "stroke_work.hpp"

#include <algorithm>
#include <functional>
#include <tuple>

namespace planish::brake_detail {
namespace {

struct Step {
  int depth = 0;      ///< the guide's, before the cost
  double cost = 0.0;  ///< estimated, of the whole plan
  std::size_t offer = 0;
};

struct Level {
  int stage = 0;
  int set_up = kNoSetUp;
  std::vector<Step> steps = {};  ///< still to be tried, the best last
};

class Descent {
 public:
  Descent(StrokeWork& work, Guide guide) : work_(work), book_(work.book()), guide_(guide) {}

  bool run(const std::vector<int>& strokes, std::int64_t most_stages) {
    const std::int64_t end = book_.asked() + most_stages;
    start_from(strokes);
    while (!levels_.empty()) {
      if (!work_.hopeless().empty()) return true;
      if (work_.stopped() != StrokeWork::Stop::none) return false;
      if (book_.is_full(levels_.back().stage)) {
        work_.found(strokes_);
        return true;
      }
      if (step_down()) continue;
      step_back();
      if (most_stages == 0 || book_.asked() > end) return false;
      renew_bound();
    }
    return true;
  }

 private:
  void start_from(const std::vector<int>& strokes) {
    strokes_ = strokes;
    LineSet formed(book_.full().size());
    for (const int stroke : strokes)
      formed = joined(std::move(formed), book_.choice(stroke).choice.lines);
    enter(book_.stage_of(formed), strokes.empty() ? kNoSetUp : book_.choice(strokes.back()).set_up);
    given_ = strokes.size();
  }

  /// A new bound only changes the order. It is made seldom enough to cost little.
  void renew_bound() {
    if (book_.asked() < next_renewal_) return;
    next_renewal_ = 2 * book_.asked();
    work_.renew_bound();
  }

  void enter(int stage, int set_up) {
    levels_.push_back({stage, set_up});
    if (book_.is_full(stage)) return;
    const std::vector<Offer>& offers = book_.offers(stage);
    std::vector<Step>& steps = levels_.back().steps;
    for (std::size_t i = 0; i < offers.size(); ++i)
      if (offers[i].state != Offer::State::infeasible) steps.push_back(step(stage, set_up, i));
    // Of equal ones those are tried first that are offered first.
    std::ranges::sort(steps, std::greater(),
                      [](const Step& s) { return std::tuple(s.depth, s.cost, s.offer); });
  }

  Step step(int stage, int set_up, std::size_t offer) {
    const KnownChoice& known = book_.choice(book_.offers(stage)[offer].choice);
    const LineSet after = joined(*book_[stage].formed, known.choice.lines);
    const int depth = guided(known.choice);
    return {depth,
            book_.change(set_up, known.set_up) + known.cost + work_.bound(after, known.set_up),
            offer};
  }

  int guided(const StrokeChoice& choice) const {
    switch (guide_) {
      case Guide::outside_in:
        return work_.depth_of(choice);
      case Guide::first_line:
        return members(choice.lines).front();
      case Guide::last_line:
        return -members(choice.lines).back();
      case Guide::cost:
        break;
    }
    return 0;
  }

  /// Whether a stroke leads to a stage from which not everything has been tried.
  bool step_down() {
    Level& level = levels_.back();
    // What was learned below may show that nothing leads on from here.
    while (!level.steps.empty() && !book_.is_dead(*book_[level.stage].formed)) {
      const Step next = level.steps.back();
      level.steps.pop_back();
      const int choice = book_.offers(level.stage)[next.offer].choice;
      const LineSet after = joined(*book_[level.stage].formed, book_.choice(choice).choice.lines);
      if (book_.is_dead(after) || !book_.feasible(level.stage, next.offer)) continue;
      strokes_.push_back(choice);
      enter(book_.stage_of(after), book_.choice(choice).set_up);
      return true;
    }
    return false;
  }

  void step_back() {
    book_.mark_dead(levels_.back().stage);
    levels_.pop_back();
    if (strokes_.size() > given_) strokes_.pop_back();
  }

  StrokeWork& work_;
  StageBook& book_;
  Guide guide_;
  std::vector<Level> levels_;
  std::vector<int> strokes_;
  std::size_t given_ = 0;
  std::int64_t next_renewal_ = 1;
};

}  // namespace

bool search_depth_first(StrokeWork& work, const std::vector<int>& strokes, std::int64_t most_stages,
                        Guide guide) {
  return Descent(work, guide).run(strokes, most_stages);
}

}  // namespace planish::brake_detail
