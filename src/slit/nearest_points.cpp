#include "nearest_points.hpp"

#include <planish/base/assert.hpp>

#include <nanoflann.hpp>

#include <cstddef>

namespace planish::slit_detail {
namespace {

/// The cloud as nanoflann reads it.
struct Cloud {
  std::vector<Vec3> points;
  std::size_t kdtree_get_point_count() const { return points.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t axis) const { return points[i][static_cast<Eigen::Index>(axis)]; }
  template <typename Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

}  // namespace

struct NearestPoints::Tree {
  Cloud cloud;
  nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud>, Cloud, 3, std::size_t> index;
  explicit Tree(std::vector<Vec3> points) : cloud{std::move(points)}, index(3, cloud) {}
};

NearestPoints::NearestPoints(std::vector<Vec3> points) {
  PLANISH_ASSERT(!points.empty());
  tree_ = std::make_unique<const Tree>(std::move(points));
}

NearestPoints::~NearestPoints() = default;

const std::vector<Vec3>& NearestPoints::points() const { return tree_->cloud.points; }

const Vec3& NearestPoints::nearest(const Vec3& p) const {
  std::size_t found = 0;
  double distance = 0.0;
  tree_->index.knnSearch(p.data(), 1, &found, &distance);
  return tree_->cloud.points[found];
}

}  // namespace planish::slit_detail
