#include "sheets_meet.hpp"

#include "bend_frame.hpp"
#include "lateral.hpp"
#include "tolerances.hpp"

#include <planish/geometry/plane.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

// Whether two sheets in planes that cross share material. A section across the intersection line
// turns each sheet into rectangles half the thickness to both sides, and two rectangles are apart
// only if they are so along a side of one of them. Sections lie at even places and just beside
// every corner, since between corners a section's ends move linearly.

namespace planish::connect_detail {
namespace {

constexpr int kSections = 64;
// Sheets that share less than this share of the thickness touch.
constexpr double kSharedShare = 1e-3;

using Rings = std::vector<std::vector<Vec2>>;

// The outline and the holes that come within `reach` of the intersection line, in (x, y).
Rings rings_near(const PlacedPlate& plate, const BendFrame& frame, int side, double reach) {
  Rings rings{side_outline(plate, frame, side)};
  for (int ring = 1; ring < plate.ring_count(); ++ring) {
    std::vector<Vec2> hole = side_ring(plate, ring, frame, side);
    const Box2 box = box_of(hole);
    if (box.lo.y() <= reach && box.hi.y() >= -reach) rings.push_back(std::move(hole));
  }
  return rings;
}

// Where the section at x has material.
std::vector<Spread> section(const Rings& rings, double x) {
  std::vector<double> ys;
  for (const std::vector<Vec2>& ring : rings)
    for (const auto& [p, q] : sides_of(ring))
      if ((p.x() <= x) != (q.x() <= x))
        ys.push_back(p.y() + (x - p.x()) / (q.x() - p.x()) * (q.y() - p.y()));
  return material_between(std::move(ys));
}

/// A rectangle across the sheet: from `low` to `high` along `e`, half the thickness to both sides.
struct Bar {
  Vec2 e, low, high;
  double half = 0.0;

  Spread along(const Vec2& axis) const {
    const double a = low.dot(axis), b = high.dot(axis);
    const double wide = half * std::abs(axis.dot(Vec2(-e.y(), e.x())));
    return {std::min(a, b) - wide, std::max(a, b) + wide};
  }
};

// Two rectangles are apart if they are so along a side of one of them.
bool overlap(const Bar& a, const Bar& b, double least) {
  for (const Bar* bar : {&a, &b})
    for (const Vec2& axis : {bar->e, Vec2(-bar->e.y(), bar->e.x())}) {
      const Spread p = a.along(axis), q = b.along(axis);
      if (std::min(p.second, q.second) - std::max(p.first, q.first) <= least) return false;
    }
  return true;
}

// Sections evenly spread over the range that both have, and beside every corner.
std::vector<double> places(const std::array<Rings, 2>& plates, double low, double high) {
  std::vector<double> xs;
  for (int i = 0; i < kSections; ++i)
    xs.push_back(low + (i + 0.5) / kSections * (high - low));
  const double beside = kNegligible * (high - low);
  for (const Rings& rings : plates)
    for (const std::vector<Vec2>& ring : rings)
      for (const Vec2& p : ring)
        for (const double x : {p.x() - beside, p.x() + beside})
          if (x > low && x < high) xs.push_back(x);
  return xs;
}

}  // namespace

std::optional<SheetsMeet> sheets_meet(const PlacedPlate& a, const PlacedPlate& b,
                                      const BendFrame& frame, double thickness) {
  if (frame.parallel()) return std::nullopt;
  const double beta = frame.beta.radians();
  const double reach = thickness / std::sin(beta);
  const std::array plates{rings_near(a, frame, 0, reach), rings_near(b, frame, 1, reach)};
  double low = -std::numeric_limits<double>::infinity(), high = -low;
  for (const Rings& rings : plates) {
    const Box2 outline = box_of(rings.front());
    low = std::max(low, outline.lo.x());
    high = std::min(high, outline.hi.x());
  }
  if (low >= high) return std::nullopt;
  const std::array<Vec2, 2> e{Vec2(1.0, 0.0), Vec2(std::cos(beta), std::sin(beta))};
  const auto shared = [&](double x) -> std::optional<double> {
    for (const Spread& p : section(plates[0], x))
      for (const Spread& q : section(plates[1], x)) {
        const Bar first{e[0], p.first * e[0], p.second * e[0], 0.5 * thickness};
        const Bar second{e[1], q.first * e[1], q.second * e[1], 0.5 * thickness};
        if (overlap(first, second, kSharedShare * thickness)) return p.first;
      }
    return std::nullopt;
  };
  for (const double x : places(plates, low, high))
    if (const auto y = shared(x)) return SheetsMeet{frame.point(0, {x, *y})};
  return std::nullopt;
}

}  // namespace planish::connect_detail
