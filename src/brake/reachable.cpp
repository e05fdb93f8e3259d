// Which lines can be formed at all, when no order forms all: goes to every stage that can be
// reached, until each line that may be possible has been formed in one. Only explains a verdict,
// so it may give up.
#include "stroke_work.hpp"

namespace planish::brake_detail {
namespace {

constexpr std::int64_t kMostReached = 5'000;  // stages: the verdict is known, this only explains it

class Reaching {
 public:
  explicit Reaching(StrokeWork& work) : work_(work), book_(work.book()) {}

  bool run() {
    work_.look_for_reasons();
    reach(LineSet(book_.full().size()));
    while (!left_.empty() && !work_.all_seen()) {
      const int stage = left_.back();
      left_.pop_back();
      if (static_cast<std::int64_t>(reached_.size()) > kMostReached) return false;
      if (work_.stopped() != StrokeWork::Stop::none) return false;
      go_on(stage);
    }
    return true;
  }

 private:
  void reach(const LineSet& formed) {
    const int stage = book_.stage_of(formed);
    if (reached_.insert(stage).second && !book_.is_full(stage)) left_.push_back(stage);
  }

  void go_on(int stage) {
    const std::size_t offers = book_.offers(stage).size();
    for (std::size_t i = 0; i < offers; ++i) {
      const LineSet& lines = book_.choice(book_[stage].offers[i].choice).choice.lines;
      const LineSet after = joined(*book_[stage].formed, lines);
      // One way of forming them is enough.
      const auto known = book_.find(after);
      if (known && reached_.contains(*known)) continue;
      if (book_.feasible(stage, i)) reach(after);
    }
  }

  StrokeWork& work_;
  StageBook& book_;
  std::set<int> reached_;
  std::vector<int> left_;  ///< the last one first
};

}  // namespace

bool search_reachable(StrokeWork& work) { return Reaching(work).run(); }

}  // namespace planish::brake_detail
