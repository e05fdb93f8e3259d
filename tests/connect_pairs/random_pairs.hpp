#pragma once

#include <planish/connect/plates.hpp>

#include <cstdint>
#include <string>

namespace planish::pairs {

/// Two plates in space, "A" and "B", with a thickness and nothing given of the bend.
struct RandomPair {
  std::string how;  ///< in which way they lie to each other
  PlateStructure structure;
};

/// Pair number `index` of the series `seed`. Plates are rectangles, trapezoids, convex and concave
/// polygons and notched rectangles, 0.5 to 6 mm thick. They lie
/// - "beside a line": at an angle, each with a gap to the line of their planes, turned and shifted;
/// - "anywhere": turned in any way, near each other;
/// - "over each other": in parallel planes;
/// - "at an edge", "at a corner": with an edge or a corner in common.
RandomPair random_pair(std::uint64_t seed, int index);

}  // namespace planish::pairs
