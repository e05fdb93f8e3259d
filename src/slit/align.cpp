#include "align.hpp"

#include "nearest_points.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>

// Scanned points onto strips by iterated closest points. Each round finds the feet of all points on
// their strips and takes the rigid step of least squares; distances across a strip have full weight
// and those along it little, so that points slide along the surface into place. The turn is scaled
// by the points' extent, so that both kinds of unknown weigh alike.

namespace planish::slit_detail {
namespace {

constexpr std::size_t kMostUsed = 4000;  // points of a strip
constexpr int kRounds = 200;
constexpr double kStill = 1e-8;  // a step smaller than this share of the scans' size is the last
constexpr double kAlong = 0.01;  // weight of distances along the strip

/// Points of a strip's surface, close together, and the normal of the quad that each lies on.
class Surface {
 public:
  explicit Surface(const FoldedStrip& strip) {
    constexpr int kPlacesAlong = 8, kAcross = 16;
    std::vector<Vec3> points;
    for (std::size_t quad = 0; quad < strip.quads.size(); ++quad)
      for (int i = 0; i < kPlacesAlong; ++i)
        for (int j = 0; j <= kAcross; ++j) {
          const double s = (i + 0.5) / kPlacesAlong, r = static_cast<double>(j) / kAcross;
          const auto on = [&](const SlitRidge& ridge) -> Vec3 {
            return (1.0 - r) * ridge.folded[0] + r * ridge.folded[1];
          };
          points.push_back((1.0 - s) * on(strip.ridges[quad]) + s * on(strip.ridges[quad + 1]));
          normals_.push_back(strip.quads[quad].z);
        }
    tree_ = std::make_unique<NearestPoints>(std::move(points));
  }

  struct Foot {
    const Vec3& point;
    const Vec3& normal;
  };
  Foot nearest(const Vec3& p) const {
    const Vec3& point = tree_->nearest(p);
    return {point, normals_[&point - tree_->points().data()]};
  }

 private:
  std::vector<Vec3> normals_;
  std::unique_ptr<NearestPoints> tree_;
};

/// Normal equations for a small turn (times a length, in which arms are counted) and a shift.
struct Step {
  Eigen::Matrix<double, 6, 6> square = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 1> right = Eigen::Matrix<double, 6, 1>::Zero();

  void add(const Vec3& arm, const Vec3& direction, double missed, double weight) {
    Eigen::Matrix<double, 6, 1> row;
    row << arm.cross(direction), direction;
    square += weight * row * row.transpose();
    right += weight * missed * row;
  }
};

/// The middle of all points, and how far they reach from it.
struct Extent {
  Vec3 middle = Vec3::Zero();
  double size = 0.0;
};
Extent extent_of(const std::vector<ScannedStrip>& scans) {
  Extent extent;
  std::size_t count = 0;
  for (const ScannedStrip& scan : scans) {
    for (const Vec3& p : scan.points)
      extent.middle += p;
    count += scan.points.size();
  }
  extent.middle /= static_cast<double>(count);
  for (const ScannedStrip& scan : scans)
    for (const Vec3& p : scan.points)
      extent.size = std::max(extent.size, (p - extent.middle).norm());
  if (extent.size == 0.0) extent.size = 1.0;
  return extent;
}

/// The step that brings the points, moved so far, nearest to their feet.
Step step_from(const Eigen::Isometry3d& motion, const std::vector<ScannedStrip>& scans,
               const std::vector<Surface>& surfaces, const Extent& extent) {
  Step step;
  const Vec3 centre = motion * extent.middle;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const auto& points = scans[i].points;
    const std::size_t stride = (points.size() + kMostUsed - 1) / kMostUsed;
    for (std::size_t k = 0; k < points.size(); k += stride) {
      const Vec3 p = motion * points[k];
      const auto [foot, normal] = surfaces[i].nearest(p);
      const Vec3 arm = (p - centre) / extent.size;
      step.add(arm, normal, normal.dot(foot - p), 1.0);
      for (int axis = 0; axis < 3; ++axis)
        step.add(arm, Vec3::Unit(axis), (foot - p)[axis], kAlong);
    }
  }
  return step;
}

}  // namespace

Eigen::Isometry3d aligning_motion(const std::vector<ScannedStrip>& scans) {
  const auto surfaces = mapped(scans,
                               [&](const ScannedStrip& scan) { return Surface(scan.strip); });
  const Extent extent = extent_of(scans);
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  for (int round = 0; round < kRounds; ++round) {
    const Vec3 centre = motion * extent.middle;
    const Step step = step_from(motion, scans, surfaces, extent);
    const Eigen::Matrix<double, 6, 1> by = step.square.ldlt().solve(step.right);
    if (!by.allFinite()) break;
    const Vec3 turn = by.head<3>() / extent.size;
    const double angle = turn.norm();
    const Eigen::AngleAxisd rotation(angle, angle > 0.0 ? Vec3(turn / angle) : Vec3(Vec3::UnitX()));
    motion = Eigen::Translation3d(centre + by.tail<3>()) * rotation *
             Eigen::Translation3d(-centre) * motion;
    if (by.cwiseAbs().maxCoeff() <= kStill * extent.size) break;
  }
  return motion;
}

}  // namespace planish::slit_detail
