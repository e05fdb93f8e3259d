#pragma once

#include <planish/geometry/frame.hpp>

#include <memory>
#include <vector>

namespace planish::slit_detail {

/// A k-d tree over a cloud of points; at least one.
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

}  // namespace planish::slit_detail
