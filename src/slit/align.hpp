#pragma once

#include <planish/slit/folded_slit_sheet.hpp>

#include <Eigen/Geometry>

#include <vector>

namespace planish::slit_detail {

/// The points measured on a strip, and its present shape.
struct ScannedStrip {
  const std::vector<Vec3>& points;
  FoldedStrip strip;
};

/// The rigid motion that brings all points nearest to their strips (ICP): distances across the
/// strips have full weight, those along them little, so that points slide into place. About 4000
/// points of each strip are used.
Eigen::Isometry3d aligning_motion(const std::vector<ScannedStrip>& scans);

}  // namespace planish::slit_detail
