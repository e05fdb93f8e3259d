#include "surface_choice.hpp"

#include "corners.hpp"
#include "tangent_line.hpp"
#include "tolerances.hpp"

#include <planish/base/angle.hpp>

#include <algorithm>
#include <cmath>

// Which surface a bend is (math.md#choice-of-surface). A cylinder or right cone has one slope for
// both plates, a general cone one for each, so it never needs more extension; it is taken where it
// needs less. Plates that end in tips are sides of a lofted transition: the round end between two
// tips begins parallel to the plates' bases, which a right cone's does not.

namespace planish::connect_detail {
namespace {

// Lines through the tips that meet the intersection line within this share of the extent meet there
// in one point.
constexpr double kOnePoint = 1e-6;
// The point from which the round end's tangents start lies as far from the apex as its tips, to
// within this factor.
constexpr double kFarOff = 2.0;

// The line of a cylinder, moved so far that no edge drawn along it is cut: further stretches of the
// bend may begin there, and files round.
TangentLine clear_of_drawn(const PairChoice& choice, const TangentLine& line, const FitTask& task) {
  const EdgeKind kind = choice.search.best.kind;
  const double at = -line.offset, sign = kind == EdgeKind::facing ? 1.0 : -1.0;
  double nearest = sign * at;
  for (const auto& chains : choice.chains)
    for (const Chain& chain : chains)
      for (std::size_t j = 0; chain.kind == kind && j < chain.edges.size(); ++j) {
        const double a = chain.corners[j].y(), b = chain.corners[j + 1].y();
        if (std::abs(a - at) <= kDrawn && std::abs(b - at) <= kDrawn)
          nearest = std::min({nearest, sign * a, sign * b});
      }
  const bool too_sharp = kind == EdgeKind::facing && nearest < least_height(task, choice.frame);
  return too_sharp ? line : TangentLine{0.0, -sign * nearest};
}

Result<ChosenSurface> right_of(const FitTask& task, const PairChoice& choice,
                               const ConnectOptions& options) {
  const EdgeChoice& best = choice.search.best;
  auto line = tangent_line(task, choice, options);
  if (!line) return pass_on(line);
  if (line->slope == 0.0 && !task.request.inside_radius) line = clear_of_drawn(choice, *line, task);
  return ChosenSurface{choice.frame.parallel() ? half_turn(choice.frame, *line)
                                               : tangent_surface(choice.frame, best.kind, *line),
                       *line,
                       {},
                       extension_area(choice.corners(best), best.kind, *line)};
}

/// A corner of an outline, with the corners beside it.
struct Tip {
  std::size_t corner = 0;
  Vec2 at = Vec2::Zero();  ///< in the frame of the bend
};

// The far end of a side's run, if the outline has an acute corner there.
std::optional<Tip> tip_of(const std::vector<Vec2>& outline, const std::vector<Vec2>& run,
                          const TangentLine& line, double extent) {
  const Vec2 far = line.slope > 0.0 ? run.back() : run.front();
  const std::size_t n = outline.size();
  for (std::size_t i = 0; i < n; ++i) {
    if ((outline[i] - far).norm() > kOnePoint * extent) continue;
    const Vec2 before = outline[(i + n - 1) % n] - far, after = outline[(i + 1) % n] - far;
    if (before.dot(after) > 0.0) return Tip{i, far};
  }
  return std::nullopt;
}

/// Where a line through a tip, parallel to an edge of its plate, meets the intersection line.
struct Foot {
  double x = 0.0, length = 0.0;  ///< length of the edge
};

std::vector<Foot> feet_of(const std::vector<Vec2>& outline, const Tip& tip) {
  std::vector<Foot> feet;
  const std::size_t n = outline.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (i == tip.corner || (i + 1) % n == tip.corner) continue;
    const Vec2 edge = outline[(i + 1) % n] - outline[i];
    const double x = tip.at.x() - tip.at.y() / edge.y() * edge.x();
    if (std::isfinite(x)) feet.push_back({x, edge.norm()});
  }
  return feet;
}

// Between two tips, the point of the intersection line from which the tangents of a round end start
// that are parallel to the bases of both plates.
std::optional<Vec3> round_end_of(const FitTask& task, const PairChoice& choice,
                                 const GeneralLines& lines) {
  const Corners corners = choice.corners(choice.search.best);
  const double extent = extent_of(task);
  std::array<std::vector<Foot>, 2> feet;
  double far = 0.0;
  for (int side = 0; side < 2; ++side) {
    const auto outline = side_outline(*task.plates[side], choice.frame, side);
    const auto tip = tip_of(outline, corners[side], lines.lines[side], extent);
    if (!tip) return std::nullopt;
    feet[side] = feet_of(outline, *tip);
    far += 0.5 * (tip->at.x() - lines.apex);
  }
  double longest = 0.0;
  std::optional<Vec3> point;
  for (const Foot& a : feet[0])
    for (const Foot& b : feet[1]) {
      const double off = (a.x - lines.apex) / far;
      if (std::abs(a.x - b.x) > kOnePoint * extent || off < 1.0 / kFarOff || off > kFarOff)
        continue;
      if (a.length + b.length <= longest) continue;
      longest = a.length + b.length;
      point = choice.frame.origin + a.x * choice.frame.d;
    }
  return point;
}

Result<ChosenSurface> general_of(const FitTask& task, const PairChoice& choice,
                                 const GeneralLines& lines) {
  std::optional<Vec3> point = task.request.tangent_point;
  const bool given = point.has_value();
  if (!given) point = round_end_of(task, choice, lines);
  auto surface = general_surface(choice.frame, lines, choice.corners(choice.search.best), point,
                                 extent_of(task));
  if (!surface) return pass_on(surface);
  return ChosenSurface{std::move(*surface), lines.lines[0], lines.apex, lines.area,
                       point && !given};
}

// What a general cone saves counts if a slope saves it that would not have been taken for none.
double equal_extensions(const Corners& corners, const ConnectOptions& options) {
  double squared = 0.0;
  for (const auto& side : corners)
    squared += std::pow(side.back().x() - side.front().x(), 2);
  return 0.5 * options.smallest_slope * squared;
}

}  // namespace

bool leaves_surface_free(const BendRequest& request) {
  return request.surface == SurfaceChoice::automatic && !request.slope && !request.apex &&
         !request.aperture && !request.inside_radii && !request.inside_radius;
}

bool saves_extension(const Corners& corners, double right, const ConnectOptions& options) {
  const auto lines = general_lines(corners, EdgeKind::facing, std::nullopt);
  return (lines ? lines->area : 0.0) < right - equal_extensions(corners, options);
}

std::optional<GeneralLines> less_extended(const Corners& corners, double right,
                                          const ConnectOptions& options) {
  const auto lines = general_lines(corners, EdgeKind::facing, std::nullopt);
  if (!lines || lines->area >= right - equal_extensions(corners, options)) return std::nullopt;
  return *lines;
}

Result<ChosenSurface> chosen_surface(const FitTask& task, const PairChoice& choice,
                                     const ConnectOptions& options) {
  const EdgeChoice& best = choice.search.best;
  const Corners corners = choice.corners(best);
  if (task.request.surface == SurfaceChoice::general && !choice.frame.parallel()) {
    const auto lines = general_lines(corners, best.kind, task.request.apex);
    if (!lines) return pass_on(lines);
    return general_of(task, choice, *lines);
  }
  auto right = right_of(task, choice, options);
  if (task.right_only || !leaves_surface_free(task.request) || choice.frame.parallel() ||
      best.kind == EdgeKind::averted)
    return right;
  const auto lines = general_lines(corners, best.kind, std::nullopt);
  if (!lines) return right;
  const bool wanted = !right || less_extended(corners, right->extension_area, options) ||
                      (right->surface.kind == BendKind::cone &&
                       lines->area <= right->extension_area + equal_extensions(corners, options) &&
                       round_end_of(task, choice, *lines));
  if (!wanted) return right;
  auto general = general_of(task, choice, *lines);
  return general ? std::move(general) : std::move(right);
}

}  // namespace planish::connect_detail
