#include "plate_pairs.hpp"

#include "bend_frame.hpp"
#include "lateral.hpp"
#include "tolerances.hpp"

#include <planish/geometry/plane.hpp>
#include <planish/geometry/region.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

// Whether two plates pass through each other, or leave each other no room. Planes that cross share
// their line only: plates intersect where both have material there on both of its sides. Each sheet
// needs half its thickness, as far as it leans over the other; near a border a bend or a weld may
// be intended, so only places farther in count.

namespace planish::connect_detail {
namespace {

// Plates that pass through each other by less than this share of their extent touch.
constexpr double kTouch = kNegligible;

// Intervals of the line y = 0 with material on both of its sides.
std::vector<Spread> inside_intervals(const PlacedPlate& plate, const Vec3& origin, const Vec3& d,
                                     const Vec3& e, double tolerance) {
  std::vector<std::vector<Vec2>> above, below;
  double low = 0.0, high = 0.0;
  for (int r = 0; r < plate.ring_count(); ++r) {
    std::vector<Vec2>&over = above.emplace_back(), &under = below.emplace_back();
    for (const Vec2& corner : plate.ring(r)) {
      const Vec3 p = plate.frame.point(corner) - origin;
      over.emplace_back(p.dot(d), p.dot(e));
      under.emplace_back(p.dot(d), -p.dot(e));
      low = std::min(low, p.dot(d));
      high = std::max(high, p.dot(d));
    }
  }
  // Complements of the sections that are free on one side or the other.
  std::vector<Spread> free = legal_sections(above, low, high, tolerance);
  for (const Spread& section : legal_sections(below, low, high, tolerance))
    free.push_back(section);
  return left_free(std::move(free), low, high);
}

std::optional<Vec3> crossing(const PlacedPlate& a, const PlacedPlate& b, const BendFrame& frame) {
  const double tolerance = kTouch * std::max(a.extent, b.extent);
  for (const Spread& p : inside_intervals(a, frame.origin, frame.d, frame.e[0], tolerance))
    for (const Spread& q : inside_intervals(b, frame.origin, frame.d, frame.e[1], tolerance)) {
      const double low = std::max(p.first, q.first), high = std::min(p.second, q.second);
      if (high - low > tolerance) return frame.origin + 0.5 * (low + high) * frame.d;
    }
  return std::nullopt;
}

std::optional<Vec3> common_area(const PlacedPlate& a, const PlacedPlate& b) {
  Polygon first{a.outline, a.holes}, second;
  for (int r = 0; r < b.ring_count(); ++r) {
    auto ring = mapped(b.ring(r), [&](const Vec2& p) { return a.frame.local2(b.frame.point(p)); });
    if ((ring_area(ring) < 0.0) == (r == 0)) std::ranges::reverse(ring);
    if (r == 0)
      second.outer = std::move(ring);
    else
      second.holes.push_back(std::move(ring));
  }
  const double extent = std::max(a.extent, b.extent);
  const auto shared = overlaps({first, second}, 0.0, kTouch * extent * extent);
  if (shared.empty()) return std::nullopt;
  return a.frame.point(shared.front().outline.front().front());
}

}  // namespace

std::optional<Vec3> intersection(const PlacedPlate& a, const PlacedPlate& b, double planarity) {
  const PlanePair kind = plane_pair(a, b, planarity);
  if (kind == PlanePair::coplanar) return common_area(a, b);
  if (kind == PlanePair::parallel) return std::nullopt;
  const auto frames = bend_frames(a, b, kind);
  if (frames.empty()) return std::nullopt;
  return crossing(a, b, frames.front());
}

std::optional<TooNear> too_near(const PlacedPlate& a, const PlacedPlate& b, double thickness) {
  // Two sheets need half a thickness each: b's counts as far as it leans over a.
  const double leaning = std::abs(a.frame.z.dot(b.frame.z));
  const double needed = 0.5 * thickness * (1.0 + leaning);
  constexpr int kParts = 16;  // of an edge
  for (int i = 0; i < b.edge_count(); ++i)
    for (int k = 0; k < kParts; ++k) {
      const Vec3 from = b.corner(i), to = b.corner((i + 1) % b.edge_count());
      const Vec3 p = from + double(k) / kParts * (to - from);
      const Vec3 local = a.frame.local(p);
      const double distance = std::abs(local.z());
      if (distance >= needed * (1.0 - kTouch) || !inside({a.outline}, local.head<2>())) continue;
      // Near a's border a bend or a weld may be intended; farther in, the sheets overlap.
      double to_border = distance_to_ring(a.outline, local.head<2>());
      for (const auto& hole : a.holes)
        to_border = std::min(to_border, distance_to_ring(hole, local.head<2>()));
      if (to_border <= thickness) continue;
      const bool in_hole = std::ranges::any_of(
          a.holes, [&](const auto& hole) { return inside({hole}, local.head<2>()); });
      if (!in_hole) return TooNear{p, distance, needed};
    }
  return std::nullopt;
}

}  // namespace planish::connect_detail
