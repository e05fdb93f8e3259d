// The material that a fold stands for, as squares of lengths and areas: polynomials of the ends of
// ridges on their edges, whatever curves these are, so that derivatives are exact and cheap. At a
// clamped end a ridge has half of one quad; where the last quad is held in its direction it belongs
// to the last ridge whole, as there is no other to bend the rest.
#include "bent_fold.hpp"

#include <planish/geometry/plane.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace planish::slit_detail {
namespace {

constexpr int kOwnLeft = 2, kOwnRight = 3;  // among the six places

bool is_held_in_direction(const StripProblem& problem) {
  if (problem.far_facet) return false;
  return std::ranges::any_of(problem.ends, [](const EndCondition& end) {
    return end.of == EndCondition::Of::along || end.of == EndCondition::Of::normal;
  });
}

/// How much each place counts in `along`.
double share_of_along(int place) {
  return place == kOwnLeft ? -1.0 : place == kOwnRight ? 1.0 : 0.0;
}

}  // namespace

Vec2 BentFold::along() const { return places[kOwnRight].at - places[kOwnLeft].at; }

double BentFold::share_of(int place) const {
  return place < 2 ? -before : place < 4 ? before - after : after;
}

/// From the middle of the quad before to that of the quad behind, on an edge.
Vec2 BentFold::way(int side) const {
  return share_of(side) * places[side].at + share_of(2 + side) * places[2 + side].at +
         share_of(4 + side) * places[4 + side].at;
}

double BentFold::swept(int side) const { return planish::cross(way(side), along()); }

double BentFold::radius(double angle) const {
  const double tangent = std::tan(0.5 * std::abs(angle));
  return tangent > 0.0 ? 0.5 * std::min(bent(0), bent(1)) / tangent
                       : std::numeric_limits<double>::infinity();
}

OfPlaces BentFold::square_of_length() const {
  const Vec2 along = this->along();
  OfPlaces square{along.squaredNorm()};
  for (const int i : {kOwnLeft, kOwnRight}) {
    const EdgePlace& a = places[i];
    square.gradient[1 + i] = 2.0 * share_of_along(i) * a.first.dot(along);
    for (const int j : {kOwnLeft, kOwnRight})
      square.hessian(1 + i, 1 + j) = 2.0 * share_of_along(i) * share_of_along(j) *
                                     a.first.dot(places[j].first);
    square.hessian(1 + i, 1 + i) += 2.0 * share_of_along(i) * a.second.dot(along);
  }
  return square;
}

OfPlaces BentFold::swept_by(int side) const {
  using planish::cross;
  const Vec2 way = this->way(side), along = this->along();
  OfPlaces swept{cross(way, along)};
  const auto share_of_way = [&](int place) { return place % 2 == side ? share_of(place) : 0.0; };
  for (int i = 0; i < 6; ++i) {
    const EdgePlace& a = places[i];
    const double in_way = share_of_way(i), in_along = share_of_along(i);
    if (in_way == 0.0 && in_along == 0.0) continue;
    swept.gradient[1 + i] = in_way * cross(a.first, along) + in_along * cross(way, a.first);
    swept.hessian(1 + i, 1 + i) += in_way * cross(a.second, along) +
                                   in_along * cross(way, a.second);
    for (const int j : {kOwnLeft, kOwnRight}) {
      const double both = in_way * share_of_along(j) * cross(a.first, places[j].first);
      swept.hessian(1 + i, 1 + j) += both;
      swept.hessian(1 + j, 1 + i) += both;
    }
  }
  return swept;
}

BentFold fold_at(const StripProblem& problem, const StripParameters& p, int ridge) {
  const StripBase& base = problem.base;
  BentFold fold{ridge, {}};
  for (int near = 0; near < 3; ++near)
    for (int side = 0; side < 2; ++side) {
      const int at = std::clamp(ridge - 1 + near, 0, base.quads);
      fold.places[2 * near + side] = place_of(base, p, at, side);
    }
  if (ridge == 0) fold.before = 0.0;
  if (ridge == base.quads) fold.after = 0.0;
  if (ridge + 1 == base.quads && is_held_in_direction(problem)) fold.after = 1.0;
  return fold;
}

std::array<int, kOfFold> numbers_of_fold(const StripBase& base, int ridge) {
  std::array<int, kOfFold> numbers{};
  numbers[0] = ridge < base.quads ? ridge : -1;
  for (int near = 0; near < 3; ++near)
    for (int side = 0; side < 2; ++side) {
      const int at = ridge - 1 + near;
      numbers[1 + 2 * near + side] = at > 0 && at < base.quads
                                         ? abscissa_index(base.quads, at, side)
                                         : -1;
    }
  return numbers;
}

}  // namespace planish::slit_detail
