#pragma once

#include <planish/base/result.hpp>
#include <planish/connect/plates.hpp>
#include <planish/geometry/curve.hpp>
#include <planish/geometry/frame.hpp>

#include <string>
#include <vector>

namespace planish::connect_detail {

/// Where an edge of a plate is: in the outline (ring 0) or in a hole (ring 1 …), from that corner
/// to the next.
struct EdgePlace {
  int ring = 0, corner = 0;
};

/// A plate in the axes of its own plane: the outline runs counter-clockwise about the frame's z,
/// corner by corner as in the plate; holes run clockwise. Edges are numbered in the plate's order:
/// those of the outline, then those of each hole.
struct PlacedPlate {
  Frame frame;
  std::vector<Vec2> outline;
  std::vector<std::vector<Vec2>> holes;
  std::vector<bool> turned;  ///< by hole: it runs against the plate's order
  std::vector<Loop> shapes;  ///< by hole: its curves, if it is no polygon; then it has no edges
  std::vector<std::vector<int>> numbers;  ///< of the edges of a trimmed plate, by ring
  std::vector<int> cut_corners = {};      ///< numbers of those where only a corner was cut off
  double extent = 0.0;                    ///< diagonal of its bounding box, mm
  double area = 0.0;

  Vec3 corner(int i) const { return frame.point(outline[i]); }
  /// The corner at which an edge begins, or one so many further on around its ring.
  Vec3 corner(const EdgePlace& edge, int further = 0) const;
  Eigen::AlignedBox3d box() const;  ///< of the outline, in space
  bool is_polygon(int ring) const { return ring == 0 || shapes[ring - 1].empty(); }
  /// Edges of a ring that can carry a bend.
  int edges_of(int ring) const;
  int edge_count() const { return static_cast<int>(outline.size()); }  ///< of the outline

  int ring_count() const { return 1 + static_cast<int>(holes.size()); }
  const std::vector<Vec2>& ring(int r) const { return r == 0 ? outline : holes[r - 1]; }
  int all_edges() const;  ///< of the outline and the holes
  int edge_number(const EdgePlace& place) const;
  EdgePlace place_of(int edge) const;  ///< edge < all_edges()
};

/// Lays a plate into its plane. `pointer` is the plate's place in the file, "/plates/2". Errors:
/// `invalid_input`, `too_few_corners`, `repeated_corner`, `not_planar`, `self_crossing`.
Result<PlacedPlate> placed(const Plate& plate, const std::string& pointer, double planarity);

}  // namespace planish::connect_detail
