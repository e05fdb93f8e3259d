#include "outline_run.hpp"
#include "pair_search.hpp"

#include <algorithm>
#include <numeric>
#include <set>
#include <tuple>

// Every choice of edges that may be worth fitting, in the order of the objective. For
// each frame there are the optima of several trade-offs with their alternatives, each edge and each
// two neighbours, and what is left of facing edges above the height that a bend of some radius
// needs. Each choice is kept once.

namespace planish::connect_detail {
namespace {

// Pairs of runs beyond this number are left out: plates with so many edges are searched as wholes.
constexpr std::size_t kMostPairs = 4000;

/// Collects choices, each once.
class Choices {
 public:
  void add(PairChoice choice) {
    const EdgeChoice& best = choice.search.best;
    std::array edges = choice.edges(best);
    for (auto& side : edges)
      std::ranges::sort(side);
    const Vec3& e = choice.frame.e[0];
    const Vec3& f = choice.frame.e[1];
    if (!known_
             .insert({best.kind,
                      edges[0],
                      edges[1],
                      {e.x(), e.y(), e.z(), f.x(), f.y(), f.z(), best.width}})
             .second)
      return;
    all_.push_back(std::move(choice));
  }

  /// By the objective of math.md#widest-bend on what remains: of the shortest one and all that are
  /// wider for no more than the trade-off allows, the widest first; then the same of the rest.
  std::vector<PairChoice> best_first(double trade_off) && {
    std::vector<std::size_t> order(all_.size());
    std::iota(order.begin(), order.end(), 0);
    const auto span = [&](std::size_t i) { return all_[i].search.best.span; };
    const auto width = [&](std::size_t i) { return all_[i].search.best.width; };
    std::ranges::stable_sort(order, {}, span);
    for (auto from = order.begin(); from != order.end();) {
      const double budget = span(*from) - trade_off * width(*from);
      const auto rest = std::stable_partition(from, order.end(), [&](std::size_t i) {
        return span(i) - trade_off * width(i) <= budget;
      });
      std::stable_sort(from, rest,
                       [&](std::size_t i, std::size_t j) { return width(i) > width(j); });
      from = rest;
    }
    std::vector<PairChoice> sorted;
    for (const std::size_t i : order)
      sorted.push_back(std::move(all_[i]));
    return sorted;
  }

 private:
  std::set<std::tuple<EdgeKind, std::vector<int>, std::vector<int>, std::array<double, 7>>> known_;
  std::vector<PairChoice> all_;
};

// The best edges of the frame for several trade-offs and their alternatives.
void add_best(Choices& choices, const PairChoice& frame, EdgeSearchOptions wanted) {
  for (const double trade_off : {wanted.trade_off, 0.0, 0.3, 3.0, 100.0}) {
    wanted.trade_off = trade_off;
    const auto found = search_edges(frame.chains, frame.frame.beta, wanted);
    if (!found) return;
    PairChoice choice = frame;
    choice.search = *found;
    choices.add(choice);
    for (const EdgeChoice& other : found->alternatives) {
      choice.search.best = other;
      choices.add(choice);
    }
  }
}

// The edges of a chain one by one, then two by two.
std::vector<Chain> short_runs(const std::vector<Chain>& chains) {
  std::vector<Chain> runs;
  for (const std::size_t length : {1U, 2U})
    for (const Chain& chain : chains)
      for (std::size_t j = 0; j + length <= chain.edges.size(); ++j) {
        const auto edge = chain.edges.begin() + static_cast<std::ptrdiff_t>(j);
        const auto corner = chain.corners.begin() + static_cast<std::ptrdiff_t>(j);
        const auto count = static_cast<std::ptrdiff_t>(length);
        runs.push_back({chain.kind, {corner, corner + count + 1}, {edge, edge + count}});
      }
  return runs;
}

void add_short(Choices& choices, const PairChoice& frame, EdgeSearchOptions wanted) {
  std::array<std::vector<Chain>, 2> runs;
  for (std::size_t i = 0; i < 2; ++i)
    runs[i] = wanted.edges[i] ? frame.chains[i] : short_runs(frame.chains[i]);
  if (runs[0].size() * runs[1].size() > kMostPairs) return;
  wanted.alternatives = 0;
  for (const Chain& a : runs[0])
    for (const Chain& b : runs[1]) {
      if (a.kind != b.kind) continue;
      PairChoice choice{frame.frame, {std::vector{a}, std::vector{b}}, {}};
      EdgeSearchOptions all = wanted;
      for (std::size_t i = 0; i < 2; ++i)
        if (!all.edges[i]) all.edges[i] = choice.chains[i].front().edges;
      const auto found = search_edges(choice.chains, frame.frame.beta, all);
      if (!found) continue;
      choice.search = *found;
      choices.add(std::move(choice));
    }
}

// The parts of facing chains that are at least `height` above the intersection line: of plates that
// touch there, what leaves room for a bend.
std::vector<Chain> above(const std::vector<Chain>& chains, double height) {
  std::vector<Chain> parts;
  for (const Chain& chain : chains) {
    if (chain.kind != EdgeKind::facing) continue;
    ChainParts part(chain.kind, parts);
    for (std::size_t j = 0; j < chain.edges.size(); ++j) {
      const Vec2 &a = chain.corners[j], &b = chain.corners[j + 1];
      const bool from = a.y() >= height, to = b.y() >= height;
      if (!from && !to) continue;
      const Vec2 crossing = a + (height - a.y()) / (b.y() - a.y()) * (b - a);
      part.add(from ? a : crossing, to ? b : crossing, chain.edges[j]);
      if (!to) part.end();
    }
    part.end();
  }
  return parts;
}

// What is left of the facing edges for bends of some inside radius.
void add_above(Choices& choices, const PairChoice& frame, const EdgeSearchOptions& wanted,
               double thickness) {
  for (const double radius : {thickness, 0.25 * thickness}) {
    const double height = tangent_distance(frame.frame, radius + 0.5 * thickness);
    PairChoice rest = frame;
    bool shorter = false;
    for (std::size_t i = 0; i < 2; ++i) {
      rest.chains[i] = above(frame.chains[i], height);
      for (const Chain& chain : frame.chains[i])
        for (const Vec2& p : chain.corners)
          shorter |= chain.kind == EdgeKind::facing && p.y() < height;
    }
    if (!shorter) continue;
    add_best(choices, rest, wanted);
    add_short(choices, rest, wanted);
  }
}

}  // namespace

std::vector<PairChoice> edge_choices(const FitTask& task, const ConnectOptions& options) {
  const PlanePair planes = plane_pair(*task.plates[0], *task.plates[1], options.planarity);
  const auto kind = natural_kind(task, options);
  constexpr int kAllAlternatives = 100;
  Choices choices;
  for (const BendFrame& frame : bend_frames(*task.plates[0], *task.plates[1], planes)) {
    const auto chains = chains_in(task, frame, kind);
    if (!chains) continue;
    EdgeSearchOptions wanted = search_options(task, frame);
    wanted.alternatives = kAllAlternatives;
    add_best(choices, *chains, wanted);
    add_short(choices, *chains, wanted);
    if (!frame.parallel()) add_above(choices, *chains, wanted, task.thickness);
  }
  return std::move(choices).best_first(task.request.trade_off);
}

}  // namespace planish::connect_detail
