#include "threads.hpp"

#include "skin_outlines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

// A thread is told from what is turned by its helices: edges that rise in proportion to their turn
// and keep their distance from the axis. Edges of turned walls are level. Some programs model it as
// rings: alike grooves between cones, one above the other.

namespace planish::brep {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

/// The distance of a helix from the axis through `centre`; empty for other curves.
std::optional<double> helix_radius(const SpaceCurve& curve, const Frame& plane,
                                   const Vec2& centre) {
  constexpr int kSteps = 16;        // of a quarter turn at most, for four turns
  constexpr double kLeast = 0.25;   // of a turn
  constexpr double kFitted = 0.02;  // of the radius, and of the rise: files fit helices
  std::array<double, kSteps + 1> turn{}, rise{};
  double radius = 0.0;
  for (int i = 0; i <= kSteps; ++i) {
    const Vec3 local = plane.local(
        curve.point(std::lerp(curve.t0, curve.t1, static_cast<double>(i) / kSteps)));
    const Vec2 out = local.head<2>() - centre;
    if (i == 0) radius = out.norm();
    if (std::abs(out.norm() - radius) > kFitted * radius) return {};
    const double at = std::atan2(out.y(), out.x());
    turn[i] = i == 0 ? at : turn[i - 1] + std::remainder(at - turn[i - 1], kTurn);
    rise[i] = local.z();
  }
  const double turned = turn.back() - turn.front(), risen = rise.back() - rise.front();
  if (std::abs(turned) < kLeast * kTurn || std::abs(risen) < kFitted * radius) return {};
  for (int i = 0; i <= kSteps; ++i)
    if (std::abs((rise[i] - rise[0]) / risen - (turn[i] - turn[0]) / turned) > kFitted) return {};
  return radius;
}

/// A cone about the axis: of the circles at its ends the heights and the radii, the lower first.
struct Ring {
  double low = 0.0, high = 0.0, from = 0.0, to = 0.0;
};
std::optional<Ring> ring_of(const SolidModel& model, int face, const Frame& plane,
                            const Vec2& centre) {
  std::vector<Vec2> ends;  // radius, height
  for (const auto& loop : model.faces[face].loops)
    for (const CoEdge& use : loop) {
      const SpaceCurve& curve = model.edges[use.edge].curve;
      if (curve.kind != SpaceCurve::Kind::circle) continue;
      const Vec3 middle = plane.local(curve.circle.origin);
      if ((middle.head<2>() - centre).norm() <= kWiderOutline)
        ends.emplace_back(curve.radius, middle.z());
    }
  if (ends.size() < 2) return {};
  const auto [low, high] = std::ranges::minmax(ends, {}, [](const Vec2& end) { return end.y(); });
  if (std::abs(high.x() - low.x()) <= kWiderOutline) return {};
  return Ring{low.y(), high.y(), low.x(), high.x()};
}

/// How far rings go from the axis: two grooves at least, as wide as each other; else 0.
double rings_radius(const Recognition& of, const RimPart& part, const Frame& plane,
                    const Vec2& centre) {
  std::vector<Ring> rings;
  for (const int f : part.faces)
    if (const auto ring = ring_of(of.model, f, plane, centre)) rings.push_back(*ring);
  std::ranges::sort(rings, {}, &Ring::low);
  double radius = 0.0;
  int grooves = 0;
  for (size_t i = 1; i < rings.size(); ++i) {
    const Ring &below = rings[i - 1], &above = rings[i];
    if (below.to <= below.from || above.to >= above.from) continue;
    if (grooves > 0 && std::abs(below.to - radius) > kWiderOutline) return 0.0;
    radius = below.to;
    ++grooves;
  }
  return grooves > 1 ? radius : 0.0;
}

}  // namespace

std::optional<BorderLoop> thread_about(const Recognition& of, const RimPart& part,
                                       const Frame& plane, const BorderLoop& core) {
  const auto* arc = core.size() == 1 ? std::get_if<Arc>(&core.front().curve) : nullptr;
  if (!arc) return {};
  double radius = rings_radius(of, part, plane, arc->center);
  for (const int edge : wall_edges(of, part))
    radius = std::max(radius,
                      helix_radius(of.model.edges[edge].curve, plane, arc->center).value_or(0.0));
  if (radius <= arc->radius + kWiderOutline) return {};
  BorderLoop circle(1);
  circle.front().curve = Arc{arc->center, radius, 0.0, -kTurn};
  return circle;
}

}  // namespace planish::brep
