// A patch of the hull by its rulings, numbered from 0 to 1: a ruling joins points whose tangents
// lie in one plane (math.md#lateral-hull). Between the known ends the partner of a place is the
// root of that determinant, kept in a bracket. Where neither side moves, the tangent condition is
// taken in the limit.

#include "ruled_patch.hpp"

#include "integral.hpp"

#include <planish/base/tolerance.hpp>

#include <algorithm>
#include <cmath>

namespace planish::transition_detail {
namespace {

/// Knots of an element's curve after t0 and before t1, of a closed one round after round;
/// ascending.
std::vector<double> knots_between(const Element& element, double t0, double t1) {
  std::vector<double> knots;
  for (const double t : element.knots) {
    if (element.period == 0.0) {
      if (t > t0 && t < t1) knots.push_back(t);
      continue;
    }
    for (double here = t + element.period * std::ceil((t0 - t) / element.period); here < t1;
         here += element.period)
      if (here > t0) knots.push_back(here);
  }
  std::ranges::sort(knots);
  return knots;
}

}  // namespace

double arc_length(const Element& element, double t0, double t1) {
  if (t1 < t0) return -arc_length(element, t1, t0);
  std::vector<double> breaks = knots_between(element, t0, t1);
  breaks.insert(breaks.begin(), t0);
  breaks.push_back(t1);
  return integral_over([&](double t) { return element.curve(t).derivative.norm(); }, breaks);
}

RuledPatch::RuledPatch(std::shared_ptr<const Hull> hull, const HullPatch& patch, double tolerance)
    : hull_(std::move(hull)),
      hull_patch_(patch),
      curves_{&hull_->element(0, patch.sides[0]), &hull_->element(1, patch.sides[1])},
      tolerance_(tolerance) {
  if (hull_patch_.plane) return;
  right_ = right_surface(*hull_, hull_patch_);
  if (right_) {
    base_ = hull_patch_.sides[0].moves() ? 0 : 1;
    return;
  }
  // The base side is the one that nowhere, or hardly anywhere, stands still.
  std::array<double, 2> slowest{1.0, 1.0};
  constexpr int kSamples = 16;
  for (std::size_t side = 0; side < 2; ++side)
    for (int i = 0; i <= kSamples; ++i) {
      const double whole = hull_patch_.sides[side].t1 - hull_patch_.sides[side].t0;
      slowest[side] = whole == 0.0 ? 0.0
                                   : std::min(slowest[side],
                                              pairing(i / double(kSamples)).rate[side] / whole);
    }
  base_ = slowest[1] > slowest[0] ? 1 : 0;
  find_breaks();
}

PatchKind RuledPatch::kind() const {
  if (hull_patch_.plane) return PatchKind::plane;
  if (right_ ? bend_kind() == BendKind::cylinder : has_parallel_rulings())
    return PatchKind::cylinder;
  const bool apex = !hull_patch_.sides[0].moves() || !hull_patch_.sides[1].moves();
  return apex || right_ ? PatchKind::cone : PatchKind::general;
}

bool RuledPatch::has_parallel_rulings() const {
  constexpr int kSamples = 16;
  const auto direction = [&](double at) -> Vec3 {
    const auto [p, q] = ruling(at);
    return (q - p).normalized();
  };
  const Vec3 first = direction(0.0);
  for (int i = 1; i <= kSamples; ++i)
    if (first.cross(direction(i / double(kSamples))).norm() > tolerance::kComputed) return false;
  return true;
}

BendKind RuledPatch::bend_kind() const {
  if (!right_) return BendKind::general;
  return std::holds_alternative<Cylinder>(right_->surface) ? BendKind::cylinder : BendKind::cone;
}

RuledPatch::Pairing RuledPatch::pairing(double at) const {
  const bool both = hull_patch_.sides[0].moves() && hull_patch_.sides[1].moves();
  if (both && !hull_patch_.plane && !right_) return solved(at);
  Pairing pairing;
  for (std::size_t side = 0; side < 2; ++side) {
    const Stretch& stretch = hull_patch_.sides[side];
    pairing.t[side] = std::lerp(stretch.t0, stretch.t1, at);
    pairing.rate[side] = stretch.t1 - stretch.t0;
  }
  return pairing;
}

// Rulings are numbered by the mean of the shares of both curves up to them, since either may stand
// still for a moment. math.md#lateral-hull then fixes both.
RuledPatch::Pairing RuledPatch::solved(double at) const {
  const Stretch &a = hull_patch_.sides[0], &b = hull_patch_.sides[1];
  const double whole_a = a.t1 - a.t0, whole_b = b.t1 - b.t0;
  const auto share_of = [&](const std::array<double, 2>& stop) {
    return (stop[0] - a.t0) / whole_a;
  };
  const auto number_of = [&](const std::array<double, 2>& stop) {
    return 0.5 * (share_of(stop) + (stop[1] - b.t0) / whole_b);
  };
  const auto above = std::find_if(hull_patch_.stops.begin() + 1, hull_patch_.stops.end() - 1,
                                  [&](const auto& stop) { return number_of(stop) > at; });
  const auto slopes = [&](double share) {
    const SpaceCurvePoint p = point(0, a.t0 + share * whole_a),
                          q = point(1, b.t0 + (2.0 * at - share) * whole_b);
    const Vec3 arm = q.point - p.point;
    return std::array{ahead(p, q), p.second.cross(q.derivative).dot(arm) * whole_a,
                      p.derivative.cross(q.second).dot(arm) * whole_b};
  };
  const double low = share_of(*(above - 1)), high = share_of(*above);
  const double high_b = 2.0 * number_of(*above) - high, low_b = 2.0 * number_of(*(above - 1)) - low;
  const double share = falling_root(
      [&](double s) {
        const auto [value, by_a, by_b] = slopes(s);
        return std::pair{value, by_a - by_b};
      },
      std::max(low, 2.0 * at - high_b), std::min(high, 2.0 * at - low_b));
  const auto [value, by_a, by_b] = slopes(share);
  const double rate_a = by_b == by_a ? 1.0 : 2.0 * by_b / (by_b - by_a);
  return {{a.t0 + share * whole_a, b.t0 + (2.0 * at - share) * whole_b},
          {rate_a * whole_a, (2.0 - rate_a) * whole_b}};
}

std::array<Vec3, 2> RuledPatch::ruling(double at) const {
  const Pairing pair = pairing(at);
  return {point(0, pair.t[0]).point, point(1, pair.t[1]).point};
}

Vec3 RuledPatch::normal(double at) const {
  if (!hull_patch_.plane) return local(at).normal;
  const int edge = hull_patch_.sides[0].moves() ? 0 : 1;
  const auto [p, q] = ruling(at);
  return point(edge, hull_patch_.sides[edge].t0).derivative.cross(q - p).normalized();
}

double RuledPatch::ruling_at(int side, double t) const {
  const Stretch& stretch = hull_patch_.sides[side];
  const double share = (t - stretch.t0) / (stretch.t1 - stretch.t0);
  const bool both = hull_patch_.sides[0].moves() && hull_patch_.sides[1].moves();
  if (!both || hull_patch_.plane || right_) return share;
  const auto s = static_cast<std::size_t>(side);
  return root_between(
      [&](double at) {
        const Pairing pair = pairing(at);
        return std::pair{pair.t[s] - t, pair.rate[s]};
      },
      0.0, 1.0);
}

RuledPatch::Local RuledPatch::local(double at) const {
  const Pairing pair = pairing(at);
  const std::array<SpaceCurvePoint, 2> ends{point(0, pair.t[0]), point(1, pair.t[1])};
  const auto base = static_cast<std::size_t>(base_);
  const Vec3 arm = ends[1].point - ends[0].point;
  const Vec3 arm_rate = pair.rate[1] * ends[1].derivative - pair.rate[0] * ends[0].derivative;
  Local local;
  local.length = arm.norm();
  const Vec3 g = arm / local.length;
  local.length_rate = g.dot(arm_rate);
  const Vec3 g_rate = (arm_rate - local.length_rate * g) / local.length;
  const Vec3 b_rate = pair.rate[base] * ends[base].derivative;
  local.knot = {at, ends[base].point, b_rate, g, g_rate};
  local.normal = b_rate.cross(g).normalized();
  const Vec3 across = g.cross(local.normal);
  local.across = b_rate.dot(across);
  local.far_across = local.across + (base_ == 0 ? 1.0 : -1.0) * local.length * g_rate.dot(across);
  // n · b′ = 0 all along, so n′ · b′ = −n · b″, and n′ is across the ruling.
  local.turn_rate = std::abs(local.normal.dot(ends[base].second)) * pair.rate[base] *
                    pair.rate[base] / local.across;
  return local;
}

void RuledPatch::find_breaks() {
  for (std::size_t side = 0; side < 2; ++side) {
    const Stretch& stretch = hull_patch_.sides[side];
    if (!stretch.moves()) continue;
    for (const double t : knots_between(*curves_[side], stretch.t0, stretch.t1))
      breaks_.push_back(ruling_at(static_cast<int>(side), t));
  }
  std::ranges::sort(breaks_);
}

std::vector<double> RuledPatch::breaks_between(double from, double to) const {
  constexpr double kApart = tolerance::kComputed;  // in rulings
  std::vector<double> breaks{from};
  for (const double at : breaks_)
    if (at > breaks.back() + kApart && at < to - kApart) breaks.push_back(at);
  breaks.push_back(to);
  return breaks;
}

}  // namespace planish::transition_detail
