#include "align.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>

namespace planish::slit_detail {
namespace {

constexpr std::size_t kMostUsed = 20000;

Eigen::Matrix3Xd sample_of(const std::vector<Vec3>& points) {
  const std::size_t stride = (points.size() + kMostUsed - 1) / kMostUsed;
  Eigen::Matrix3Xd sample(3, static_cast<Eigen::Index>((points.size() + stride - 1) / stride));
  for (Eigen::Index i = 0; i < sample.cols(); ++i)
    sample.col(i) = points[static_cast<std::size_t>(i) * stride];
  return sample;
}

}  // namespace

Eigen::Isometry3d aligning_motion(const std::vector<Vec3>& points, const NearestPoints& cloud) {
  const Eigen::Matrix3Xd sample = sample_of(points);
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  Eigen::Matrix3Xd moved = sample, targets = sample;
  const double extent = (sample.colwise() - sample.rowwise().mean()).colwise().norm().maxCoeff();
  constexpr int kRounds = 100;
  constexpr double kStill = 1e-10;
  for (int round = 0; round < kRounds; ++round) {
    for (Eigen::Index i = 0; i < moved.cols(); ++i)
      targets.col(i) = cloud.nearest(moved.col(i));
    motion.matrix() = Eigen::umeyama(sample, targets, false);
    const Eigen::Matrix3Xd next = (motion.linear() * sample).colwise() + motion.translation();
    const double shift = (next - moved).cwiseAbs().maxCoeff();
    moved = next;
    if (shift <= kStill * extent) break;
  }
  return motion;
}

}  // namespace planish::slit_detail
