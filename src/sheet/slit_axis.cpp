// Slits that are curves. In a pattern they are chains of short lines, as both banks must be the
// same to the last bit; a cutter is better off with few arcs. So a curve of cubics is led through
// the corners, fitted as coarsely as a tolerance allows, and made of arcs. Banks are then arcs
// about the same centres.
#include "slit_axis.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/geometry/fit.hpp>
#include <planish/geometry/plane.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace planish::sheet_detail {
namespace {

using Chain = std::vector<Vec2>;
constexpr double kCorner = 0.15;  // radians: a larger turn is no curve drawn as lines

double turn_at(const Chain& chain, std::size_t corner) {
  const Vec2 before = chain[corner] - chain[corner - 1], behind = chain[corner + 1] - chain[corner];
  return std::atan2(cross(before, behind), before.dot(behind));
}

/// Tangents of the circle through a corner and its neighbours; at an end mirrored about the chord.
std::vector<Vec2> tangents_of(const Chain& chain) {
  const std::size_t last = chain.size() - 1;
  std::vector<Vec2> tangents(chain.size());
  const auto towards = [&](std::size_t i) { return Vec2(chain[i + 1] - chain[i]); };
  for (std::size_t i = 1; i < last; ++i) {
    const Vec2 a = towards(i - 1), b = towards(i);
    tangents[i] = (b.norm() / a.norm() * a + a.norm() / b.norm() * b).normalized();
  }
  const auto mirrored = [](const Vec2& tangent, const Vec2& chord) -> Vec2 {
    const Vec2 along = chord.normalized();
    return 2.0 * tangent.dot(along) * along - tangent;
  };
  tangents[0] = mirrored(tangents[1], towards(0));
  tangents[last] = mirrored(tangents[last - 1], towards(last - 1));
  return tangents;
}

/// A smooth curve through corners whose turns are small.
void add_smooth(Loop& to, const Chain& chain, double tolerance) {
  if (chain.size() == 2) {
    to.push_back(Segment{chain[0], chain[1]});
    return;
  }
  const std::vector<Vec2> tangents = tangents_of(chain);
  const auto at = [&](double t) -> CurveSample {
    const int i = std::clamp(static_cast<int>(t), 0, static_cast<int>(chain.size()) - 2);
    const double s = t - i, r = 1.0 - s;
    const double third = (chain[i + 1] - chain[i]).norm() / 3.0;
    const Vec2 a = chain[i], d = chain[i + 1], b = a + third * tangents[i],
               c = d - third * tangents[i + 1];
    return {r * r * r * a + 3.0 * r * r * s * b + 3.0 * r * s * s * c + s * s * s * d,
            3.0 * (r * r * (b - a) + 2.0 * r * s * (c - b) + s * s * (d - c))};
  };
  const FitReport fit = fit_cubics(at, 0.0, static_cast<double>(chain.size() - 1), 0.5 * tolerance);
  for (Curve2& curve : to_arcs(fit.spline, 0.5 * tolerance))
    to.push_back(std::move(curve));
}

Vec2 direction_at(const Curve2& curve, double t) { return derivative_at(curve, t).normalized(); }

Curve2 beside(const Curve2& curve, double aside) {
  if (const auto* arc = std::get_if<Arc>(&curve)) {
    Arc moved = *arc;
    moved.radius -= arc->sweep > 0.0 ? aside : -aside;
    return moved;
  }
  const Segment& line = std::get<Segment>(curve);
  const Vec2 by = aside * perpendicular(Vec2((line.b - line.a).normalized()));
  return Segment{line.a + by, line.b + by};
}

}  // namespace

std::vector<std::vector<Vec2>> chains_of(const std::vector<Segment>& slits, double tolerance) {
  const auto same = [&](const Vec2& a, const Vec2& b) { return (a - b).norm() <= tolerance; };
  const auto meeting = [&](const Vec2& p) {
    return std::ranges::count_if(
        slits, [&](const Segment& slit) { return same(slit.a, p) || same(slit.b, p); });
  };
  std::vector<Chain> chains;
  std::vector<bool> used(slits.size());
  for (std::size_t first = 0; first < slits.size(); ++first) {
    if (used[first]) continue;
    used[first] = true;
    Chain chain{slits[first].a, slits[first].b};
    for (int end = 0; end < 2; ++end, std::ranges::reverse(chain)) {
      for (bool goes_on = true; goes_on && meeting(chain.back()) == 2;) {
        goes_on = false;
        for (std::size_t i = 0; i < slits.size() && !goes_on; ++i) {
          if (used[i]) continue;
          const bool from_a = same(slits[i].a, chain.back());
          if (!from_a && !same(slits[i].b, chain.back())) continue;
          chain.push_back(from_a ? slits[i].b : slits[i].a);
          goes_on = used[i] = true;
        }
      }
    }
    chains.push_back(std::move(chain));
  }
  return chains;
}

Loop curves_through(const std::vector<Vec2>& chain, double tolerance) {
  Loop curves;
  Chain smooth{chain.front()};
  for (std::size_t i = 1; i < chain.size(); ++i) {
    smooth.push_back(chain[i]);
    if (i + 1 < chain.size() && std::abs(turn_at(chain, i)) <= kCorner) continue;
    add_smooth(curves, smooth, tolerance);
    smooth = {chain[i]};
  }
  return curves;
}

Loop beside(const Loop& axis, double aside) {
  Loop bank;
  for (std::size_t i = 0; i < axis.size(); ++i) {
    Curve2 next = beside(axis[i], aside);
    if (i > 0) {
      const Vec2 before = direction_at(axis[i - 1], 1.0), behind = direction_at(axis[i], 0.0);
      const double turn = std::atan2(cross(before, behind), before.dot(behind));
      constexpr double kSmooth = 1e-3;  // radians: arcs have common tangents
      auto *line = std::get_if<Segment>(&bank.back()), *other = std::get_if<Segment>(&next);
      if (std::abs(turn) > kSmooth && turn * aside > 0.0 && line != nullptr && other != nullptr) {
        const double back = aside * std::tan(0.5 * turn);
        line->b -= back * before;
        other->a += back * behind;
      } else if (std::abs(turn) > kSmooth && turn * aside < 0.0) {
        const Vec2 center = start_of(axis[i]), radius = end_of(bank.back()) - center;
        bank.push_back(Arc{center, radius.norm(), angle_of(radius), turn});
      } else if (const Vec2 from = end_of(bank.back()), to = start_of(next); from != to) {
        // What rounding leaves; lines and arcs about one centre otherwise meet.
        if ((to - from).norm() > tolerance::kComputed * std::abs(aside))
          bank.push_back(Segment{from, to});
      }
    }
    bank.push_back(std::move(next));
  }
  return bank;
}

Loop without_end(Loop curves, const Vec2& center, double radius) {
  const auto inside = [&](const Vec2& p) { return (p - center).norm() < radius; };
  while (!curves.empty() && inside(start_of(curves.back())))
    curves.pop_back();
  if (curves.empty() || !inside(end_of(curves.back()))) return curves;
  double low = 0.0, high = 1.0;
  constexpr int kBisections = 60;
  for (int i = 0; i < kBisections; ++i) {
    const double middle = 0.5 * (low + high);
    (inside(point_at(curves.back(), middle)) ? high : low) = middle;
  }
  curves.back() = trimmed(curves.back(), 0.0, low);
  return curves;
}

Loop without_start(const Loop& curves, const Vec2& center, double radius) {
  return reversed(without_end(reversed(curves), center, radius));
}

}  // namespace planish::sheet_detail
