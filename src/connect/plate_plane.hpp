#pragma once

#include <planish/base/result.hpp>
#include <planish/connect/plates.hpp>
#include <planish/geometry/frame.hpp>

#include <string>
#include <vector>

namespace planish::connect_detail {

/// A plate in the axes of its own plane: the outline runs counter-clockwise about the frame's z,
/// corner by corner as in the plate; holes run clockwise.
struct PlacedPlate {
  Frame frame;
  std::vector<Vec2> outline;
  std::vector<std::vector<Vec2>> holes;
  double extent = 0.0;  ///< diagonal of its bounding box, mm
  double area = 0.0;

  Vec3 corner(int i) const { return frame.point(outline[i]); }
  int edge_count() const { return static_cast<int>(outline.size()); }
};

/// Lays a plate into its plane. `pointer` is the plate's place in the file, "/plates/2". Errors:
/// `invalid_input`, `too_few_corners`, `repeated_corner`, `not_planar`, `self_crossing`.
Result<PlacedPlate> placed(const Plate& plate, const std::string& pointer, double planarity);

}  // namespace planish::connect_detail
