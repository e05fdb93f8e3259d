#include "tangent_line.hpp"

#include "corners.hpp"
#include "refusals.hpp"
#include "tolerances.hpp"

#include <planish/connect/codes.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

// The tangent line on which a bend is built (math.md#least-extension), with all that a request may
// give of it: slope, apex, radius at an end or in the middle, aperture. An inside radius above zero
// is a least height, and the program is solved for corners moved down by that height. Where nothing
// fits, the range that would is found by the same programs, for the message.

namespace planish::connect_detail {
namespace {

// Plates whose edges come within this share of their extent of the intersection line touch there.
constexpr double kTouching = tolerance::kFileDigits;
// A value within this share of the extent of a limit is at the limit.
constexpr double kOnBound = tolerance::kComputed;

double mid_radius_of(double inside_radius, const FitTask& task) {
  return inside_radius + 0.5 * task.thickness;
}

Corners shifted(Corners corners, double x, double y) {
  for (auto& side : corners)
    for (Vec2& p : side)
      p -= Vec2(x, y);
  return corners;
}

// Least extension with the line at least `height` above the intersection line: equivalent to 0 ≤ k
// x − q with corners and q moved by `height`; averted lines lie above every corner anyway.
Result<SmallestExtension> least_extension(Corners corners, EdgeKind kind, GivenLine given,
                                          double height) {
  if (kind == EdgeKind::averted) {
    for (auto& side : corners)
      for (Vec2& p : side)
        p.y() = std::max(p.y(), height);
    return smallest_extension(corners, kind, given);
  }
  if (given.offset) *given.offset += height;
  if (given.apex) {
    // k (x − x₀) is the height itself and cannot be moved: a line through the apex has only its
    // slope free.
    return smallest_extension(corners, kind, given);
  }
  auto fit = smallest_extension(shifted(std::move(corners), 0.0, height), kind, given);
  if (fit) fit->line.offset -= height;
  return fit;
}

// What `least_extension` leaves of the slopes and offsets that the edges allow.
std::optional<Range> slopes_with_room(const Corners& corners, EdgeKind kind, double height) {
  return feasible_slopes(kind == EdgeKind::facing ? shifted(corners, 0.0, height) : corners, kind);
}
std::optional<Range> offsets_with_room(const Corners& corners, EdgeKind kind, double slope,
                                       double height) {
  if (kind == EdgeKind::averted) return feasible_offsets(corners, kind, slope);
  auto range = feasible_offsets(shifted(corners, 0.0, height), kind, slope);
  if (range) range = Range{range->low - height, range->high - height};
  return range;
}

bool touch(const Corners& corners, double extent) {
  return std::ranges::all_of(
      corners, [&](const auto& side) { return box_of(side).lo.y() <= kTouching * extent; });
}

tl::unexpected<Error> too_sharp(const FitTask& task, const PairChoice& choice,
                                const Corners& corners) {
  if (touch(corners, extent_of(task)))
    return fail(refuse::touch_at_bend,
                about(task, {{"least", least_height(task, choice.frame), unit::mm}}));
  const double radius = lowest(corners) * std::tan(0.5 * choice.frame.beta.radians());
  return fail(refuse::edges_too_near,
              about(task, {{"radius", radius, unit::mm},
                           {"thickness", task.thickness, unit::mm},
                           {"least", 0.5 * task.thickness, unit::mm},
                           {"distance", least_height(task, choice.frame), unit::mm}}));
}

// Whether a line, above zero at both ends of the edges, cuts none of them off.
bool leaves_whole(const Corners& corners, EdgeKind kind, const TangentLine& line,
                  double tolerance) {
  for (const auto& side : corners)
    for (const Vec2& p : side) {
      const double height = line.at(p.x());
      if (kind == EdgeKind::facing ? height > p.y() + tolerance : height < p.y() - tolerance)
        return false;
    }
  return true;
}

/// The refusal of what stands at a key of the request.
tl::unexpected<Error> does_not_fit(const FitTask& task, const Refusal& refusal, const char* key,
                                   Facts facts) {
  facts.emplace_back("field", place::pointer(key));
  return fail(refusal, about(task, std::move(facts)));
}

// A cone by its inside radii at the ends of the edges: the radius is linear in x.
Result<TangentLine> by_radii(const FitTask& task, const PairChoice& choice,
                             const Corners& corners) {
  const auto& radii = *task.request.inside_radii;
  const double left = tangent_distance(choice.frame, mid_radius_of(radii[0], task));
  const double right = tangent_distance(choice.frame, mid_radius_of(radii[1], task));
  const double x = low_x(corners);
  const double slope = (right - left) / (high_x(corners) - x);
  const TangentLine line{slope, slope * x - left};
  if (leaves_whole(corners, choice.search.best.kind, line, kOnBound * extent_of(task))) return line;
  const double scale = std::tan(0.5 * choice.frame.beta.radians());
  const auto radius = [&](double y) { return y * scale - 0.5 * task.thickness; };
  const auto slopes = feasible_slopes(corners, choice.search.best.kind);
  const double room_left = radius(std::min(corners[0].front().y(), corners[1].front().y()));
  const double room_right = radius(std::min(corners[0].back().y(), corners[1].back().y()));
  Facts facts{{"asked", radii[0], unit::mm},
              {"asked", radii[1], unit::mm},
              {"room", room_left, unit::mm},
              {"room", room_right, unit::mm}};
  if (slopes && std::isfinite(slopes->low)) {
    facts.emplace_back("least_slope", slopes->low, unit::none);
    facts.emplace_back("most_slope", slopes->high, unit::none);
  }
  return does_not_fit(task, refuse::radii_cut_plate, "/inside_radii", std::move(facts));
}

// A cone of given aperture may open to the left or to the right: takes the one with less extension.
Result<TangentLine> by_aperture(const FitTask& task, const PairChoice& choice,
                                const Corners& corners) {
  const double tangent = std::tan(0.5 * choice.frame.beta.radians());
  const double sine = std::tan(0.5 * task.request.aperture->radians()) / tangent;
  const EdgeKind kind = choice.search.best.kind;
  const double height = least_height(task, choice.frame);
  std::optional<SmallestExtension> best;
  if (sine < 1.0)
    for (const double sign : {1.0, -1.0}) {
      const auto fit = least_extension(corners, kind,
                                       GivenLine{sign * std::tan(std::asin(sine)), {}, {}}, height);
      if (fit && (!best || fit->area < best->area)) best = *fit;
    }
  if (best) return best->line;
  const auto slopes = slopes_with_room(corners, kind, height);
  const double steepest = slopes ? std::max(std::abs(slopes->low), std::abs(slopes->high)) : 0.0;
  const double widest = 2.0 * std::atan(std::sin(std::atan(steepest)) * tangent);
  return does_not_fit(task, refuse::aperture_too_wide, "/aperture",
                      {{"aperture", task.request.aperture->degrees(), unit::degrees},
                       {"most", Angle::radians(widest).degrees(), unit::degrees}});
}

// A cone with a given inside radius at mid-length: the height there is given.
Result<SmallestExtension> by_middle_radius(const FitTask& task, const PairChoice& choice,
                                           const Corners& corners) {
  const double middle = 0.5 * (low_x(corners) + high_x(corners));
  const double height = tangent_distance(choice.frame,
                                         mid_radius_of(*task.request.inside_radius, task));
  GivenLine given{task.request.slope, -height, {}};
  auto fit = smallest_extension(shifted(corners, middle, 0.0), choice.search.best.kind, given);
  if (fit) fit->line.offset += fit->line.slope * middle;
  return fit;
}

std::optional<Error> apex_within(const BendRequest& asked, const Corners& corners) {
  if (!asked.apex || *asked.apex <= low_x(corners) || *asked.apex >= high_x(corners))
    return std::nullopt;
  return error_of(refuse::apex_between, {{"apex", *asked.apex, unit::mm},
                                         {"low", low_x(corners), unit::mm},
                                         {"high", high_x(corners), unit::mm},
                                         {"field", place::pointer("/apex")}});
}

Result<TangentLine> least(const FitTask& task, const PairChoice& choice, const Corners& corners,
                          const ConnectOptions& options) {
  const BendRequest& request = task.request;
  const EdgeKind kind = choice.search.best.kind;
  const GivenLine given = given_line(request, choice.frame, task.thickness);
  const double height = least_height(task, choice.frame);
  auto fit = request.inside_radius && is_conical(request)
                 ? by_middle_radius(task, choice, corners)
                 : least_extension(corners, kind, given, height);
  if (!fit) {
    if (!least_extension(corners, kind, {}, height)) return too_sharp(task, choice, corners);
    return pass_on(fit);
  }
  if (given.apex && fit->line.slope == 0.0) return too_sharp(task, choice, corners);
  // Below this slope a cone is a cylinder to the kernel and to the shop, even if requested.
  constexpr double kNoSlope = kNegligible;
  const double slope = std::abs(fit->line.slope);
  const bool asked = given.slope || given.apex || request.surface == SurfaceChoice::cone;
  if (slope != 0.0 && slope < (asked ? kNoSlope : options.smallest_slope)) {
    const auto cylinder = least_extension(corners, kind, GivenLine{0.0, {}, {}}, height);
    if (cylinder) return cylinder->line;
  }
  if (request.surface == SurfaceChoice::cone && fit->line.slope == 0.0)
    return does_not_fit(task, refuse::cone_is_cylinder, "/surface", {});
  return fit->line;
}

tl::unexpected<Error> slope_beyond(const FitTask& task, const Range& slopes) {
  const double slope = *task.request.slope;
  if (!std::isfinite(slopes.low))
    return does_not_fit(task, refuse::slope_of_none, "/slope", {{"slope", slope, unit::none}});
  return does_not_fit(task, refuse::slope_beyond, "/slope",
                      {{"slope", slope, unit::none},
                       {"low", slopes.low, unit::none},
                       {"high", slopes.high, unit::none}});
}

// The error for a cone's radius at mid-length that does not fit, with the nearest one that does.
tl::unexpected<Error> nearest_middle_radius(const FitTask& task, const PairChoice& choice) {
  const Corners corners = choice.corners(choice.search.best);
  if (const auto slopes = slopes_with_room(corners, choice.search.best.kind,
                                           least_height(task, choice.frame));
      task.request.slope && slopes &&
      (*task.request.slope < slopes->low || *task.request.slope > slopes->high))
    return slope_beyond(task, *slopes);
  FitTask tried = task;
  const auto fits = [&](double radius) {
    tried.request.inside_radius = radius;
    const auto fit = by_middle_radius(tried, choice, corners);
    if (!fit) return false;
    const double lowest = std::min(fit->line.at(low_x(corners)), fit->line.at(high_x(corners)));
    return lowest >= least_height(task, choice.frame) && fit->line.slope != 0.0;
  };
  const double scale = std::tan(0.5 * choice.frame.beta.radians());
  const double middle = 0.5 * (low_x(corners) + high_x(corners));
  const auto free = smallest_extension(corners, choice.search.best.kind,
                                       GivenLine{task.request.slope, {}, {}});
  const double asked = *task.request.inside_radius;
  if (double good = free ? free->line.at(middle) * scale - 0.5 * task.thickness : -1.0;
      free && fits(good)) {
    double bad = asked;
    constexpr int kHalvings = 50;
    for (int i = 0; i < kHalvings; ++i) {
      const double between = 0.5 * (good + bad);
      (fits(between) ? good : bad) = between;
    }
    return does_not_fit(task, refuse::middle_radius, "/inside_radius",
                        {{"asked", asked, unit::mm}, {"nearest", good, unit::mm}});
  }
  return does_not_fit(task, refuse::middle_radius_of_none, "/inside_radius",
                      {{"asked", asked, unit::mm}});
}

// The largest (facing) or smallest (averted) distance at which a cylinder is tangent to both
// plates.
struct Reach {
  double facing = -1.0, averted = std::numeric_limits<double>::infinity();
};
Reach reach(const PairChoice& choice) {
  Reach both{std::numeric_limits<double>::infinity(), 0.0};
  for (const auto& chains : choice.chains) {
    double far = -1.0, near = std::numeric_limits<double>::infinity();
    for (const Chain& chain : chains)
      for (std::size_t j = 0; j < chain.edges.size(); ++j) {
        const double a = chain.corners[j].y(), b = chain.corners[j + 1].y();
        if (chain.kind == EdgeKind::facing)
          far = std::max(far, std::min(a, b));
        else
          near = std::min(near, std::max(a, b));
      }
    both.facing = std::min(both.facing, far);
    both.averted = std::max(both.averted, near);
  }
  return both;
}

// The reach for the edges that are given, or for all.
Reach reach_of(const FitTask& task, const PairChoice& choice) {
  if (!task.request.edges[0] && !task.request.edges[1]) return reach(choice);
  PairChoice chosen = choice;
  const EdgeChoice& best = choice.search.best;
  const auto corners = choice.corners(best);
  const auto edges = choice.edges(best);
  for (std::size_t side = 0; side < 2; ++side)
    if (task.request.edges[side])
      chosen.chains[side] = {Chain{best.kind, corners[side], edges[side]}};
  Reach both = reach(chosen);
  // All given edges take part, not only the best of them.
  for (std::size_t side = 0; side < 2; ++side)
    if (task.request.edges[side])
      for (const Vec2& p : corners[side]) {
        both.facing = std::min(both.facing, p.y());
        both.averted = std::max(both.averted, p.y());
      }
  return both;
}

// The refusal of a cylinder's radius, with those that fit.
tl::unexpected<Error> radius_beyond(const FitTask& task, const PairChoice& choice) {
  const Reach both = reach_of(task, choice);
  const double scale = std::tan(0.5 * choice.frame.beta.radians());
  const double largest = both.facing * scale - 0.5 * task.thickness;
  const double smallest = both.averted * scale - 0.5 * task.thickness;
  const bool in_front = largest > 0.0, behind = std::isfinite(smallest);
  if (!in_front && !behind) return too_sharp(task, choice, choice.corners(choice.search.best));
  Facts facts{{"asked", *task.request.inside_radius, unit::mm}};
  if (in_front) facts.emplace_back("largest", largest, unit::mm);
  if (behind) facts.emplace_back("smallest", std::max(smallest, 0.0), unit::mm);
  return does_not_fit(task,
                      !behind    ? refuse::radius_up_to
                      : in_front ? refuse::radius_up_to_or_from
                                 : refuse::radius_from,
                      "/inside_radius", std::move(facts));
}

// The error with the apex that the edges have by themselves.
Error with_free_apex(Error error, const TangentLine& line, const char* key) {
  const bool level = line.slope == 0.0;
  Facts facts;
  if (!level) facts.emplace_back("free_apex", line.offset / line.slope, unit::mm);
  Told told = tell(level ? "With nothing given the bend would be a cylinder."
                         : "With nothing given the apex would be at {free_apex:6}.",
                   facts);
  say_after(error, told);
  std::ranges::move(told.numbers, std::back_inserter(error.numbers));
  error.where = key;
  return error;
}

}  // namespace

Result<TangentLine> tangent_line(const FitTask& task, const PairChoice& choice,
                                 const ConnectOptions& options) {
  const Corners corners = choice.corners(choice.search.best);
  if (choice.frame.parallel()) return TangentLine{0.0, -std::max(0.0, highest(corners))};
  // A line through such an apex does not cut the plates only if its height is zero.
  if (auto within = apex_within(task.request, corners)) return tl::unexpected(*within);
  if (task.request.inside_radii) return by_radii(task, choice, corners);
  if (task.request.aperture) return by_aperture(task, choice, corners);
  return least(task, choice, corners, options);
}

Error with_range(const FitTask& task, const ConnectOptions& options, const Error& error) {
  if (error.code != code::no_bend_fits) return error;
  const BendRequest& asked = task.request;
  if (!asked.inside_radius && !asked.slope && !asked.apex) return error;
  if (error.where == "/surface" ||
      plane_pair(*task.plates[0], *task.plates[1], options.planarity) == PlanePair::parallel)
    return error;
  FitTask free = task;
  free.request.inside_radius.reset();
  free.request.slope.reset();
  free.request.apex.reset();
  const auto choice = search_pair(free, options);
  if (!choice) return choice.error();
  const Corners corners = choice->corners(choice->search.best);
  if (asked.inside_radius && is_conical(asked)) return nearest_middle_radius(task, *choice).value();
  if (asked.inside_radius) return radius_beyond(task, *choice).value();
  const EdgeKind kind = choice->search.best.kind;
  if (const auto within = apex_within(asked, corners)) return *within;
  if (asked.slope) {
    const double height = least_height(task, choice->frame);
    const auto slopes = slopes_with_room(corners, kind, height);
    if (slopes && (*asked.slope < slopes->low || *asked.slope > slopes->high || !asked.apex))
      return slope_beyond(task, *slopes).value();
    const auto offsets = offsets_with_room(corners, kind, *asked.slope, height);
    if (offsets && *asked.slope != 0.0) {
      const double a = offsets->low / *asked.slope, b = offsets->high / *asked.slope;
      return does_not_fit(task, refuse::apex_of_slope, "/apex",
                          {{"slope", *asked.slope, unit::none},
                           {"apex", *asked.apex, unit::mm},
                           {"low", std::min(a, b), unit::mm},
                           {"high", std::max(a, b), unit::mm}})
          .value();
    }
  }
  return with_free_apex(error, choice->search.best.line, asked.apex ? "/apex" : "");
}

}  // namespace planish::connect_detail
