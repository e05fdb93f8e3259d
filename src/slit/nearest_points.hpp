#pragma once

#include <planish/geometry/frame.hpp>

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace planish::slit_detail {

/// A k-d tree over a cloud of at least one point.
class NearestPoints {
 public:
  explicit NearestPoints(std::vector<Vec3> points);
  ~NearestPoints();
  NearestPoints(const NearestPoints&) = delete;
  NearestPoints& operator=(const NearestPoints&) = delete;

  /// O(log n) for points near the cloud.
  const Vec3& nearest(const Vec3& p) const;
  const std::vector<Vec3>& points() const;

 private:
  struct Tree;
  std::unique_ptr<const Tree> tree_;
};

/// Points measured on a strip (at least one), as the surface on which they lie.
class ScannedSurface {
 public:
  explicit ScannedSurface(std::vector<Vec3> points);
  ~ScannedSurface();
  ScannedSurface(const ScannedSurface&) = delete;
  ScannedSurface& operator=(const ScannedSurface&) = delete;

  /// The nearest point of the scanned surface: on a disc through the points about p, twice as large
  /// as their spread, in the plane that fits them best; for traced edges, on a line. So a point
  /// slides along the surface, and noise and spacing of the points average out. Includes its
  /// derivative with respect to p for a fixed disc.
  struct Foot {
    Vec3 point = Vec3::Zero();
    Eigen::Matrix3d derivative = Eigen::Matrix3d::Zero();
  };
  Foot nearest(const Vec3& p) const;
  const std::vector<Vec3>& points() const { return points_; }

 private:
  struct Tree;
  std::vector<Vec3> points_;
  std::unique_ptr<const Tree> tree_;  ///< of a sample of them
};

}  // namespace planish::slit_detail
