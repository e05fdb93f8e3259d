#include "join_tree.hpp"

#include "bend_frame.hpp"
#include "choices.hpp"
#include "fit_check.hpp"
#include "interrupted_bends.hpp"
#include "refusals.hpp"
#include "request_check.hpp"

#include <planish/base/search.hpp>
#include <planish/base/tolerance.hpp>
#include <planish/base/union_find.hpp>
#include <planish/connect/codes.hpp>

#include <algorithm>
#include <limits>
#include <numeric>
#include <string>

// Which plates to join: a minimum spanning tree by the ratio of span to width, grown nearest pair
// first. An edge is used once, so a pair that comes up after its edges were taken is measured again
// and put back. Bends with given edges are fitted first. Where a bend that uses whole edges would
// leave another without an edge in front, bends take no more than they need.

namespace planish::connect_detail {
namespace {

// Two pairs whose ratios of span to width differ by less are equally near; the wider, then the
// earlier wins.
constexpr double kEquallyNear = tolerance::kComputed;

// A bend longer than this many diagonals of its plates joins what a shop would call two parts.
constexpr double kFarApart = 2.0;

std::vector<std::size_t> with_edges_first(const std::vector<BendRequest>& bends) {
  std::vector<std::size_t> order(bends.size());
  std::iota(order.begin(), order.end(), 0);
  const auto given = [&](std::size_t b) {
    return bends[b].edges[0].has_value() + bends[b].edges[1].has_value();
  };
  std::ranges::stable_sort(order, std::ranges::greater(), given);
  return order;
}

Result<void> check_joined(const PlateStructure& structure, UnionFind& groups) {
  for (std::size_t p = 1; p < structure.plates.size(); ++p)
    if (!groups.same(static_cast<int>(p), 0))
      return fail(refuse::left_out, {{"plate", place::plate(structure.plates[p].id)},
                                     {"other", place::plate(structure.plates[0].id)},
                                     {"field", place::pointer("/bends")}});
  return {};
}

std::string bend_pointer(std::size_t bend) { return "/bends/" + std::to_string(bend); }
std::string plate_pointer(int plate) { return "/plates/" + std::to_string(plate); }

/// The indices of the plates that each request joins. Errors: those of `rows_of`;
/// `not_connected`.
Result<std::vector<std::vector<int>>> joined_rows(const PlateStructure& structure) {
  UnionFind groups(static_cast<int>(structure.plates.size()));
  std::vector<std::vector<int>> rows;
  for (std::size_t b = 0; b < structure.bends.size(); ++b) {
    const BendRequest& request = structure.bends[b];
    const std::string pointer = bend_pointer(b);
    auto found = rows_of(structure, request, pointer);
    if (!found) return pass_on(found);
    if (found->size() == 2) groups.unite((*found)[0], (*found)[1]);
    rows.push_back(std::move(*found));
  }
  if (auto joined = check_joined(structure, groups); !joined) return pass_on(joined);
  return rows;
}

/// The longest way from plate to plate that a bend bridges.
struct SpanLimit {
  double most = std::numeric_limits<double>::infinity();
  bool given = false;
};

Result<void> check_span(const Parts& parts, int bend, const SpanLimit& limit) {
  const double span = parts.fits[bend].report.reach;
  if (span <= limit.most) return {};
  Facts facts = plates_of(parts, bend);
  facts.emplace_back("span", span, unit::mm);
  facts.emplace_back("most", limit.most, unit::mm);
  return fail(limit.given ? refuse::longer_than_given : refuse::longer_than_joined, facts);
}

/// A fit of bend number `bend`, between the plates in `rows`, is held against the others.
FitChecks checks_at(Parts& parts, std::size_t bend, const std::vector<int>& rows,
                    const SpanLimit& limit, const ConnectOptions& options) {
  const auto held = [&parts, bend, rows](const auto& check) {
    return [&parts, bend, rows, check](const BendFit& fit) {
      parts.fits[bend] = fit;
      parts.fits[bend].report.plates = rows;
      Result<void> sound = check(parts, static_cast<int>(bend));
      if (!sound) parts.fits[bend] = {};
      return sound;
    };
  };
  return {held([limit](const Parts& all, int number) -> Result<void> {
            if (auto on_plates = check_on_plates(all, number); !on_plates) return on_plates;
            return check_span(all, number, limit);
          }),
          held([&options](const Parts& all, int number) {
            return check_flat(all, number, options.k_factor);
          }),
          held(check_room)};
}

/// Fits a request after checking it.
Result<BendFit> fit_checked(const FitTask& task, const ConnectOptions& options,
                            const FitChecks& checks) {
  if (auto numbers = check_numbers(task.request, task.pointer); !numbers) return pass_on(numbers);
  if (auto edges = check_edges(task); !edges) return pass_on(edges);
  return task.request.between.size() == 2 ? fit_any_choice(task, options, checks)
                                          : fit_section(task, options);
}

/// A pair of plates that may be joined.
struct Pair {
  double cost = 0.0, width = 0.0;
  int a = 0, b = 0;
  double span = 0.0;
};
struct LaterPair {
  bool operator()(const Pair& x, const Pair& y) const {
    if (std::abs(x.cost - y.cost) > kEquallyNear * std::max(x.cost, y.cost)) return x.cost > y.cost;
    if (std::abs(x.width - y.width) > kEquallyNear * std::max(x.width, y.width))
      return x.width < y.width;
    return std::pair{x.a, x.b} > std::pair{y.a, y.b};
  }
};

using PairQueue = Frontier<Pair, LaterPair>;

/// The input of the search for a tree.
struct Problem {
  const PlateStructure& structure;
  const std::vector<PlacedPlate>& plates;
  const std::vector<SharedEdge>& touching;
  const ConnectOptions& options;
  bool share_edges = false;

  /// Along an edge, or at least in a corner.
  bool touch(int a, int b, bool along_edge = false) const {
    return std::ranges::any_of(touching, [&](const SharedEdge& edge) {
      return std::ranges::is_permutation(edge.plates, std::array{a, b}) &&
             !(along_edge && edge.from == edge.to);
    });
  }
  int count() const { return static_cast<int>(plates.size()); }
  SpanLimit span_limit(int a, int b) const {
    if (structure.largest_span) return {*structure.largest_span, true};
    return {kFarApart * (plates[a].extent + plates[b].extent), false};
  }
  double largest_span(int a, int b) const { return span_limit(a, b).most; }
  FitTask task(int a, int b, const TakenEdges& taken) const {
    const BendRequest request{.between = {structure.plates[a].id, structure.plates[b].id},
                              .inside_radius = structure.defaults.inside_radius,
                              .lateral = structure.defaults.lateral,
                              .trade_off = structure.defaults.trade_off};
    FitTask task = task_of(structure, plates, taken, {a, b}, request);
    task.shares_edges = share_edges;
    return task;
  }
};

/// How near two plates are by their free edges; of a pair that is too far apart by its best edges,
/// with `any` by the shortest choice. Empty if no bend fits.
std::optional<Pair> measured(const Problem& problem, int a, int b, const TakenEdges& taken,
                             bool any) {
  const FitTask task = problem.task(a, b, taken);
  auto near = nearness(task, problem.options);
  if (any && (!near || near->span > problem.largest_span(a, b)))
    near = nearest_choice(task, problem.options);
  if (!near) return std::nullopt;
  return Pair{near->span / near->width, near->width, a, b, near->span};
}

/// Which pairs of plates are joined, and how far the search for their bend goes.
struct Round {
  bool touching = false;  ///< only plates that touch
  bool any = false;       ///< of all choices of edges and surface, not only the first
};

/// The pairs of plates that are not joined yet, within reach of each other.
Result<PairQueue> open_pairs(const Problem& problem, UnionFind& groups, const TakenEdges& taken,
                             const Round& round, const Progress& progress) {
  PairQueue pairs;
  for (int a = 0; a < problem.count(); ++a) {
    if (progress.should_stop()) return fail(refuse::cancelled);
    progress.at("finding which plates to join", static_cast<double>(a) / problem.count());
    for (int b = a + 1; b < problem.count(); ++b) {
      if (groups.same(a, b) || (round.touching && !problem.touch(a, b))) continue;
      if (const auto pair = measured(problem, a, b, taken, round.any);
          pair && pair->span <= problem.largest_span(a, b))
        pairs.add(*pair);
    }
  }
  return pairs;
}

/// The refusal of a plate whose group only a bend longer than the largest span would join to the
/// rest; empty if none would at all.
std::optional<Error> too_far(const Problem& problem, UnionFind& groups, int p,
                             const TakenEdges& taken) {
  std::optional<Pair> nearest;
  for (int a = 0; a < problem.count(); ++a)
    for (int b = 0; b < problem.count(); ++b) {
      if (!groups.same(a, p) || groups.same(b, p)) continue;
      const auto pair = measured(problem, a, b, taken, true);
      if (pair && (!nearest || pair->span < nearest->span)) nearest = pair;
    }
  if (!nearest || nearest->span <= problem.largest_span(nearest->a, nearest->b))
    return std::nullopt;
  const std::vector<Plate>& plates = problem.structure.plates;
  return error_of(refuse::nearest_too_far,
                  {{"plate", place::plate(plates[nearest->a].id)},
                   {"other", place::plate(plates[nearest->b].id)},
                   {"span", nearest->span, unit::mm},
                   {"most", problem.largest_span(nearest->a, nearest->b), unit::mm},
                   {"field", place::pointer(plate_pointer(nearest->a))}});
}

/// The error of the nearest pair of a plate that stays alone. The request of that pair is not in
/// the file, so neither are its fields.
Error alone_because(const Place& plate, const std::string& pointer, Error why) {
  say_before(why, tell("{@plate} cannot be joined to the others. ", {{"plate", plate}}).sentence);
  std::erase_if(why.places, [&](const Place& place) {
    return place.kind == PlaceKind::pointer || (place.at.empty() && place == plate);
  });
  why.places.insert(why.places.begin(), {plate, place::pointer(pointer)});
  why.where = pointer;
  return why;
}

/// Why a plate remains unconnected; `why` is that of its nearest pair, if one was tried.
Error alone(const Problem& problem, int p, const std::optional<Error>& why) {
  const std::vector<Plate>& plates = problem.structure.plates;
  const Place plate = place::plate(plates[p].id);
  const std::string pointer = plate_pointer(p);
  if (why) return alone_because(plate, pointer, *why);
  if (const auto radius = problem.structure.defaults.inside_radius)
    return error_of(refuse::default_radius_does_not_fit,
                    {{"plate", plate},
                     {"radius", *radius, unit::mm},
                     {"field", place::pointer("/defaults/inside_radius")}});
  for (int other = 0; other < problem.count(); ++other)
    if (other != p && plane_pair(problem.plates[p], problem.plates[other],
                                 problem.options.planarity) == PlanePair::coplanar)
      return error_of(refuse::in_one_plane, {{"plate", place::plate(plates[other].id)},
                                             {"plate", plate},
                                             {"field", place::pointer(pointer)}});
  return error_of(refuse::faces_no_other, {{"plate", plate}, {"field", place::pointer(pointer)}});
}

/// Grows over the plates, nearest pairs first.
class Tree {
 public:
  explicit Tree(const Problem& problem)
      : problem_(problem),
        groups_(problem.count()),
        taken_(problem.plates.size()),
        why_(problem.plates.size()),
        parts_(parts_of(problem.structure, problem.plates, 0)) {}

  Result<void> grow(const Round& round, const Progress& progress) {
    if (parts_.fits.size() + 1 >= problem_.plates.size()) return {};
    auto open = open_pairs(problem_, groups_, taken_, round, progress);
    if (!open) return pass_on(open);
    while (!open->empty() && parts_.fits.size() + 1 < problem_.plates.size()) {
      if (progress.should_stop()) return fail(refuse::cancelled);
      const Pair pair = open->take();
      if (groups_.same(pair.a, pair.b)) continue;
      // Its edges may have been taken since.
      const auto now = measured(problem_, pair.a, pair.b, taken_, round.any);
      if (!now || now->span > problem_.largest_span(pair.a, pair.b)) continue;
      if (now->cost > pair.cost * (1.0 + kEquallyNear)) {
        open->add(*now);
        continue;
      }
      join(pair, round.any);
    }
    return {};
  }

  Result<std::vector<BendFit>> fits() && {
    for (int p = 1; p < problem_.count(); ++p)
      if (!groups_.same(p, 0)) {
        if (const auto far = too_far(problem_, groups_, p, taken_)) return tl::unexpected(*far);
        return tl::unexpected(alone(problem_, p, why_[p]));
      }
    add_stretches(problem_.structure, problem_.plates, taken_, parts_.fits);
    return std::move(parts_.fits);
  }

 private:
  void join(const Pair& pair, bool any) {
    const std::vector<int> rows{pair.a, pair.b};
    parts_.fits.emplace_back();
    const std::size_t bend = parts_.fits.size() - 1;
    auto fit = (any ? fit_any_choice : fit_first_choice)(
        problem_.task(pair.a, pair.b, taken_), problem_.options,
        checks_at(parts_, bend, rows, problem_.span_limit(pair.a, pair.b), problem_.options));
    // Plates that share an edge are meant to be joined there, not by three quarters of a turn.
    if (fit && problem_.touch(pair.a, pair.b, true))
      if (auto front = check_in_front(parts_, rows, *fit); !front) fit = pass_on(front);
    if (!fit) {
      parts_.fits.pop_back();
      for (const int p : rows)
        if (!why_[p] || any) why_[p] = fit.error();
      return;
    }
    fit->report.plates = rows;
    take(*fit, problem_.plates, taken_);
    groups_.unite(pair.a, pair.b);
    parts_.fits.back() = std::move(*fit);
  }

  const Problem& problem_;
  UnionFind groups_;
  TakenEdges taken_;
  std::vector<std::optional<Error>> why_;  // by plate: its nearest pair failed so
  Parts parts_;
};

std::ptrdiff_t round_the_back(const std::vector<BendFit>& fits) {
  return std::ranges::count(fits, EdgeKind::averted,
                            [](const BendFit& fit) { return fit.report.edge_kind; });
}

/// The fits of bends that use edges as wholes, or, where that leaves others without an edge in
/// front, no more of them than they need.
template <typename Make>
Result<std::vector<BendFit>> sharing_where_needed(const Make& make) {
  auto whole = make(false);
  if (whole ? round_the_back(*whole) == 0 : whole.error().code == code::cancelled) return whole;
  auto shared = make(true);
  if (!shared || (whole && round_the_back(*whole) <= round_the_back(*shared))) return whole;
  return shared;
}

Result<std::vector<BendFit>> fit_all_requested(const PlateStructure& structure,
                                               const std::vector<PlacedPlate>& plates,
                                               const ConnectOptions& options, bool share_edges,
                                               const Progress& progress) {
  const auto rows = joined_rows(structure);
  if (!rows) return pass_on(rows);
  TakenEdges taken(plates.size());
  Parts parts = parts_of(structure, plates, structure.bends.size());
  // A bend that is given is held only to a largest span that is given too.
  SpanLimit limit;
  if (structure.largest_span) limit = {*structure.largest_span, true};
  std::size_t done = 0;
  for (const std::size_t b : with_edges_first(structure.bends)) {
    if (progress.should_stop()) return fail(refuse::cancelled);
    progress.at("fitting bends",
                static_cast<double>(done++) / static_cast<double>(structure.bends.size()));
    FitTask task = task_of(structure, plates, taken, (*rows)[b], structure.bends[b]);
    task.pointer = bend_pointer(b);
    task.shares_edges = share_edges;
    auto fit = fit_checked(task, options, checks_at(parts, b, (*rows)[b], limit, options));
    if (!fit) return pass_on(fit);
    fit->report.plates = (*rows)[b];
    take(*fit, plates, taken);
    parts.fits[b] = std::move(*fit);
  }
  add_stretches(structure, plates, taken, parts.fits);
  return std::move(parts.fits);
}

}  // namespace

Result<std::vector<BendFit>> fit_requested(const PlateStructure& structure,
                                           const std::vector<PlacedPlate>& plates,
                                           const ConnectOptions& options,
                                           const Progress& progress) {
  return sharing_where_needed([&](bool share_edges) {
    return fit_all_requested(structure, plates, options, share_edges, progress);
  });
}

Result<std::vector<BendFit>> fit_tree(const PlateStructure& structure,
                                      const std::vector<PlacedPlate>& plates,
                                      const std::vector<SharedEdge>& touching,
                                      const ConnectOptions& options, const Progress& progress) {
  return sharing_where_needed([&](bool share_edges) -> Result<std::vector<BendFit>> {
    const Problem problem{structure, plates, touching, options, share_edges};
    Tree tree(problem);
    // Whoever draws plates that touch means them to be joined there. Other choices than the first
    // only where plates would be left alone.
    for (const Round round : {Round{true, false}, Round{true, true}, Round{}, Round{false, true}})
      if (!round.touching || !touching.empty())
        if (auto grown = tree.grow(round, progress); !grown) return pass_on(grown);
    return std::move(tree).fits();
  });
}

}  // namespace planish::connect_detail
