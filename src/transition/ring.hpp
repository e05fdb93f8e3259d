#pragma once

#include "strip.hpp"

#include <planish/transition/transition.hpp>

#include <memory>
#include <vector>

namespace planish::transition_detail {

/// The strips of a hull in order, closed to a ring.
struct Ring {
  std::shared_ptr<const Hull> hull;
  std::vector<Strip> strips;
  double size = 0.0;  ///< extent of both profiles, mm

  int count() const { return static_cast<int>(strips.size()); }
  const Strip& strip(int i) const { return strips[((i % count()) + count()) % count()]; }
};

/// The neutral surface of a transition. Requires: numbers that `check_request` found sound. Errors:
/// those of `boundary_of` and `lateral_hull`; `radius_too_small` where the neutral surface is
/// curved more sharply than the thickness allows.
Result<Ring> ring_of(const TransitionSpec& spec, const TransitionOptions& options);

}  // namespace planish::transition_detail
