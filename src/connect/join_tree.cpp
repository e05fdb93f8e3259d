#include "join_tree.hpp"

#include "bend_frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <queue>

namespace planish::connect_detail {
namespace {

// Two pairs whose span over width differ by less are equally near; the wider, then the earlier
// wins.
constexpr double kEquallyNear = 1e-9;

/// Which plates are one already.
class Groups {
 public:
  explicit Groups(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  int group(int i) {
    while (parent_[i] != i)
      i = parent_[i];
    return i;
  }
  // False where they were one already.
  bool join(int a, int b) {
    const int ga = group(a), gb = group(b);
    parent_[ga] = gb;
    return ga != gb;
  }

 private:
  std::vector<int> parent_;
};

Result<int> row_of(const PlateStructure& structure, const std::string& id,
                   const std::string& pointer) {
  for (std::size_t p = 0; p < structure.plates.size(); ++p)
    if (structure.plates[p].id == id) return static_cast<int>(p);
  std::string known;
  for (const Plate& plate : structure.plates)
    known += (known.empty() ? "" : ", ") + plate.id;
  return fail(ErrorCode::unknown_plate,
              fmt::format("there is no plate \"{}\"; the plates are {}", id, known), pointer);
}

Result<std::vector<int>> rows_of(const PlateStructure& structure, const BendRequest& request,
                                 const std::string& pointer) {
  if (request.between.size() > 2)
    return fail(ErrorCode::invalid_input,
                fmt::format("a bend joins two plates, not {}", request.between.size()),
                pointer + "/between");
  std::vector<int> rows;
  for (std::size_t i = 0; i < request.between.size(); ++i) {
    const auto row = row_of(structure, request.between[i],
                            fmt::format("{}/between/{}", pointer, i));
    if (!row) return tl::unexpected(row.error());
    rows.push_back(*row);
  }
  if (rows.size() == 2 && rows[0] == rows[1])
    return fail(ErrorCode::invalid_input,
                fmt::format("a bend cannot join plate \"{}\" to itself", request.between[0]),
                pointer + "/between");
  return rows;
}

// Keys of a JSON object stand in pointers with ~ and / escaped (RFC 6901).
std::string escaped(const std::string& key) {
  std::string text;
  for (const char c : key)
    text += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  return text;
}

Result<void> check_edges(const FitTask& task, const std::vector<int>& rows) {
  for (std::size_t side = 0; side < rows.size(); ++side) {
    if (!task.request.edges[side]) continue;
    const int count = task.plates[side]->edge_count();
    const std::string place = fmt::format("{}/edges/{}", task.pointer,
                                          escaped(task.request.between[side]));
    if (task.request.edges[side]->empty())
      return fail(ErrorCode::invalid_input,
                  "an empty list of edges: leave it out to have them chosen", place);
    for (std::size_t i = 0; i < task.request.edges[side]->size(); ++i) {
      const int edge = (*task.request.edges[side])[i];
      if (edge >= 0 && edge < count) continue;
      return fail(ErrorCode::unknown_edge,
                  fmt::format("plate \"{}\" has no edge {}: its edges are 0 to {}",
                              task.request.between[side], edge, count - 1),
                  fmt::format("{}/{}", place, i));
    }
  }
  return {};
}

Result<void> check_numbers(const BendRequest& r, const std::string& pointer) {
  const auto bad = [&](const std::string& key, const std::string& what) {
    return fail(ErrorCode::invalid_input, what, pointer + key);
  };
  if (!(r.trade_off >= 0.0))
    return bad("/trade_off", fmt::format("trade_off is {}; it must be 0 or more", r.trade_off));
  if (r.inside_radius && !(*r.inside_radius >= 0.0))
    return bad("/inside_radius",
               fmt::format("inside_radius is {}; it must be 0 or more", *r.inside_radius));
  if (r.inside_radii && !((*r.inside_radii)[0] >= 0.0 && (*r.inside_radii)[1] >= 0.0))
    return bad("/inside_radii", "inside_radii must be 0 or more");
  if (r.aperture && !(r.aperture->degrees() > 0.0 && r.aperture->degrees() < 180.0))
    return bad("/aperture", fmt::format("aperture is {}°; it must lie between 0 and 180°",
                                        r.aperture->degrees()));
  const bool conical = r.slope || r.apex || r.aperture || r.inside_radii;
  if (r.surface == SurfaceChoice::cylinder && conical)
    return bad(
        "/surface",
        "a cylinder has no slope, apex, aperture or radii at its ends: give them with a cone");
  if (r.surface == SurfaceChoice::general &&
      (r.slope || r.aperture || r.inside_radius || r.inside_radii))
    return bad("/surface",
               "of a general bend only edges, apex, tangent_point and lateral can be given");
  if (r.tangent_point && r.surface != SurfaceChoice::general)
    return bad("/tangent_point", "a tangent_point goes with the surface general");
  const int ways = (r.inside_radii ? 1 : 0) + (r.aperture ? 1 : 0) + (r.slope || r.apex ? 1 : 0);
  if (ways > 1)
    return bad("",
               "slope and apex, aperture, and inside_radii say the same: give one of the three");
  if (r.inside_radius && (r.inside_radii || r.aperture || r.apex))
    return bad("/inside_radius",
               "inside_radius goes with a cylinder, or with a cone whose slope at most is given");
  return {};
}

void take(const BendFit& fit, std::vector<std::set<int>>& taken) {
  for (std::size_t side = 0; side < fit.report.plates.size(); ++side)
    taken[fit.report.plates[side]].insert(fit.report.edges[side].begin(),
                                          fit.report.edges[side].end());
}

FitTask task_of(const PlateStructure& structure, const std::vector<PlacedPlate>& plates,
                const std::vector<std::set<int>>& taken, const std::vector<int>& rows,
                const BendRequest& request) {
  FitTask task;
  task.request = request;
  task.thickness = structure.thickness;
  for (std::size_t side = 0; side < rows.size(); ++side) {
    task.plates[side] = &plates[rows[side]];
    task.taken[side] = taken[rows[side]];
  }
  return task;
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

Result<void> check_joined(const PlateStructure& structure, Groups& groups) {
  for (std::size_t p = 1; p < structure.plates.size(); ++p)
    if (groups.group(static_cast<int>(p)) != groups.group(0))
      return fail(ErrorCode::not_connected,
                  fmt::format("the bends given do not join plate \"{}\" to plate \"{}\": add a "
                              "bend, or give no bends at "
                              "all to have them found",
                              structure.plates[p].id, structure.plates[0].id),
                  "/bends");
  return {};
}

/// A pair of plates that may be joined.
struct Pair {
  double cost = 0.0, width = 0.0;
  int a = 0, b = 0;
};
struct LaterPair {
  bool operator()(const Pair& x, const Pair& y) const {
    if (std::abs(x.cost - y.cost) > kEquallyNear * std::max(x.cost, y.cost)) return x.cost > y.cost;
    if (std::abs(x.width - y.width) > kEquallyNear * std::max(x.width, y.width))
      return x.width < y.width;
    return std::pair{x.a, x.b} > std::pair{y.a, y.b};
  }
};

class TreeSearch {
 public:
  TreeSearch(const PlateStructure& structure, const std::vector<PlacedPlate>& plates,
             const ConnectOptions& options)
      : structure_(structure),
        plates_(plates),
        options_(options),
        groups_(plates.size()),
        taken_(plates.size()) {}

  Result<std::vector<BendFit>> run(const Progress& progress) {
    const int count = static_cast<int>(plates_.size());
    for (int a = 0; a < count; ++a) {
      if (progress.should_stop()) return fail(ErrorCode::cancelled, "cancelled");
      progress.at("finding which plates to join", static_cast<double>(a) / count);
      for (int b = a + 1; b < count; ++b)
        add(a, b);
    }
    while (!open_.empty() && fits_.size() + 1 < plates_.size()) {
      if (progress.should_stop()) return fail(ErrorCode::cancelled, "cancelled");
      const Pair pair = open_.top();
      open_.pop();
      consider(pair);
    }
    for (int p = 1; p < count; ++p)
      if (groups_.group(p) != groups_.group(0)) return tl::unexpected(alone(p));
    return std::move(fits_);
  }

 private:
  BendRequest request(int a, int b) const {
    BendRequest request;
    request.between = {structure_.plates[a].id, structure_.plates[b].id};
    return request;
  }

  std::optional<Pair> measured(int a, int b) const {
    const FitTask task = task_of(structure_, plates_, taken_, {a, b}, request(a, b));
    const auto near = nearness(task, options_);
    if (!near) return std::nullopt;
    return Pair{near->span / near->width, near->width, a, b};
  }

  void add(int a, int b) {
    if (const auto pair = measured(a, b)) open_.push(*pair);
  }

  void consider(const Pair& pair) {
    if (groups_.group(pair.a) == groups_.group(pair.b)) return;
    // Edges may have been taken since.
    const auto now = measured(pair.a, pair.b);
    if (!now) return;
    if (now->cost > pair.cost * (1.0 + kEquallyNear)) {
      open_.push(*now);
      return;
    }
    const FitTask task = task_of(structure_, plates_, taken_, {pair.a, pair.b},
                                 request(pair.a, pair.b));
    auto fit = fit_between(task, options_);
    if (!fit) {
      why_ = fit.error();
      return;
    }
    fit->report.plates = {pair.a, pair.b};
    take(*fit, taken_);
    groups_.join(pair.a, pair.b);
    fits_.push_back(std::move(*fit));
  }

  Error alone(int p) const {
    const std::string& id = structure_.plates[p].id;
    if (why_)
      return {why_->code,
              fmt::format("plate \"{}\" cannot be joined to the others: {}", id, why_->message),
              fmt::format("/plates/{}", p)};
    for (std::size_t other = 0; other < plates_.size(); ++other)
      if (static_cast<int>(other) != p &&
          plane_pair(plates_[p], plates_[other], options_.planarity) == PlanePair::coplanar)
        return {ErrorCode::plates_coplanar,
                fmt::format("plates \"{}\" and \"{}\" lie in one plane, there is nothing to bend "
                            "between them: make them one plate",
                            structure_.plates[other].id, id),
                fmt::format("/plates/{}", p)};
    return {ErrorCode::no_bend_fits,
            fmt::format("plate \"{}\" cannot be joined to the others: no edge of theirs and its "
                        "own look towards each "
                        "other",
                        id),
            fmt::format("/plates/{}", p)};
  }

  const PlateStructure& structure_;
  const std::vector<PlacedPlate>& plates_;
  const ConnectOptions& options_;
  Groups groups_;
  std::vector<std::set<int>> taken_;
  std::priority_queue<Pair, std::vector<Pair>, LaterPair> open_;
  std::vector<BendFit> fits_;
  std::optional<Error> why_;
};

}  // namespace

Result<std::vector<BendFit>> fit_requested(const PlateStructure& structure,
                                           const std::vector<PlacedPlate>& plates,
                                           const ConnectOptions& options,
                                           const Progress& progress) {
  Groups groups(plates.size());
  std::vector<std::set<int>> taken(plates.size());
  std::vector<BendFit> fits(structure.bends.size());
  std::vector<std::vector<int>> rows(structure.bends.size());
  for (std::size_t b = 0; b < structure.bends.size(); ++b) {
    const std::string pointer = fmt::format("/bends/{}", b);
    auto found = rows_of(structure, structure.bends[b], pointer);
    if (!found) return tl::unexpected(found.error());
    rows[b] = std::move(*found);
    if (rows[b].size() == 2 && !groups.join(rows[b][0], rows[b][1]))
      return fail(ErrorCode::bend_loop,
                  fmt::format("the bend between \"{}\" and \"{}\" closes a loop: they are joined "
                              "already, and a loop "
                              "cannot be laid flat",
                              structure.bends[b].between[0], structure.bends[b].between[1]),
                  pointer);
  }
  if (auto joined = check_joined(structure, groups); !joined) return tl::unexpected(joined.error());
  std::size_t done = 0;
  for (const std::size_t b : with_edges_first(structure.bends)) {
    if (progress.should_stop()) return fail(ErrorCode::cancelled, "cancelled");
    progress.at("fitting bends",
                static_cast<double>(done++) / static_cast<double>(structure.bends.size()));
    FitTask task = task_of(structure, plates, taken, rows[b], structure.bends[b]);
    task.pointer = fmt::format("/bends/{}", b);
    if (auto numbers = check_numbers(task.request, task.pointer); !numbers)
      return tl::unexpected(numbers.error());
    if (auto edges = check_edges(task, rows[b]); !edges) return tl::unexpected(edges.error());
    auto fit = rows[b].size() == 2 ? fit_between(task, options) : fit_section(task, options);
    if (!fit) return tl::unexpected(fit.error());
    fit->report.plates = rows[b];
    take(*fit, taken);
    fits[b] = std::move(*fit);
  }
  return fits;
}

Result<std::vector<BendFit>> fit_tree(const PlateStructure& structure,
                                      const std::vector<PlacedPlate>& plates,
                                      const ConnectOptions& options, const Progress& progress) {
  return TreeSearch(structure, plates, options).run(progress);
}

}  // namespace planish::connect_detail
