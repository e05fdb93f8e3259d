#pragma once

#include "triangle.hpp"
#include "triangle_tree.hpp"

#include <vector>

namespace planish::collision_detail {

struct Ball {
  Vec3 centre = Vec3::Zero();
  double radius = 0.0;
};

/// How often a closed surface encloses a point, and how near it is.
class Enclosure {
 public:
  explicit Enclosure(const Mesh& surface);

  /// How often the surface encloses p: the least of three counts, along each axis, of the triangles
  /// through which a ray leaves less those through which it enters. So a gap that one ray meets
  /// makes nothing enclosed twice. A ray that meets an edge of a triangle does not count; 0 if
  /// none does.
  int times_enclosed(const Vec3& p) const;

  /// The largest ball about p that the surface does not enter, with a radius of at most `most`.
  Ball clear_ball(const Vec3& p, double most) const;

  /// Climbs from p to a ball that is stuck between triangles on all sides. Everything within it is
  /// enclosed as often as p: no step leaves the ball before. In a convex region it is the largest
  /// one. Requires p within the surface.
  Ball widest_ball(const Vec3& p) const;

 private:
  Ball nearest_ball(const Vec3& p) const;
  /// Where to move a ball so that it gets away from all that is within `touching` of its radius;
  /// about zero where it is surrounded.
  Vec3 away_from_nearest(const Ball& ball, double touching) const;
  std::vector<Vec3> nearest_points(const Vec3& p, double radius) const;

  std::vector<Triangle> triangles_;
  TriangleTree tree_;
  Box3 box_;
};

}  // namespace planish::collision_detail
