#pragma once

#include "ring.hpp"
#include "sample_transitions.hpp"
#include "seams.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

// Rings to test single steps with. Every spec has its sizes on the neutral surface, so that a ring
// runs through the profiles as they are given.

namespace planish::test {

using transition_detail::PatchPart;
using transition_detail::Ring;
using transition_detail::RuledPatch;

inline Ring ring_between(Profile from, Profile to, const Vec3& apart) {
  auto ring = transition_detail::ring_of(between(std::move(from), std::move(to), apart), {});
  EXPECT_TRUE(ring) << (ring ? "" : ring.error().message);
  return ring ? std::move(*ring) : Ring{};
}

/// A right cone: radius 50 below, 20 above, 80 high.
inline Ring frustum() {
  return ring_between(EllipseProfile{50, 50}, EllipseProfile{20, 20}, {0, 0, 80});
}

/// Four triangles and four oblique cones with their apices in the corners of a square of 100.
inline Ring square_to_circle() {
  return ring_between(rectangle(100, 100), EllipseProfile{30, 30}, {0, 0, 80});
}

/// Four trapezia: squares of 100 and 60, 80 high.
inline Ring pyramid() { return ring_between(rectangle(100, 100), rectangle(60, 60), {0, 0, 80}); }

/// Eight triangles: a square of 100, and one turned by 45° whose corners are 40 from the axis.
inline Ring antiprism() {
  return ring_between(rectangle(100, 100), regular_polygon(4, 40), {0, 0, 80});
}

/// The first patch that is no plane; there must be one.
inline const RuledPatch& first_cone(const Ring& ring) {
  int i = 0;
  while (ring.patch(i).plane())
    ++i;
  return ring.patch(i);
}

/// The whole ring as one piece, from its first patch on.
inline std::vector<PatchPart> whole(const Ring& ring) {
  std::vector<PatchPart> parts;
  for (int i = 0; i < ring.count(); ++i)
    parts.push_back({i, 0.0, 1.0});
  return parts;
}

}  // namespace planish::test
