#include "join_tree.hpp"

#include "bend_frame.hpp"
#include "bend_stretches.hpp"
#include "choices.hpp"
#include "fit_check.hpp"
#include "outline_run.hpp"
#include "request_check.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/base/union_find.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <queue>

namespace planish::connect_detail {
namespace {

// Two pairs whose ratios of span to width differ by less are equally near; the wider, then the
// earlier wins.
constexpr double kEquallyNear = tolerance::kComputed;

constexpr const char* kCancelled = "cancelled";

// A bend longer than this many diagonals of its plates joins what a shop would call two parts.
constexpr double kFarApart = 2.0;

/// What bends use of a plate's edges already.
struct UsedEdges {
  std::set<int> whole;
  std::map<int, EdgeParts> parts;
};
using TakenEdges = std::vector<UsedEdges>;  // by plate

/// Marks the edges of a bend as used.
void take(const BendFit& fit, const std::vector<PlacedPlate>& plates, TakenEdges& taken) {
  for (std::size_t side = 0; side < fit.report.plates.size(); ++side) {
    const int p = fit.report.plates[side];
    take(plates[p], fit.runs[side], taken[p].whole, taken[p].parts);
  }
}

FitTask task_of(const PlateStructure& structure, const std::vector<PlacedPlate>& plates,
                const TakenEdges& taken, const std::vector<int>& rows, const BendRequest& request) {
  FitTask task;
  task.request = request;
  task.thickness = structure.thickness;
  for (std::size_t side = 0; side < rows.size(); ++side) {
    task.plates[side] = &plates[rows[side]];
    task.taken[side] = taken[rows[side]].whole;
    task.taken_parts[side] = taken[rows[side]].parts;
  }
  return task;
}

/// Adds the further stretches of interrupted bends, once every bend has its edges, and what is left
/// of these.
void add_stretches(const PlateStructure& structure, const std::vector<PlacedPlate>& plates,
                   TakenEdges& taken, std::vector<BendFit>& fits) {
  for (BendFit& fit : fits) {
    const std::vector<int>& rows = fit.report.plates;
    fit.stretches = further_stretches(fit,
                                      task_of(structure, plates, taken, rows, fit.report.request));
    if (fit.stretches.empty()) continue;
    fit.stretches.insert(fit.stretches.begin(), {fit.boundaries, fit.runs, {}});
    fit.stretches = merged_stretches(std::move(fit.stretches), fit,
                                     task_of(structure, plates, taken, rows, fit.report.request));
    for (const BendBand& band : fit.stretches)
      for (std::size_t side = 0; side < rows.size(); ++side) {
        UsedEdges& used = taken[rows[side]];
        take(plates[rows[side]], band.runs[side], used.whole, used.parts);
        for (const OutlineRun& run : band.more[side])
          take(plates[rows[side]], run, used.whole, used.parts);
      }
    // The band that was fitted stays the bend's own, with what it was merged with.
    const double at = fit.boundaries.low.v[0];
    const auto own = std::ranges::find_if(fit.stretches, [&](const BendBand& band) {
      return band.boundaries.low.v[0] <= at && at < band.boundaries.high.v[0];
    });
    fit.boundaries = std::move(own->boundaries);
    fit.runs = own->runs;
    fit.more = std::move(own->more);
    fit.stretches.erase(own);
  }
  for (BendFit& fit : fits) {
    const auto width = [](const Boundaries& b) {
      return 0.5 * (b.high.v[0] + b.high.v[1] - b.low.v[0] - b.low.v[1]);
    };
    fit.report.joined = fit.fold ? fit.fold->high - fit.fold->low : width(fit.boundaries);
    for (const BendBand& band : fit.stretches)
      fit.report.joined += width(band.boundaries);
    fit.report.unused = unused_edges(
        fit, task_of(structure, plates, taken, fit.report.plates, fit.report.request));
  }
}

std::vector<std::size_t> with_edges_first(const std::vector<BendRequest>& bends) {
  std::vector<std::size_t> order(bends.size());
  std::iota(order.begin(), order.end(), 0);
  const auto given = [&](std::size_t b) {
    return bends[b].edges[0].has_value() + bends[b].edges[1].has_value();
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return given(a) > given(b); });
  return order;
}

Result<void> check_joined(const PlateStructure& structure, UnionFind& groups) {
  for (std::size_t p = 1; p < structure.plates.size(); ++p)
    if (!groups.same(static_cast<int>(p), 0))
      return fail(ErrorCode::not_connected,
                  fmt::format("the bends given do not join plate \"{}\" to plate \"{}\": add a "
                              "bend, or give no bends at all to have them found",
                              structure.plates[p].id, structure.plates[0].id),
                  "/bends");
  return {};
}

/// The indices of the plates that each request joins. Errors: those of `rows_of`;
/// `not_connected`.
Result<std::vector<std::vector<int>>> joined_rows(const PlateStructure& structure) {
  UnionFind groups(static_cast<int>(structure.plates.size()));
  std::vector<std::vector<int>> rows;
  for (std::size_t b = 0; b < structure.bends.size(); ++b) {
    const BendRequest& request = structure.bends[b];
    const std::string pointer = fmt::format("/bends/{}", b);
    auto found = rows_of(structure, request, pointer);
    if (!found) return tl::unexpected(found.error());
    if (found->size() == 2) groups.unite((*found)[0], (*found)[1]);
    rows.push_back(std::move(*found));
  }
  if (auto joined = check_joined(structure, groups); !joined) return tl::unexpected(joined.error());
  return rows;
}

/// The plates, with the bends that they have so far.
Parts parts_of(const PlateStructure& structure, const std::vector<PlacedPlate>& plates,
               std::size_t bends) {
  Parts parts{structure.thickness, plates, {}, std::vector<BendFit>(bends), 0};
  for (const Plate& plate : structure.plates)
    parts.ids.push_back(plate.id);
  return parts;
}

/// A fit of bend number `bend`, between the plates in `rows`, is held against the others.
FitChecks checks_at(Parts& parts, std::size_t bend, const std::vector<int>& rows,
                    const ConnectOptions& options) {
  const auto held = [&parts, bend, rows](const auto& check) {
    return [&parts, bend, rows, check](const BendFit& fit) {
      parts.fits[bend] = fit;
      parts.fits[bend].report.plates = rows;
      Result<void> sound = check(parts, static_cast<int>(bend));
      if (!sound) parts.fits[bend] = {};
      return sound;
    };
  };
  return {held(check_on_plates), held([&options](const Parts& all, int number) -> Result<void> {
            if (auto room = check_room(all, number); !room) return room;
            return check_flat(all, number, options.k_factor);
          })};
}

/// Fits a request after checking it.
Result<BendFit> fit_checked(const FitTask& task, const ConnectOptions& options,
                            const FitChecks& checks) {
  if (auto numbers = check_numbers(task.request, task.pointer); !numbers)
    return tl::unexpected(numbers.error());
  if (auto edges = check_edges(task); !edges) return tl::unexpected(edges.error());
  return task.request.between.size() == 2 ? fit_any_choice(task, options, checks)
                                          : fit_section(task, options);
}

/// A bend that is given is held only to a largest span that is given too.
Result<void> check_span(const PlateStructure& structure, const BendFit& fit,
                        const std::string& pointer) {
  if (!structure.largest_span || fit.report.reach <= *structure.largest_span) return {};
  return fail(ErrorCode::too_far_apart,
              fmt::format("the bend would be {:.4g} mm long from plate to plate, and largest_span "
                          "is {:.4g} mm",
                          fit.report.reach, *structure.largest_span),
              pointer);
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

using PairQueue = std::priority_queue<Pair, std::vector<Pair>, LaterPair>;

/// The input of the search for a tree.
struct Problem {
  const PlateStructure& structure;
  const std::vector<PlacedPlate>& plates;
  const ConnectOptions& options;

  int count() const { return static_cast<int>(plates.size()); }
  double largest_span(int a, int b) const {
    return structure.largest_span.value_or(kFarApart * (plates[a].extent + plates[b].extent));
  }
  FitTask task(int a, int b, const TakenEdges& taken) const {
    const BendRequest request{.between = {structure.plates[a].id, structure.plates[b].id},
                              .inside_radius = structure.defaults.inside_radius,
                              .lateral = structure.defaults.lateral,
                              .trade_off = structure.defaults.trade_off};
    return task_of(structure, plates, taken, {a, b}, request);
  }
};

/// How near two plates are by their free edges; empty if no bend fits.
std::optional<Pair> measured(const Problem& problem, int a, int b, const TakenEdges& taken) {
  const auto near = nearness(problem.task(a, b, taken), problem.options);
  if (!near) return std::nullopt;
  return Pair{near->span / near->width, near->width, a, b, near->span};
}

Result<PairQueue> all_pairs(const Problem& problem, const TakenEdges& taken,
                            const Progress& progress) {
  PairQueue pairs;
  for (int a = 0; a < problem.count(); ++a) {
    if (progress.should_stop()) return fail(ErrorCode::cancelled, kCancelled);
    progress.at("finding which plates to join", static_cast<double>(a) / problem.count());
    for (int b = a + 1; b < problem.count(); ++b)
      if (const auto pair = measured(problem, a, b, taken);
          pair && pair->span <= problem.largest_span(a, b))
        pairs.push(*pair);
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
      const auto pair = measured(problem, a, b, taken);
      if (pair && (!nearest || pair->span < nearest->span)) nearest = pair;
    }
  if (!nearest || nearest->span <= problem.largest_span(nearest->a, nearest->b))
    return std::nullopt;
  const std::vector<Plate>& plates = problem.structure.plates;
  return Error{
      ErrorCode::too_far_apart,
      fmt::format("plate \"{}\" is not joined to the others: the shortest bend, to plate "
                  "\"{}\", would be {:.4g} mm long from plate to plate, and up to {:.4g} mm "
                  "are joined: give a larger largest_span, or the bend itself",
                  plates[nearest->a].id, plates[nearest->b].id, nearest->span,
                  problem.largest_span(nearest->a, nearest->b)),
      fmt::format("/plates/{}", nearest->a)};
}

/// Why a plate remains unconnected; `why` is that of its nearest pair, if one was tried.
Error alone(const Problem& problem, int p, const std::optional<Error>& why) {
  const std::vector<Plate>& plates = problem.structure.plates;
  const std::string where = fmt::format("/plates/{}", p);
  if (why)
    return {
        why->code,
        fmt::format("plate \"{}\" cannot be joined to the others: {}", plates[p].id, why->message),
        where};
  if (const auto radius = problem.structure.defaults.inside_radius)
    return {
        ErrorCode::no_bend_fits,
        fmt::format("plate \"{}\" cannot be joined to the others by a bend of the default inside "
                    "radius, {:.6g} mm: make it smaller, or give it to single bends",
                    plates[p].id, *radius),
        "/defaults/inside_radius"};
  for (int other = 0; other < problem.count(); ++other)
    if (other != p && plane_pair(problem.plates[p], problem.plates[other],
                                 problem.options.planarity) == PlanePair::coplanar)
      return {ErrorCode::plates_coplanar,
              fmt::format("plates \"{}\" and \"{}\" lie in one plane, so there is nothing to bend "
                          "between them: make them one plate",
                          plates[other].id, plates[p].id),
              where};
  return {ErrorCode::no_bend_fits,
          fmt::format("plate \"{}\" cannot be joined to the others: none of their edges and its "
                      "own look towards each other",
                      plates[p].id),
          where};
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

  using Fit = Result<BendFit>(const FitTask&, const ConnectOptions&, const FitChecks&);

  Result<void> grow(Fit* fit, const Progress& progress) {
    if (parts_.fits.size() + 1 >= problem_.plates.size()) return {};
    auto open = all_pairs(problem_, taken_, progress);
    if (!open) return tl::unexpected(open.error());
    while (!open->empty() && parts_.fits.size() + 1 < problem_.plates.size()) {
      if (progress.should_stop()) return fail(ErrorCode::cancelled, kCancelled);
      const Pair pair = open->top();
      open->pop();
      if (groups_.same(pair.a, pair.b)) continue;
      // Its edges may have been taken since.
      const auto now = measured(problem_, pair.a, pair.b, taken_);
      if (!now || now->span > problem_.largest_span(pair.a, pair.b)) continue;
      if (now->cost > pair.cost * (1.0 + kEquallyNear)) {
        open->push(*now);
        continue;
      }
      join(pair, fit);
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
  void join(const Pair& pair, Fit* how) {
    const std::vector<int> rows{pair.a, pair.b};
    parts_.fits.emplace_back();
    const std::size_t bend = parts_.fits.size() - 1;
    auto fit = how(problem_.task(pair.a, pair.b, taken_), problem_.options,
                   checks_at(parts_, bend, rows, problem_.options));
    if (!fit) {
      parts_.fits.pop_back();
      for (const int p : rows)
        if (!why_[p] || how == fit_any_choice) why_[p] = fit.error();
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

}  // namespace

Result<std::vector<BendFit>> fit_requested(const PlateStructure& structure,
                                           const std::vector<PlacedPlate>& plates,
                                           const ConnectOptions& options,
                                           const Progress& progress) {
  const auto rows = joined_rows(structure);
  if (!rows) return tl::unexpected(rows.error());
  TakenEdges taken(plates.size());
  Parts parts = parts_of(structure, plates, structure.bends.size());
  std::size_t done = 0;
  for (const std::size_t b : with_edges_first(structure.bends)) {
    if (progress.should_stop()) return fail(ErrorCode::cancelled, kCancelled);
    progress.at("fitting bends",
                static_cast<double>(done++) / static_cast<double>(structure.bends.size()));
    FitTask task = task_of(structure, plates, taken, (*rows)[b], structure.bends[b]);
    task.pointer = fmt::format("/bends/{}", b);
    auto fit = fit_checked(task, options, checks_at(parts, b, (*rows)[b], options));
    if (!fit) return tl::unexpected(fit.error());
    if (auto near = check_span(structure, *fit, task.pointer); !near)
      return tl::unexpected(near.error());
    fit->report.plates = (*rows)[b];
    take(*fit, plates, taken);
    parts.fits[b] = std::move(*fit);
  }
  add_stretches(structure, plates, taken, parts.fits);
  return std::move(parts.fits);
}

Result<std::vector<BendFit>> fit_tree(const PlateStructure& structure,
                                      const std::vector<PlacedPlate>& plates,
                                      const ConnectOptions& options, const Progress& progress) {
  const Problem problem{structure, plates, options};
  Tree tree(problem);
  // Other choices than the first only where plates would be left alone.
  for (const auto fit : {fit_first_choice, fit_any_choice})
    if (auto grown = tree.grow(fit, progress); !grown) return tl::unexpected(grown.error());
  return std::move(tree).fits();
}

}  // namespace planish::connect_detail
