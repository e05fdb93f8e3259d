#include "nearest_points.hpp"

#include <planish/base/assert.hpp>

#include <Eigen/Eigenvalues>
#include <nanoflann.hpp>

#include <algorithm>
#include <cstddef>

// The nearest point of a scan (a k-d tree), as a point of the surface that was measured: the points
// about it on a disc give a plane of best fit, whose normal is the direction of least spread; where
// they spread along a line only, that is a traced edge. So noise and spacing average out, and a
// point slides along the surface. The disc stays fixed for the derivative.

namespace planish::slit_detail {

/// The cloud as nanoflann reads it.
struct Cloud {
  std::vector<Vec3> points;
  std::size_t kdtree_get_point_count() const { return points.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t axis) const {
    return points[i][static_cast<Eigen::Index>(axis)];
  }
  template <typename Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

struct Indexed {
  Cloud cloud;
  nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud>, Cloud, 3,
                                      std::size_t>
      index;
  explicit Indexed(std::vector<Vec3> points) : cloud{std::move(points)}, index(3, cloud) {}
};

namespace {

/// At most `most` points, picked evenly.
std::vector<Vec3> thinned(const std::vector<Vec3>& points, std::size_t most) {
  const std::size_t stride = (points.size() + most - 1) / most;
  std::vector<Vec3> some;
  for (std::size_t i = 0; i < points.size(); i += stride)
    some.push_back(points[i]);
  return some;
}

/// Points used for a disc: a part of the strip that stays small however many points there are.
constexpr std::size_t kMostSurfacePoints = 16000, kPatches = 400, kFewest = 12;

}  // namespace

struct NearestPoints::Tree : Indexed {
  using Indexed::Indexed;
};

struct ScannedSurface::Tree : Indexed {
  using Indexed::Indexed;
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

ScannedSurface::ScannedSurface(std::vector<Vec3> points) : points_(std::move(points)) {
  PLANISH_ASSERT(!points_.empty());
  tree_ = std::make_unique<const Tree>(thinned(points_, kMostSurfacePoints));
}

ScannedSurface::~ScannedSurface() = default;

ScannedSurface::Foot ScannedSurface::nearest(const Vec3& p) const {
  const auto& points = tree_->cloud.points;
  const std::size_t count = std::min(points.size(), std::max(kFewest, points.size() / kPatches));
  std::vector<std::size_t> found(count);
  std::vector<double> distances(count);
  tree_->index.knnSearch(p.data(), count, found.data(), distances.data());
  Vec3 middle = Vec3::Zero();
  for (const std::size_t i : found)
    middle += points[i] / static_cast<double>(count);
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  double radius = 0.0;
  for (const std::size_t i : found) {
    const Vec3 arm = points[i] - middle;
    spread += arm * arm.transpose();
    radius = std::max(radius, 2.0 * arm.norm());
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes;
  axes.computeDirect(spread);
  // Directions in which the points hardly spread are perpendicular to the scanned surface, or to
  // traced edges.
  constexpr double kHardly = 0.05;
  Eigen::Matrix3d onto = Eigen::Matrix3d::Zero();
  for (int axis = 1; axis < 3; ++axis)
    if (axes.eigenvalues()[axis] > kHardly * axes.eigenvalues()[2])
      onto += axes.eigenvectors().col(axis) * axes.eigenvectors().col(axis).transpose();
  const Vec3 aside = onto * (p - middle);
  const double distance = aside.norm();
  if (distance <= radius) return {middle + aside, onto};
  const Vec3 way = aside / distance;
  return {middle + radius * way, radius / distance * (onto - way * way.transpose())};
}

}  // namespace planish::slit_detail
