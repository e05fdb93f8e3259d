// A* over stages, each with the set-up that led to it. Strokes of one estimate are tried together,
// dearer ones wait. To change tools they are first taken off, which leads to a node without any: so
// each set-up of a stage tries the strokes of its own tools, and only one of them all others. What
// must hold: the bound never exceeds what is to come, and grows by no more
// than a stroke costs; then the first full stage is the cheapest, and of two ways to a stage one
// can be dropped that is not cheaper even with the change to the other's set-up
// (math.md#bend-order, bend.md#search).
#include "stroke_work.hpp"

#include <planish/base/search.hpp>

#include <algorithm>
#include <limits>
#include <map>

namespace planish::brake_detail {
namespace {

constexpr int kBetweenDives = 200;  // expansions

/// A stage with the set-up of the stroke that led to it, or without its tools.
struct Node {
  int stage = 0, set_up = kNoSetUp;
  double cost = 0.0;  ///< so far
  int before = -1;    ///< the node that it came from
  int stroke = -1;    ///< the choice that led here; −1: only the tools were taken off
};

/// A node whose strokes of one estimate are to be tried: most strokes are dearer and wait.
struct Waiting {
  double estimate = 0.0;  ///< of the cheapest plan through those strokes
  double tried = 0.0;     ///< up to this estimate all are
  int formed = 0;         ///< lines
  int node = 0;
};

/// The cheapest first; of equal ones that with the most lines formed, then the latest.
struct Dearer {
  bool operator()(const Waiting& a, const Waiting& b) const {
    if (a.estimate != b.estimate) return a.estimate > b.estimate;
    if (a.formed != b.formed) return a.formed < b.formed;
    return a.node < b.node;
  }
};

class BestFirst {
 public:
  explicit BestFirst(StrokeWork& work) : work_(work), book_(work.book()) {}

  enum class End { done, stopped, bound_renewed };

  End run() {
    begin();
    for (std::int64_t n = 1; !open_.empty(); ++n) {
      const Waiting next = open_.best();
      if (!work_.cheaper(next.estimate, work_.cheapest())) break;
      work_.prove(next.estimate);
      if (work_.stopped() != StrokeWork::Stop::none) return End::stopped;
      open_.take();
      const Node& node = nodes_[next.node];
      // A cheaper way may have been found since.
      if (least_known(node) < node.cost || book_.is_dead(*book_[node.stage].formed)) continue;
      expand(next);
      if (n % kBetweenDives == 0) improve(next.node);
      if (is_power_of_two(n) && work_.renew_bound()) return End::bound_renewed;
    }
    return End::done;
  }

 private:
  static constexpr double kNothing = -std::numeric_limits<double>::infinity();
  static bool is_power_of_two(std::int64_t n) { return (n & (n - 1)) == 0; }

  void begin() {
    const int stage = book_.stage_of(LineSet(book_.full().size()));
    add({stage});
  }

  double estimate(const Node& node) {
    return node.cost + work_.bound(*book_[node.stage].formed, node.set_up);
  }

  void add(const Node& node) {
    const int number = static_cast<int>(nodes_.size());
    nodes_.push_back(node);
    stage(node.stage).of_tools[tools_of(node.set_up)].push_back({node.set_up, node.cost});
    open_.add({estimate(node), kNothing, count(*book_[node.stage].formed), number});
    if (node.set_up == kNoSetUp || !book_.set_up(node.set_up).has_tools()) return;
    Node bare{node.stage, book_.set_up_of(book_.set_up(node.set_up).without_tools()), 0.0, number};
    bare.cost = node.cost + book_.change(node.set_up, bare.set_up);
    if (least_known(bare) > bare.cost) add(bare);
  }

  /// What is known of a stage.
  struct Reached {
    using Way = std::pair<int, double>;  // set-up and cost
    std::map<std::pair<int, int>, std::vector<Way>> of_tools;
    std::map<std::pair<int, int>, std::vector<std::size_t>> offers;  ///< by tools
  };
  Reached& stage(int number) {
    if (std::ssize(stages_) <= number) stages_.resize(static_cast<std::size_t>(number) + 1);
    return stages_[static_cast<std::size_t>(number)];
  }

  std::pair<int, int> tools_of(int set_up) const {
    if (set_up == kNoSetUp) return {kNoTools, kNoTools};
    return {book_.set_up(set_up).punch, book_.set_up(set_up).die};
  }

  /// The least that a known way to the node's stage costs, with the change to the node's set-up. A
  /// way with other tools is known as one without tools.
  double least_known(const Node& node) {
    double least = std::numeric_limits<double>::infinity();
    const Reached& reached = stage(node.stage);
    for (const auto& tools : {tools_of(node.set_up), std::pair(kNoTools, kNoTools)}) {
      const auto ways = reached.of_tools.find(tools);
      if (ways == reached.of_tools.end()) continue;
      for (const auto& [set_up, cost] : ways->second)
        least = std::min(least, cost + book_.change(set_up, node.set_up));
    }
    return least;
  }

  /// The strokes that a node may go on with: of its tools, or of all.
  const std::vector<std::size_t>& offers_of(const Node& node) {
    const std::size_t count = book_.offers(node.stage).size();
    auto& offers = stage(node.stage).offers;
    if (offers.empty())
      for (std::size_t i = 0; i < count; ++i) {
        const int set_up = book_.choice(book_[node.stage].offers[i].choice).set_up;
        offers[tools_of(set_up)].push_back(i);
        offers[{kNoTools, kNoTools}].push_back(i);
      }
    return offers[tools_of(node.set_up)];
  }

  void expand(const Waiting& waiting) {
    const Node from = nodes_[waiting.node];
    double later = std::numeric_limits<double>::infinity();
    const std::vector<std::size_t> offers = offers_of(from);
    for (const std::size_t i : offers) {
      const Offer& offer = book_[from.stage].offers[i];
      if (offer.state == Offer::State::infeasible) continue;
      const double estimate = through(from, offer.choice);
      if (estimate <= waiting.tried) continue;
      if (work_.cheaper(waiting.estimate, estimate)) {
        later = std::min(later, estimate);
      } else {
        try_stroke(waiting.node, i);
      }
    }
    if (work_.cheaper(later, work_.cheapest()))
      open_.add({later, tried_below(waiting.estimate, later), waiting.formed, waiting.node});
  }

  /// Estimates that differ by rounding alone have been tried together.
  double tried_below(double estimate, double later) const { return 0.5 * (estimate + later); }

  double through(const Node& from, int choice) {
    const KnownChoice& known = book_.choice(choice);
    const double cost = from.cost + book_.change(from.set_up, known.set_up) + known.cost;
    return cost + work_.bound(joined(*book_[from.stage].formed, known.choice.lines), known.set_up);
  }

  void try_stroke(int number, std::size_t offer) {
    const Node from = nodes_[number];
    const int choice = book_[from.stage].offers[offer].choice;
    const LineSet after = joined(*book_[from.stage].formed, book_.choice(choice).choice.lines);
    if (book_.is_dead(after)) return;
    Node next{0, book_.choice(choice).set_up, 0.0, number, choice};
    next.cost = from.cost + book_.change(from.set_up, next.set_up) + book_.choice(choice).cost;
    if (const auto known = book_.find(after)) {
      next.stage = *known;
      if (least_known(next) <= next.cost) return;
    }
    if (!book_.feasible(from.stage, offer)) return;
    next.stage = book_.stage_of(after);
    if (!book_.is_full(next.stage)) return add(next);
    auto strokes = strokes_to(number);
    strokes.push_back(choice);
    work_.found(strokes);
  }

  std::vector<int> strokes_to(int number) const {
    std::vector<int> strokes;
    for (int node = number; nodes_[node].before >= 0; node = nodes_[node].before)
      if (nodes_[node].stroke >= 0) strokes.push_back(nodes_[node].stroke);
    std::ranges::reverse(strokes);
    return strokes;
  }

  /// A plan by way of a promising node, so that a search that is stopped has a good one.
  void improve(int number) {
    const bool outside = work_.knows_depth() && ++dives_ % 2 == 0;
    search_depth_first(work_, strokes_to(number), 0, outside ? Guide::outside_in : Guide::cost);
  }

  StrokeWork& work_;
  StageBook& book_;
  std::vector<Node> nodes_;
  int dives_ = 0;
  std::vector<Reached> stages_;
  Frontier<Waiting, Dearer> open_;
};

}  // namespace

bool search_best_first(StrokeWork& work) {
  for (;;) {
    const BestFirst::End end = BestFirst(work).run();
    if (end != BestFirst::End::bound_renewed) return end == BestFirst::End::done;
  }
}

}  // namespace planish::brake_detail
