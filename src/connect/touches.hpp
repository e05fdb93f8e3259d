#pragma once

#include "plate_plane.hpp"

#include <array>
#include <vector>

namespace planish::connect_detail {

/// An edge of a placed plate in space.
struct Line {
  Vec3 from, to;
  double length() const { return (to - from).norm(); }
  Vec3 along() const { return (to - from).normalized(); }
  double off(const Vec3& p) const { return (p - from).cross(along()).norm(); }
};
Line edge_of(const PlacedPlate& plate, const EdgePlace& edge);

/// Edges and corners nearer than this are meant to be one, mm: drawings are rounded.
inline constexpr double kMeantAsOne = 0.05;

/// A stretch of edges of two plates that lie along each other, or a corner of both outlines.
struct Touch {
  std::array<int, 2> plates{};
  std::array<EdgePlace, 2> edges{};               ///< by plate
  std::array<std::array<double, 2>, 2> ranges{};  ///< by plate, from the start of its edge
  bool corner = false;
  bool folded = false;  ///< there the plates are joined by a fold of inside radius 0

  double length() const { return ranges[0][1] - ranges[0][0]; }
};

/// Where plates in planes that cross touch: the edges, pair by pair, then the corners. Of the edges
/// those are folded that a bend of inside radius 0 in `structure` joins; without bends, and with
/// that default, those of a tree of the longest ones.
std::vector<Touch> touches_of(const PlateStructure& structure,
                              const std::vector<PlacedPlate>& plates);

}  // namespace planish::connect_detail
