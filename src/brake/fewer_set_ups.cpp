// The search for an order (best_first.cpp) knows which tools may stand together, not whether their
// segments do for all strokes. Where its plan takes more set-ups than it counted, orders are looked
// through once more, each stage with what stands on the bed: line by line, of the stages with
// equally many lines formed those that may become cheapest (a beam search). What must hold: a cost
// with set-ups is never below the one without, so the same bound holds (math.md#stations).
#include "fewer_set_ups.hpp"

#include "on_bed.hpp"
#include "stage_book.hpp"
#include "stroke_bound.hpp"

#include <planish/base/search.hpp>
#include <planish/base/tolerance.hpp>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <unordered_map>

namespace planish::brake_detail {
namespace {

constexpr int kMostLaid = 6'000;  // strokes put on a bed: some seconds
/// Stages of equally many lines that are gone on with.
constexpr int kNarrowest = 15, kWidest = 1'000, kWider = 5;
constexpr double kAsMuchRoom = 10.0;  // mm of bed

/// A stroke on the way to a plan; until its tools are laid, its cost is at least that.
struct Node {
  int stage = 0;  ///< before the stroke
  int choice = 0;
  int before = -1;  ///< the node that it follows
  double cost = 0.0;
  bool laid = false;
  StrokeChoice made = {};  ///< with the tools that stand there
  std::shared_ptr<const OnBed> bed = {};
};

/// How a stage and set-up was reached.
struct Way {
  double cost = 0.0;
  LineSet on_bed;        ///< lines that what stands is for
  double bed_end = 0.0;  ///< mm
};

struct Waiting {
  double estimate = 0.0;  ///< of the cheapest plan through a node
  int node = 0;
};

struct Dearer {
  bool operator()(const Waiting& a, const Waiting& b) const {
    return std::tuple(a.estimate, a.node) > std::tuple(b.estimate, b.node);
  }
};

class BedSearch {
 public:
  BedSearch(StageCache& cache, const StrokeProblem& problem, double than)
      : cache_(cache),
        weights_(cache.inputs().options.weights),
        book_(problem, weights_),
        bound_(problem, weights_),
        than_(than) {}

  /// Beams of more and more stages: a narrow one comes to an end soon, and bounds the next.
  std::vector<StrokeChoice> run(const Progress& progress) {
    const PlanOptions& options = cache_.inputs().options;
    const std::int64_t most_checks = cache_.checks() + options.limits.checks / 2;
    const auto end = options.limits.end(std::chrono::steady_clock::now());
    const auto is_over = [&] {
      return laid_ >= kMostLaid || cache_.checks() >= most_checks || progress.should_stop() ||
             std::chrono::steady_clock::now() > end;
    };
    std::vector<StrokeChoice> best;
    for (int width = kNarrowest; width <= kWidest && !is_over(); width *= kWider)
      if (const auto last = cheapest_in_beam(width, is_over)) {
        best = strokes_to(*last);
        than_ = nodes_[*last].cost;
      }
    return best;
  }

 private:
  /// The last stroke of a plan, if one is found that costs less than the best so far.
  template <typename IsOver>
  std::optional<int> cheapest_in_beam(int width, const IsOver& is_over) {
    const int lines = cache_.inputs().lines();
    nodes_.clear();
    reached_.clear();
    layers_.clear();
    layers_.resize(lines + 1);
    offer(book_.stage_of(no_lines(lines)), -1);
    for (int formed = 1; formed <= lines; ++formed) {
      Frontier<Waiting, Dearer>& layer = layers_[formed];
      for (int gone_on = 0; gone_on < width && !layer.empty() && !is_over();) {
        const int node = layer.take().node;
        if (!nodes_[node].laid && !lay(node)) continue;
        if (formed == lines) return node;
        offer(book_.stage_of(formed_after(nodes_[node])), node);
        ++gone_on;
      }
    }
    return std::nullopt;
  }

  int set_up(int node) const { return book_.choice(nodes_[node].choice).set_up; }

  LineSet formed_after(const Node& node) const {
    return joined(*book_[node.stage].formed, book_.choice(node.choice).choice.lines);
  }

  bool is_cheaper(double cost) const { return cost < than_ - tolerance::kComputed * (1.0 + than_); }

  double estimate(const Node& node) {
    const int after = book_.choice(node.choice).set_up;
    return node.cost + bound_(formed_after(node), &book_.set_up(after));
  }

  void wait(int node) {
    const double least = estimate(nodes_[node]);
    if (is_cheaper(least)) layers_[count(formed_after(nodes_[node]))].add({least, node});
  }

  /// The strokes of a stage, one for all tools that stand on the same bed.
  void offer(int stage, int before) {
    std::unordered_map<LineSet, std::set<std::pair<int, double>>, LineSetHash> offered;
    for (const Offer& offer : book_.offers(stage)) {
      const KnownChoice& known = book_.choice(offer.choice);
      if (!offered[known.choice.lines].emplace(known.set_up, known.cost).second) continue;
      Node node{stage, offer.choice, before, known.cost};
      if (before >= 0)
        node.cost += nodes_[before].cost + book_.change(set_up(before), known.set_up);
      nodes_.push_back(std::move(node));
      wait(static_cast<int>(nodes_.size()) - 1);
    }
  }

  /// Takes tools that make a stroke: of those that stand on the same bed the first ones.
  bool find_tools(Node& node) {
    const KnownChoice wanted = book_.choice(node.choice);
    const std::size_t offers = book_.offers(node.stage).size();
    for (std::size_t i = 0; i < offers; ++i) {
      const int choice = book_[node.stage].offers[i].choice;
      const KnownChoice& known = book_.choice(choice);
      if (known.set_up != wanted.set_up || known.cost != wanted.cost ||
          known.choice.lines != wanted.choice.lines || !book_.feasible(node.stage, i))
        continue;
      node.choice = choice;
      node.made = known.choice;
      return true;
    }
    return false;
  }

  /// Puts the tools of a stroke on the bed, a cleared one if need be. Whether to go on from there:
  /// not where that makes it dearer, or a way as cheap is known.
  bool lay(int number) {
    Node& node = nodes_[number];
    node.laid = true;
    if (!find_tools(node)) return false;
    const WantedPtr stroke = wanted(node);
    ++laid_;
    std::optional<OnBed> with;
    bool dearer = false;
    if (node.before >= 0 &&
        set_up_of(nodes_[node.before].made).has_same_tools(set_up_of(node.made))) {
      with = with_stroke(cache_, *nodes_[node.before].bed, stroke);
      dearer = !with;
      if (dearer) node.cost += weights_.tool_change;
    }
    if (!with) with = with_stroke(cache_, {}, stroke);
    if (!with || is_known(node, *with)) return false;
    node.bed = std::make_shared<OnBed>(std::move(*with));
    if (dearer) wait(number);
    return !dearer;
  }

  WantedPtr wanted(const Node& node) {
    WantedPtr& known = wanted_[{node.stage, node.choice}];
    if (!known) {
      const LineSet& formed = *book_[node.stage].formed;  // no two strokes of a plan have the same
      known = std::make_shared<Wanted>(cache_, ChosenStroke{formed, node.made}, count(formed));
    }
    return known;
  }

  /// Whether a way to the same stage and set-up is known that is no dearer, with fewer lines to
  /// stand for and as much room left, or with a bed cleared besides.
  bool is_known(const Node& node, const OnBed& bed) {
    Way way{node.cost, no_lines(cache_.inputs().lines()),
            starts_of(bed.stations, cache_.inputs().options.clearance).back()};
    for (const WantedPtr& stroke : bed.strokes)
      way.on_bed = joined(std::move(way.on_bed), stroke->chosen()->choice.lines);
    auto& ways = reached_[{formed_after(node), book_.choice(node.choice).set_up}];
    for (const Way& known : ways)
      if (known.cost + weights_.tool_change <= way.cost ||
          (known.cost <= way.cost && within(known.on_bed, way.on_bed) &&
           known.bed_end <= way.bed_end + kAsMuchRoom))
        return true;
    ways.push_back(std::move(way));
    return false;
  }

  std::vector<StrokeChoice> strokes_to(int node) const {
    std::vector<StrokeChoice> strokes;
    for (; node >= 0; node = nodes_[node].before)
      strokes.push_back(nodes_[node].made);
    std::ranges::reverse(strokes);
    return strokes;
  }

  StageCache& cache_;
  const StrokeWeights& weights_;
  StageBook book_;
  StrokeBound bound_;
  double than_;
  int laid_ = 0;
  std::vector<Node> nodes_;
  std::vector<Frontier<Waiting, Dearer>> layers_;    ///< by lines formed
  std::map<std::pair<int, int>, WantedPtr> wanted_;  ///< by stage and choice
  std::map<std::pair<LineSet, int>, std::vector<Way>> reached_;
};

}  // namespace

std::vector<StrokeChoice> with_fewer_set_ups(StageCache& cache, const StrokeProblem& problem,
                                             double than, const Progress& progress) {
  return BedSearch(cache, problem, than).run(progress);
}

}  // namespace planish::brake_detail
