// An edge of a strip that is a curve (math.md#curved-slits): a chain of lines, as it is cut. Ridges
// slide along a smooth curve beside it, a parabola at each corner, as kinks would hold them; what
// is folded ends on the chain. So both strips beside a slit have the same border, and folding stays
// an isometry.
#include "edge_curve.hpp"

#include <planish/base/assert.hpp>
#include <planish/base/tolerance.hpp>
#include <planish/geometry/plane.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace planish::slit_detail {

EdgeCurve::EdgeCurve(std::vector<Vec2> chain, double from, double to)
    : across_(chain.front().y()), chain_(std::move(chain)), from_(from) {
  PLANISH_ASSERT(chain_.size() >= 2 && to > from);
  reached_ = {0.0};
  for (std::size_t i = 0; i + 1 < chain_.size(); ++i)
    reached_.push_back(reached_.back() + (chain_[i + 1] - chain_[i]).norm());
  speed_ = reached_.back() / (to - from);
}

int EdgeCurve::line_at(double length) const {
  const auto next = std::upper_bound(reached_.begin() + 1, reached_.end() - 1, length);
  return static_cast<int>(next - reached_.begin()) - 1;
}

Vec2 EdgeCurve::along(int line) const {
  return (chain_[line + 1] - chain_[line]) / length_of(line);
}

EdgePlace EdgeCurve::place(double abscissa) const {
  if (is_line()) return {{abscissa, across_}, Vec2::UnitX(), Vec2::Zero()};
  const double length = speed_ * (abscissa - from_);
  const int line = line_at(length), last = static_cast<int>(chain_.size()) - 2;
  const Vec2 forward = along(line);
  EdgePlace place{chain_[line] + (length - reached_[line]) * forward, speed_ * forward, {0.0, 0.0}};
  const bool is_before = length - reached_[line] < 0.5 * length_of(line);
  const int corner = is_before ? line : line + 1;
  if (corner == 0 || corner == last + 1) return place;
  const double rounded = 0.5 * std::min(length_of(corner - 1), length_of(corner)),
               beside = length - reached_[corner];
  if (std::abs(beside) >= rounded) return place;
  // A parabola from `rounded` before the corner to as far behind it.
  const Vec2 before = along(corner - 1), turn = (along(corner) - before) / (2.0 * rounded);
  const double done = beside + rounded;
  place.at = chain_[corner] + beside * before + 0.5 * done * done * turn;
  place.first = speed_ * (before + done * turn);
  place.second = speed_ * speed_ * turn;
  return place;
}

EdgeCurve::Crossing EdgeCurve::on_chain(const Vec2& from, const Vec2& near, double abscissa) const {
  PLANISH_ASSERT(!is_line());
  const int last = static_cast<int>(chain_.size()) - 2,
            middle = line_at(speed_ * (abscissa - from_));
  const Vec2 way = near - from;
  constexpr int kBeside = 2;  // a rounded corner touches both lines beside it
  double least = std::numeric_limits<double>::infinity();
  Crossing nearest{near, middle};
  for (int line = std::max(0, middle - kBeside); line <= std::min(last, middle + kBeside); ++line) {
    const Vec2 side = chain_[line + 1] - chain_[line];
    const double sine = planish::cross(way, side);
    if (sine == 0.0) continue;
    const double share = std::clamp(planish::cross(chain_[line] - from, way) / sine, 0.0, 1.0);
    const Vec2 at = chain_[line] + share * side;
    const double off = std::abs(planish::cross(way, at - from)) / way.norm();
    // First those that the line meets, then the nearest of them.
    const double missed = (off > tolerance::kComputed * way.norm() ? way.norm() : 0.0) +
                          (at - near).norm();
    if (missed < least) least = missed, nearest = {at, line};
  }
  return nearest;
}

}  // namespace planish::slit_detail
