#include "threads.hpp"

#include "skin_outlines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

// A thread is told from what is turned by its helices: edges that rise in proportion to their turn
// and keep their distance from the axis. Edges of turned walls are level.

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

}  // namespace

std::optional<BorderLoop> thread_about(const Recognition& of, const RimPart& part,
                                       const Frame& plane, const BorderLoop& core) {
  const auto* arc = core.size() == 1 ? std::get_if<Arc>(&core.front().curve) : nullptr;
  if (!arc) return {};
  double radius = 0.0;
  for (const int edge : wall_edges(of, part))
    radius = std::max(radius,
                      helix_radius(of.model.edges[edge].curve, plane, arc->center).value_or(0.0));
  if (radius <= arc->radius + kWiderOutline) return {};
  BorderLoop circle(1);
  circle.front().curve = Arc{arc->center, radius, 0.0, -kTurn};
  return circle;
}

}  // namespace planish::brep
