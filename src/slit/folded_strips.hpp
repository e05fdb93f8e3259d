#pragma once

#include "strip_system.hpp"

#include <Eigen/Geometry>

#include <vector>

namespace planish::slit_detail {

/// The strips of a system as folded, once for their many pairs.
struct FoldedStrips {
  std::vector<FoldedStrip> strips;
  std::vector<Eigen::AlignedBox3d> boxes;

  /// Whether two of them go through each other (crossing.hpp).
  bool cross(int left, int right, double within = 0.0) const;
};
FoldedStrips folded_strips(const StripSystem& system, const Shapes& shapes);

}  // namespace planish::slit_detail
