#pragma once

#include "nearest_points.hpp"

#include <vector>

namespace planish::slit_detail {

/// The rigid motion that brings points nearest to a cloud: iterated closest points, each round the best motion for
/// the pairs found (Umeyama). Of more than 20 000 points an even sample is used. Finds the motion from a rough
/// position; from far off it may find a wrong one.
Eigen::Isometry3d aligning_motion(const std::vector<Vec3>& points, const NearestPoints& cloud);

}  // namespace planish::slit_detail
