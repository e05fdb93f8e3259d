#include "narrowest.hpp"

#include "borders.hpp"
#include "passages.hpp"
#include "threads.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/geometry/plane.hpp>
#include <planish/geometry/region.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

// What passes through an opening (math.md#narrowest-section). Seen along the sheet's normal, the
// faces between the skins that look up lie above what is open and those that look down below it, so
// the chain of edges between both encloses the narrowest section; passages.cpp finds it as a
// smallest cut. The farthest line of a wall that is one round face lies on no edge: it is computed
// from the surface.

namespace planish::brep {
namespace {

/// 1 − cosine, or sine: axes of one feature agree to the digits of a STEP file.
constexpr double kParallel = tolerance::kComputed;

double depth_of(const Frame& plane, const Vec3& point) { return -plane.local(point).z(); }

struct Depths {
  double least = 0.0, most = 0.0;
};
Depths depths_of(const Outline& outline, const Frame& plane) {
  std::vector<double> depths;
  for (const auto& ring : outline.rings)
    for (const Vec3& point : ring)
      depths.push_back(depth_of(plane, point));
  if (depths.empty()) return {};
  const auto [least, most] = std::ranges::minmax(depths);
  return {least, most};
}

/// Lying along a border: the border where the cylinder, convex, reaches farthest to its right.
std::optional<Border> bulge_of(const Cylinder& cylinder, const Frame& plane, const Border& border) {
  const auto* segment = std::get_if<Segment>(&border.curve);
  if (!segment || std::abs(cylinder.frame.z.dot(plane.z)) > kParallel) return {};
  const Vec2 along = (segment->b - segment->a).normalized();
  const Vec2 axis(cylinder.frame.z.dot(plane.x), cylinder.frame.z.dot(plane.y));
  if (1.0 - std::abs(axis.dot(along)) > kParallel) return {};
  const Vec2 right = -perpendicular(along);
  const double by = (plane.local2(cylinder.frame.origin) - segment->a).dot(right) + cylinder.radius;
  Border moved = border;
  moved.curve = Segment{segment->a + by * right, segment->b + by * right};
  moved.edge_depth = depth_of(plane, cylinder.frame.origin);
  if (by <= 0.0) return {};
  return moved;
}

/// The same of a torus about the middle of an arc.
std::optional<Border> bulge_of(const Torus& torus, const Frame& plane, const Border& border,
                               double tolerance) {
  const auto* arc = std::get_if<Arc>(&border.curve);
  if (!arc || 1.0 - std::abs(torus.frame.z.dot(plane.z)) > kParallel) return {};
  if ((plane.local2(torus.frame.origin) - arc->center).norm() > tolerance) return {};
  const double outwards = arc->sweep > 0.0 ? 1.0 : -1.0;
  Arc moved = *arc;
  moved.radius = torus.major + outwards * torus.minor;
  if (moved.radius <= 0.0 || outwards * (moved.radius - arc->radius) <= 0.0) return {};
  Border result = border;
  result.curve = moved;
  result.edge_depth = depth_of(plane, torus.frame.origin);
  return result;
}

/// The edges of a section as borders; those that stand upright are seen as points and left out.
/// Empty where one slants.
BorderLoop level_borders(const Recognition& of, const std::vector<CoEdge>& chain,
                         const Frame& plane) {
  const BorderLoop seen = read_borders(of.model, chain, plane, 0.0, of.tolerance);
  BorderLoop level;
  for (size_t i = 0; i < chain.size(); ++i) {
    if (length(seen[i].curve) <= of.tolerance) continue;
    const auto depth = level_depth(of.model.edges[chain[i].edge].curve, plane, of.tolerance);
    if (!depth) return {};
    level.push_back(seen[i]);
    level.back().edge_depth = *depth;
  }
  return level;
}

/// A hollow cylinder upright to a plane, seen along its normal, and how much of its turn walls
/// have.
struct Core {
  Vec2 centre;
  double radius = 0.0;
  double turn = 0.0;
};
std::optional<Core> core_of(const Recognition& of, int wall, const Frame& plane) {
  const SolidFace& face = of.model.faces[wall];
  const auto* surface = std::get_if<Developable>(&face.surface);
  const auto* cylinder = surface ? std::get_if<Cylinder>(surface) : nullptr;
  if (!cylinder || face.sense > 0 || 1.0 - std::abs(cylinder->frame.z.dot(plane.z)) > kParallel)
    return {};
  const Outline& outline = of.outlines[wall];
  return Core{plane.local2(cylinder->frame.origin), cylinder->radius,
              outline.box.size().x() / outline.u_scale};
}

/// Segments that were moved apart, or over each other, meet in their lines' crossing.
void meet(Curve2& before, Curve2& after) {
  auto* first = std::get_if<Segment>(&before);
  auto* second = std::get_if<Segment>(&after);
  if (!first || !second) return;
  const Vec2 along = first->b - first->a, beyond = second->b - second->a;
  const double turn = cross(along, beyond);
  if (std::abs(turn) <= kParallel * along.norm() * beyond.norm()) return;
  first->b += cross(second->a - first->b, beyond) / turn * along;
  second->a = first->b;
}

/// A loop with the polygon that tells what it holds.
class Drawn {
 public:
  Drawn(const BorderLoop& loop, double thickness)
      : curves_(mapped(loop, &Border::curve)),
        rings_{sampled(curves_, kChord * thickness)},
        box_(bounds(loop)) {}

  bool holds(const Vec2& p) const {
    const bool near = p.x() > box_.lo.x() && p.y() > box_.lo.y() && p.x() < box_.hi.x() &&
                      p.y() < box_.hi.y();
    return near && inside(rings_, p);
  }
  /// From the loop; anything below `enough` if it is less.
  double distance(const Vec2& p, double enough) const {
    double off = std::numeric_limits<double>::infinity();
    for (const Curve2& curve : curves_)
      if (off > enough) off = std::min(off, nearest(curve, p).distance);
    return off;
  }

 private:
  static constexpr double kChord = 1e-4;  // of the thickness
  Loop curves_;
  std::vector<std::vector<Vec2>> rings_;
  Box2 box_;
};

std::vector<Vec2> points_of(const Recognition& of, const std::vector<int>& faces,
                            const Frame& plane) {
  std::vector<Vec2> points;
  for (const int f : faces)
    for (const auto& ring : of.outlines[f].rings)
      for (const Vec3& point : ring)
        points.push_back(plane.local2(point));
  return points;
}

bool is_closed(const BorderLoop& loop, double tolerance) {
  for (size_t i = 0; i < loop.size(); ++i)
    if ((end_of(loop[i].curve) - start_of(loop[(i + 1) % loop.size()].curve)).norm() > tolerance)
      return false;
  return !loop.empty();
}

}  // namespace

std::optional<Border> bulge_below(const Recognition& of, int wall, const Frame& plane,
                                  const Border& border) {
  const SolidFace& face = of.model.faces[wall];
  if (of.rim.part_of[wall] < 0 || face.sense < 0) return {};
  std::optional<Border> bulge;
  if (const auto* surface = std::get_if<Developable>(&face.surface)) {
    if (const auto* cylinder = std::get_if<Cylinder>(surface))
      bulge = bulge_of(*cylinder, plane, border);
  } else if (const auto* curved = std::get_if<DoublyCurved>(&face.surface)) {
    if (curved->torus) bulge = bulge_of(*curved->torus, plane, border, of.tolerance);
  }
  if (!bulge) return {};
  const auto [least, most] = depths_of(of.outlines[wall], plane);
  if (bulge->edge_depth <= least + of.tolerance || bulge->edge_depth >= most - of.tolerance)
    return {};
  bulge->edge.reset();
  bulge->edge_length.reset();
  return bulge;
}

BorderLoop with_bulges(const Recognition& of, const Frame& plane, BorderLoop loop) {
  std::vector<bool> moved(loop.size());
  for (size_t i = 0; i < loop.size(); ++i)
    for (const int wall : of.model.edges[*loop[i].edge - 1].faces)
      if (auto bulge = wall < 0 ? std::nullopt : bulge_below(of, wall, plane, loop[i])) {
        loop[i] = std::move(*bulge);
        moved[i] = true;
        break;
      }
  for (size_t i = 0; i < loop.size(); ++i)
    if (const size_t next = (i + 1) % loop.size(); moved[i] && moved[next])
      meet(loop[i].curve, loop[next].curve);
  return loop;
}

std::optional<BorderLoop> narrowest_section(const Recognition& of, const RimPart& part,
                                            const Frame& plane) {
  const auto chains = passages(of, part, plane);
  if (chains.size() != 1) return {};
  BorderLoop section = level_borders(of, chains.front(), plane);
  if (section.empty()) return {};
  section = with_bulges(of, plane, std::move(section));
  constexpr double kClosed = 1e-3;  // mm: files of loose tolerance leave gaps
  if (!is_closed(section, kClosed)) return {};
  return section;
}

std::optional<BorderLoop> round_core(const Recognition& of, const RimPart& part,
                                     const Frame& plane) {
  constexpr double kSame = 1e-4;      // mm: files round
  constexpr double kRound = 0.999;    // of a turn
  constexpr double kThreaded = 0.25;  // the same of what is left of a thread's core
  constexpr double kFitted = 5e-3;    // mm: edges of modelled threads are fitted
  constexpr double kTurn = 2 * std::numbers::pi;
  std::vector<Core> cores;
  for (const int wall : part.faces)
    if (const auto core = core_of(of, wall, plane)) cores.push_back(*core);
  const auto least = std::ranges::min_element(cores, {}, &Core::radius);
  if (least == cores.end()) return {};
  const double turn = sum_of(cores, [&](const Core& core) {
    const bool same = (core.centre - least->centre).norm() <= kSame &&
                      core.radius - least->radius <= kSame;
    return same ? core.turn : 0.0;
  });
  BorderLoop circle(1);
  circle.front().curve = Arc{least->centre, least->radius, 0.0, -kTurn};
  if (intrusion_into(of, part, plane, circle) > kFitted) return {};
  const bool round = turn >= kRound * kTurn ||
                     (turn >= kThreaded * kTurn && thread_about(of, part, plane, circle));
  return round ? std::optional(circle) : std::nullopt;
}

double intrusion_into(const Recognition& of, const RimPart& part, const Frame& plane,
                      const BorderLoop& section) {
  const Drawn drawn(section, of.skins.thickness);
  double deepest = 0.0;
  for (const Vec2& p : points_of(of, part.faces, plane))
    if (drawn.holds(p)) deepest = std::max(deepest, drawn.distance(p, deepest));
  return deepest;
}

Reach reach_beyond(const Recognition& of, const std::vector<int>& faces, const Frame& plane,
                   const BorderLoop& outline) {
  const Drawn drawn(outline, of.skins.thickness);
  Reach farthest;
  for (const Vec2& p : points_of(of, faces, plane))
    if (!drawn.holds(p))
      if (const double off = drawn.distance(p, farthest.beyond); off > farthest.beyond)
        farthest = {off, p};
  return farthest;
}

}  // namespace planish::brep
