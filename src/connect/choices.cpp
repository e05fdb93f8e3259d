#include "choices.hpp"

#include "corners.hpp"
#include "general_fit.hpp"
#include "refusals.hpp"
#include "sharp_fit.hpp"
#include "surface_choice.hpp"
#include "tolerances.hpp"

#include <planish/connect/codes.hpp>
#include <planish/sheet/codes.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <string_view>
#include <utility>

// All that a request leaves open is tried until a fit keeps to the checks: edges nearest and widest
// first, lateral boundaries, cylinders nearer or farther, general bends at last, as these take a
// hundred times longer. The first that holds is taken. If none holds, the first of all is, if it
// keeps to what it must; otherwise the error is that of the choices that came farthest.

namespace planish::connect_detail {
namespace {

// Edges, surfaces and boundaries are tried up to this number: some tenths of a second.
constexpr int kMostTries = 6000;
// General bends take a hundred times longer than others to fit.
constexpr int kMostGeneral = 240;
// Of the choices that come first, so many may be general bends, where these need less extension.
constexpr int kMostGeneralFirst = 2;
// On other edges than the best, so many general bends are tried for less extension, on edges of at
// least this share of the width.
constexpr int kMostGeneralElsewhere = 64;
constexpr double kNearlyAsWide = 0.8;

BendRequest with_surface(BendRequest request, SurfaceChoice surface) {
  request.surface = surface;
  return request;
}

// Cylinders nearer to the line where the planes meet, or farther behind the plates, than the one
// of least extension.
std::vector<BendRequest> other_cylinders(const FitTask& task, const PairChoice& choice) {
  const bool facing = choice.search.best.kind == EdgeKind::facing;
  const Corners corners = choice.corners(choice.search.best);
  const double limit = facing ? lowest(corners) : highest(corners);
  std::vector<BendRequest> requests;
  for (const double share : facing ? std::array{0.7, 0.4, 0.15} : std::array{1.5, 2.5, 5.0}) {
    const double mid = share * limit * std::tan(0.5 * choice.frame.beta.radians());
    const double radius = mid - 0.5 * task.thickness;
    if (radius < kSmallestInsideRadius) continue;
    requests.push_back(task.request);
    requests.back().inside_radius = radius;
  }
  return requests;
}

std::vector<BendRequest> with_laterals(const std::vector<BendRequest>& requests) {
  std::vector<BendRequest> all;
  for (BendRequest request : requests) {
    if (request.lateral != LateralBoundary::automatic) {
      all.push_back(request);
      continue;
    }
    for (const LateralBoundary lateral : {LateralBoundary::automatic, LateralBoundary::corner,
                                          LateralBoundary::arc, LateralBoundary::straight}) {
      request.lateral = lateral;
      all.push_back(request);
    }
  }
  return all;
}

// Plates drawn up to their bend leave no choice, and what overlaps may yet be mended by a relief. A
// general cone that nobody asked for is a choice.
bool is_drawn_up(const BendFit& fit, const FitTask& task) {
  if (fit.surface.kind == BendKind::general && leaves_surface_free(task.request)) return false;
  return fit.report.extension_area <= kContact * task.thickness * fit.report.width;
}

/// Tries choices and remembers why they failed.
class Trial {
 public:
  Trial(const FitTask& task, const ConnectOptions& options, const FitChecks& checks)
      : task_(task), options_(options), checks_(checks) {}

  // True: `found` holds.
  bool take(Result<BendFit> fit) {
    ++tries_;
    if (!fit) return failed(fit.error());
    if (auto sound = checks_.must(*fit); !sound) return failed(in_request(task_, sound.error()));
    const bool drawn_up = is_drawn_up(*fit, task_);
    if (!drawn_up)
      if (auto flat = checks_.flat(*fit); !flat) {
        if (tries_ == 1) fallback_ = std::move(*fit);
        return failed(in_request(task_, flat.error()));
      }
    if (auto room = checks_.room(*fit); !room) {
      fall_back_to(std::move(*fit), !drawn_up);
      return failed(in_request(task_, room.error()));
    }
    found_ = std::move(*fit);
    return true;
  }

  bool take(const PairChoice& choice, const BendRequest& request) {
    FitTask task = task_;
    task.request = request;
    task.right_only = ++choices_ > kMostGeneralFirst;
    auto fit = fit_choice(task, choice, options_);
    if (!fit) fit = fail(in_request(task, fit.error()));
    return take(std::move(fit));
  }

  bool tired() const { return tries_ >= kMostTries; }

  /// Why the edges that come first do not hold: of a free surface, as a cylinder or right cone.
  const Error& first_edges_failure() const { return first_edges_; }

  Result<BendFit> result() const {
    if (found_) return *found_;
    if (fallback_) return *fallback_;
    return tl::unexpected(why());
  }

 private:
  // The first choice, or in its place one that lies flat.
  void fall_back_to(BendFit fit, bool known_flat) {
    if (tries_ > 1 && (!fallback_ || fallback_is_flat_)) return;
    const bool flat = known_flat || checks_.flat(fit);
    if (tries_ > 1 && !flat) return;
    fallback_ = std::move(fit);
    fallback_is_flat_ = flat;
  }

  bool failed(const Error& error) {
    auto& [count, first] = failures_[rank(error.code)];
    if (count++ == 0) first = error;
    if (tries_ == 1) first_ = error;
    if (tries_ == 1 || (tries_ == 2 && leaves_surface_free(task_.request))) first_edges_ = error;
    if (error.code == code::plates_touch && !touch_) touch_ = error;
    return false;
  }

  // How far a choice with this error came.
  static int rank(const ErrorCode& code) {
    if (code == code::radius_too_small || code == code::plates_touch) return 1;
    if (code == code::no_common_width) return 2;
    if (code == code::overlap) return 3;
    return code == code::too_far_apart ? 4 : 0;
  }

  Error why() const {
    // What can be mended by moving the plates; else what the choices that came farthest met.
    Error error = failures_.rbegin()->second.second;
    if (touch_) error = *touch_;
    if (rank(first_.code) == 1 || tries_ == 1) error = first_;
    if (tries_ == 1) return error;
    constexpr std::array<std::string_view, 5> kCounts{
        "{count} without a tangent line", "{count} too close for the thickness",
        "{count} without a width where the bend would clear both plates",
        "{count} that would cut or cover a plate", "{count} too long"};
    Facts facts{{"choices", tries_}};
    for (const auto& [rank, failure] : failures_)
      facts.emplace_back("counts", tell(kCounts[rank], {{"count", failure.first}}).sentence);
    Told tried = tell(
        "None of {choices} choices of edges, lateral boundaries and surfaces works: {counts}.",
        facts);
    error.message += " " + tried.sentence;
    std::ranges::move(tried.numbers, std::back_inserter(error.numbers));
    return error;
  }

  const FitTask& task_;
  const ConnectOptions& options_;
  const FitChecks& checks_;
  int tries_ = 0, choices_ = 0;
  Error first_, first_edges_;
  std::optional<Error> touch_;
  std::map<int, std::pair<int, Error>> failures_;  // by rank: how many, and the first
  std::optional<BendFit> found_, fallback_;
  bool fallback_is_flat_ = false;
};

bool any_as_asked(Trial& trial, const std::vector<PairChoice>& choices, const FitTask& task) {
  const auto requests = with_laterals({task.request});
  for (const PairChoice& choice : choices)
    for (const BendRequest& request : requests)
      if (trial.tired() || trial.take(choice, request)) return true;
  return false;
}

bool any_other_surface(Trial& trial, const std::vector<PairChoice>& choices, const FitTask& task) {
  for (const PairChoice& choice : choices) {
    if (choice.frame.parallel()) continue;
    std::vector<BendRequest> requests{with_surface(task.request, SurfaceChoice::cylinder)};
    for (const BendRequest& cylinder : other_cylinders(task, choice))
      requests.push_back(cylinder);
    for (const BendRequest& request : with_laterals(requests))
      if (trial.tired() || trial.take(choice, request)) return true;
  }
  return false;
}

bool any_general(Trial& trial, const std::vector<PairChoice>& choices, const FitTask& task) {
  int tries = 0;
  for (const PairChoice& choice : choices) {
    if (choice.frame.parallel()) continue;
    const EdgeChoice& best = choice.search.best;
    if (!general_lines(choice.corners(best), best.kind, std::nullopt)) continue;  // no apex
    for (const BendRequest& request :
         with_laterals({with_surface(task.request, SurfaceChoice::general)}))
      if (++tries > kMostGeneral || trial.take(choice, request)) return true;
  }
  return false;
}

Result<void> check_all(const BendFit& fit, const FitTask& task, const FitChecks& checks) {
  for (const auto& check : {checks.must, checks.room})
    if (auto sound = check(fit); !sound) return fail(in_request(task, sound.error()));
  if (!is_drawn_up(fit, task))
    if (auto flat = checks.flat(fit); !flat) return fail(in_request(task, flat.error()));
  return {};
}

Result<BendFit> first_that_holds(const FitTask& task, const ConnectOptions& options,
                                 const FitChecks& checks) {
  auto fit = fit_between(task, options);
  if (!fit) return fit;
  if (auto sound = check_all(*fit, task, checks); !sound) return pass_on(sound);
  return fit;
}

/// A general cone that holds on edges nearly as wide as those of `right`, a cylinder or right cone,
/// where none holds on the best edges: their apex may lie beside a corner that is cut off. It is
/// longer than that only for being wider. Empty if there is none, or if it would save next to
/// nothing.
std::optional<BendFit> general_elsewhere(const FitTask& task, const BendFit& right,
                                         const ConnectOptions& options, const FitChecks& checks) {
  const double area = right.report.extension_area;
  const auto worth = [&](const PairChoice& choice) {
    const EdgeChoice& best = choice.search.best;
    const double wider = std::max(0.0, best.width - right.report.width);
    return !choice.frame.parallel() && best.kind == EdgeKind::facing &&
           best.width >= kNearlyAsWide * right.report.width &&
           best.span <=
               right.report.span + task.request.trade_off * wider + kNegligible * extent_of(task) &&
           less_extended(choice.corners(best), area, options);
  };
  const auto nearest = search_pair(task, options);
  if (!nearest || !saves_extension(nearest->corners(nearest->search.best), area, options))
    return std::nullopt;
  FitTask general = task;
  general.request.surface = SurfaceChoice::general;
  int tries = 0;
  for (const PairChoice& choice : edge_choices(general, options)) {
    if (!worth(choice)) continue;
    for (const BendRequest& request : with_laterals({general.request})) {
      if (++tries > kMostGeneralElsewhere) return std::nullopt;
      FitTask one = general;
      one.request = request;
      auto fit = fit_choice(one, choice, options);
      if (!fit || !check_all(*fit, one, checks) || fit->report.extension_area >= area) continue;
      fit->report.request = task.request;
      return std::move(*fit);
    }
  }
  return std::nullopt;
}

/// The fit itself, or a general cone of less extension on other edges.
Result<BendFit> least_extended(const FitTask& task, Result<BendFit> fit,
                               const ConnectOptions& options, const FitChecks& checks) {
  if (!fit || !leaves_surface_free(task.request) || asks_for_fold(task.request) ||
      fit->surface.kind == BendKind::general)
    return fit;
  if (auto general = general_elsewhere(task, *fit, options, checks)) return std::move(*general);
  return fit;
}

FitTask without_general(FitTask task) {
  task.right_only = true;
  return task;
}

// The bend that the search finds first, where another one that is longer was taken.
std::optional<PassedOver> passed_over(const FitTask& task, const ConnectOptions& options,
                                      const FittedBend& taken, const Error& why) {
  if (why.message.empty()) return std::nullopt;
  const auto choice = search_pair(task, options);
  if (!choice || choice->search.best.span >= taken.span - kNegligible * extent_of(task))
    return std::nullopt;
  PassedOver shorter{choice->edges(choice->search.best), choice->search.best.span, why};
  for (auto& edges : shorter.edges)
    std::ranges::sort(edges);
  if (shorter.edges == taken.edges) return std::nullopt;
  return shorter;
}

// Of plates that nearly lie in one plane the planes meet anywhere, and what stands in the way of a
// bend there says nothing about the plates.
Error clearer(const FitTask& task, Error why) {
  const PlacedPlate &a = *task.plates[0], &b = *task.plates[1];
  const auto near = nearly_coplanar(a, b, task.thickness);
  if (!near || why.code == code::too_far_apart || runs_between(a, b)) return why;
  return in_request(task, error_of(refuse::nearly_in_one_plane,
                                   about(task, {{"angle", near->angle.degrees(), unit::degrees},
                                                {"off", near->off, unit::mm}})));
}

}  // namespace

Result<BendFit> fit_first_choice(const FitTask& task, const ConnectOptions& options,
                                 const FitChecks& checks) {
  auto fit = first_that_holds(task, options, checks);
  if (!fit && leaves_surface_free(task.request))
    if (auto right = first_that_holds(without_general(task), options, checks))
      fit = std::move(right);
  return least_extended(task, std::move(fit), options, checks);
}

Result<BendFit> fit_any_choice(const FitTask& asked, const ConnectOptions& options,
                               const FitChecks& checks) {
  if (asks_for_fold(asked.request)) return fit_first_choice(asked, options, checks);
  const FitTask task = at_limit_of_edges(asked, options);
  const bool free = leaves_surface_free(task.request);
  Trial trial(task, options, checks);
  if (!trial.take(fit_between(asked, options)) &&
      !(free && trial.take(fit_between(without_general(asked), options)))) {
    const std::vector<PairChoice> choices = edge_choices(task, options);
    // Where width counts for nothing, another surface on shorter edges comes before longer edges.
    const bool found = free && task.request.trade_off == 0.0
                           ? std::ranges::any_of(choices,
                                                 [&](const PairChoice& choice) {
                                                   return any_as_asked(trial, {choice}, task) ||
                                                          any_other_surface(trial, {choice}, task);
                                                 })
                           : any_as_asked(trial, choices, task) ||
                                 (free && any_other_surface(trial, choices, task));
    if (!found && free) any_general(trial, choices, task);
  }
  const auto held = trial.result();
  if (!held) return fail(clearer(task, held.error()));
  auto fit = least_extended(task, held, options, checks);
  fit->report.request = asked.request;
  fit->report.passed_over = passed_over(task, options, held->report, trial.first_edges_failure());
  return fit;
}

std::optional<Nearness> nearest_choice(const FitTask& asked, const ConnectOptions& options) {
  if (asks_for_fold(asked.request)) return nearness(asked, options);
  std::optional<Nearness> nearest;
  for (const PairChoice& choice : edge_choices(at_limit_of_edges(asked, options), options)) {
    const Nearness near = nearness_of(choice);
    if (near.width > 0.0 && (!nearest || near.span < nearest->span)) nearest = near;
  }
  return nearest;
}

}  // namespace planish::connect_detail
