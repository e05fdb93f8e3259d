#include "bend_fit.hpp"

#include "corners.hpp"
#include "general_fit.hpp"
#include "outline_run.hpp"
#include "refusals.hpp"
#include "sharp_fit.hpp"
#include "surface_choice.hpp"
#include "tangent_line.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

// One bend between two plates (math.md#bend-fitting): its frame and edges, then the tangent line of
// least plate extension, the surface tangent to both planes along it, and at last its lateral
// boundaries, within what neither plate's material forbids. Each step takes the one before as
// given. A line that touches an edge already drawn along it is moved clear, so that no such edge is
// cut by rounding.

namespace planish::connect_detail {
namespace {

// A corner within this share of the extent of the tangent ruling lies on it.
constexpr double kOnRuling = tolerance::kComputed;

RunEnds run_ends(const BendSurface& surface, const BendFrame& frame, const Corners& corners) {
  RunEnds ends;
  for (int side = 0; side < 2; ++side) {
    Vec2 &low = ends.low[side], &high = ends.high[side];
    low = surface.local(side, frame.point(side, corners[side].front()));
    high = surface.local(side, frame.point(side, corners[side].back()));
    if (low.x() > high.x()) std::swap(low, high);
  }
  return ends;
}

std::vector<Spread> common(const std::vector<Spread>& a, const std::vector<Spread>& b) {
  std::vector<Spread> both;
  for (const Spread& p : a)
    for (const Spread& q : b) {
      const Spread part{std::max(p.first, q.first), std::min(p.second, q.second)};
      if (part.second > part.first) both.push_back(part);
    }
  return both;
}

std::vector<Spread> legal_on_both(const FitTask& task, const BendSurface& surface,
                                  const RunEnds& ends) {
  const double extent = extent_of(task);
  double low = std::min(ends.low[0].x(), ends.low[1].x()) - extent;
  const double high = std::max(ends.high[0].x(), ends.high[1].x()) + extent;
  if (surface.kind == BendKind::cone) low = std::max(low, 0.0);
  if (surface.kind == BendKind::general)
    low = std::max(low, -std::min(surface.rails[0], surface.rails[1]));
  std::array<std::vector<Spread>, 2> legal;
  for (int side = 0; side < 2; ++side) {
    legal[side] = legal_sections(local_rings(*task.plates[side], surface, side), low, high,
                                 kOnRuling * extent);
    for (Spread& section : legal[side])
      section = {surface.level(side, section.first), surface.level(side, section.second)};
  }
  return common(legal[0], legal[1]);
}

// Lowest and highest level of the bend, whose middle is the recogniser's mid-length of a cone.
std::pair<double, double> levels(const BendFit& fit) {
  const Boundary& low = fit.boundaries.low;
  const Boundary& high = fit.boundaries.high;
  if (fit.surface.kind == BendKind::general)
    return {std::min(fit.surface.level(0, low.v[0]), fit.surface.level(1, low.v[1])),
            std::max(fit.surface.level(0, high.v[0]), fit.surface.level(1, high.v[1]))};
  return {bounds(low.curve).lo.y(), bounds(high.curve).hi.y()};
}

void set_radii(FittedBend& report, const BendFit& fit, double thickness) {
  const auto [low, high] = levels(fit);
  const auto inside = [&](double level) { return fit.surface.radius(level) - 0.5 * thickness; };
  report.inside_radius = inside(0.5 * (low + high));
  if (fit.surface.kind == BendKind::general)
    report.inside_radius = middle_radius(fit.surface, fit.boundaries.low.curve,
                                         fit.boundaries.high.curve) -
                           0.5 * thickness;
  // Levels of a cone grow away from the apex, which lies to the right of the plates if the slope is
  // negative.
  const bool turned = report.line.slope < 0.0;
  report.inside_radii = {inside(turned ? high : low), inside(turned ? low : high)};
}

Result<void> check_radius(const FitTask& task, double radius) {
  if (radius - 0.5 * task.thickness >= kSmallestInsideRadius * (1.0 - tolerance::kComputed))
    return {};
  return fail(refuse::sheet_too_thick, about(task, {{"thickness", task.thickness, unit::mm},
                                                    {"radius", radius, unit::mm},
                                                    {"least", 0.5 * task.thickness, unit::mm}}));
}

Result<void> check_radii(const FitTask& task, const BendFit& fit) {
  const auto [low, high] = levels(fit);
  for (const double level : {low, high})
    if (auto radius = check_radius(task, fit.surface.radius(level)); !radius) return radius;
  return {};
}

void fill_report(BendFit& fit, const FitTask& task, const PairChoice& choice) {
  const EdgeChoice& best = choice.search.best;
  FittedBend& report = fit.report;
  report.request = task.request;
  report.edges = choice.edges(best);
  for (auto& edges : report.edges)
    std::ranges::sort(edges);
  report.edge_kind = best.kind;
  report.kind = fit.surface.kind;
  report.frame = choice.frame;
  if (fit.surface.kind == BendKind::cone) {
    report.apex = report.line.offset / report.line.slope;
    report.half_angle = Angle::radians(std::atan(fit.surface.tan_half_angle));
  }
  report.angle = fit.surface.turned();
  report.lateral = fit.boundaries.kind;
  report.width = best.width;
  report.span = best.span +
                (choice.frame.parallel() ? fit.surface.radius(0.0) * std::numbers::pi : 0.0);
  report.reach = nearness_of(choice).span;
  set_radii(report, fit, task.thickness);
}

Result<void> check_half_turn(const FitTask& task, const BendFrame& frame) {
  if (frame.parallel() && (is_conical(task.request) || task.request.inside_radii ||
                           task.request.aperture || task.request.surface == SurfaceChoice::general))
    return fail(refuse::half_turn_only, about(task, {{"field", place::pointer("/surface")}}));
  if (!frame.parallel() || !task.request.inside_radius) return {};
  const double fixed = 0.5 * (frame.rise.norm() - task.thickness);
  if (std::abs(*task.request.inside_radius - fixed) <= kSmallestInsideRadius) return {};
  return fail(refuse::half_turn_radius,
              about(task, {{"distance", frame.rise.norm(), unit::mm},
                           {"radius", fixed, unit::mm},
                           {"asked", *task.request.inside_radius, unit::mm},
                           {"field", place::pointer("/inside_radius")}}));
}

std::array<OutlineRun, 2> whole_runs(const FitTask& task, const PairChoice& choice) {
  const auto edges = choice.edges(choice.search.best);
  const Corners corners = choice.corners(choice.search.best);
  std::array<OutlineRun, 2> runs;
  for (int side = 0; side < 2; ++side)
    runs[side] = outline_run(*task.plates[side], edges[side],
                             {choice.frame.point(side, corners[side].front()),
                              choice.frame.point(side, corners[side].back())});
  return runs;
}

// Where another bend has left a part of an edge, this one does not flare out to it; a round end is
// not cut straight.
LateralBoundary lateral_wanted(const FitTask& task, const BendFit& fit, bool round_end) {
  const bool part = std::ranges::any_of(
      fit.runs, [](const OutlineRun& run) { return run.start > 0.0 || run.end < 1.0; });
  const LateralBoundary wanted = task.request.lateral;
  return (part || round_end) && wanted == LateralBoundary::automatic ? LateralBoundary::corner
                                                                     : wanted;
}

}  // namespace

double extent_of(const FitTask& task) {
  double extent = 0.0;
  for (const PlacedPlate* plate : task.plates)
    if (plate != nullptr) extent = std::max(extent, plate->extent);
  return extent;
}

Facts about(const FitTask& task, Facts facts) {
  Facts all = mapped(task.request.between,
                     [&](const std::string& id) { return Fact("plate", place::plate(id)); });
  all.insert(all.end(), std::make_move_iterator(facts.begin()),
             std::make_move_iterator(facts.end()));
  return all;
}

Error in_request(const FitTask& task, Error error) {
  const auto is = [](PlaceKind kind) {
    return [kind](const Place& place) { return place.kind == kind; };
  };
  for (Place& place : error.places)
    if (auto* key = std::get_if<std::string>(&place.id); key && place.kind == PlaceKind::pointer)
      *key = task.pointer + *key;
  if (std::ranges::none_of(error.places, is(PlaceKind::plate)))
    for (const std::string& id : task.request.between)
      error.places.push_back(place::plate(id));
  if (!task.pointer.empty() && std::ranges::none_of(error.places, is(PlaceKind::pointer)))
    error.places.push_back(place::pointer(task.pointer));
  error.where = task.pointer + (error.where.starts_with('/') ? error.where : "");
  return error;
}

Result<BendFit> fit_choice(const FitTask& task, const PairChoice& choice,
                           const ConnectOptions& options) {
  if (auto turn = check_half_turn(task, choice.frame); !turn) return pass_on(turn);
  BendFit fit;
  auto chosen = chosen_surface(task, choice, options);
  if (!chosen) return pass_on(chosen);
  fit.surface = std::move(chosen->surface);
  fit.report.line = chosen->line;
  fit.report.apex = chosen->apex;
  fit.report.extension_area = chosen->extension_area;
  // Checked before laying flat, which is impossible for a cylinder without an inside.
  if (fit.surface.kind == BendKind::cylinder)
    if (auto radius = check_radius(task, fit.surface.radius(0.0)); !radius) return pass_on(radius);
  const RunEnds ends = run_ends(fit.surface, choice.frame, choice.corners(choice.search.best));
  const LateralOptions lateral{(options.k_factor - 0.5) * task.thickness,
                               legal_on_both(task, fit.surface, ends), extent_of(task)};
  fit.runs = whole_runs(task, choice);
  auto boundaries = lateral_boundaries(fit.surface, ends,
                                       lateral_wanted(task, fit, chosen->round_end), lateral);
  if (!boundaries) return pass_on(boundaries);
  fit.boundaries = std::move(*boundaries);
  for (int side = 0; side < 2; ++side)
    fit.runs[side] = trimmed(fit.runs[side], *task.plates[side], fit.surface, fit.boundaries, side,
                             task.thickness);
  if (auto radii = check_radii(task, fit); !radii) return pass_on(radii);
  fill_report(fit, task, choice);
  return fit;
}

Result<BendFit> fit_between(const FitTask& asked, const ConnectOptions& options) {
  if (asks_for_fold(asked.request)) return fit_fold(asked, options);
  const FitTask task = at_limit_of_edges(asked, options);
  if (task.request.inside_radius && *task.request.inside_radius < kSmallestInsideRadius)
    return fail(
        in_request(task, error_of(refuse::small_radius,
                                  about(task, {{"radius", *task.request.inside_radius, unit::mm},
                                               {"least", kSmallestInsideRadius, unit::mm},
                                               {"field", place::pointer("/inside_radius")}}))));
  const auto choice = search_pair(task, options);
  if (!choice) return fail(in_request(task, with_range(task, options, choice.error())));
  auto fit = fit_choice(task, *choice, options);
  if (!fit) return fail(in_request(task, with_range(task, options, fit.error())));
  fit->report.request = asked.request;
  return fit;
}

std::optional<Nearness> nearness(const FitTask& asked, const ConnectOptions& options) {
  if (asks_for_fold(asked.request)) {
    const auto fold = fit_fold(asked, options);
    if (!fold) return std::nullopt;
    return Nearness{0.0, fold->report.width};
  }
  const FitTask task = at_limit_of_edges(asked, options);
  const auto choice = search_pair(task, options);
  if (!choice) return std::nullopt;
  return nearness_of(*choice);
}

}  // namespace planish::connect_detail
