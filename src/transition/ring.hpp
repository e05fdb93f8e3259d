#pragma once

#include "ruled_patch.hpp"

#include <planish/transition/transition.hpp>

#include <memory>
#include <vector>

namespace planish::transition_detail {

/// The patches of a hull in order, closed into a ring.
struct Ring {
  std::shared_ptr<const Hull> hull;
  std::vector<RuledPatch> patches;
  double size = 0.0;  ///< extent of both profiles, mm

  int count() const { return static_cast<int>(patches.size()); }
  const RuledPatch& patch(int i) const { return patches[((i % count()) + count()) % count()]; }
};

/// The neutral surface of a transition. Requires: numbers accepted by `check_request`. Errors:
/// those of `boundary_of` and `lateral_hull`; `radius_too_small` if the neutral surface is curved
/// more sharply than the thickness allows.
Result<Ring> ring_of(const TransitionSpec& spec, const TransitionOptions& options);

}  // namespace planish::transition_detail
