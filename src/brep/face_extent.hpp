#pragma once

#include <planish/geometry/frame.hpp>

#include <TopoDS_Face.hxx>

#include <optional>
#include <vector>

namespace planish::brep {

/// An arc: centre + x cos t + y sin t for t from `from` to `to`. A point where x and y are zero.
struct Reach {
  Vec3 centre;
  Vec3 x = Vec3::Zero(), y = Vec3::Zero();
  double from = 0.0, to = 0.0;
};

struct Extent {
  double low = 0.0, high = 0.0;
};

/// Where a face is, without its triangles.
struct FaceExtent {
  struct Plane {
    Vec3 point, normal;  ///< unit, outward
  };
  struct Axis {
    Vec3 point, direction;  ///< unit
    double radius = 0.0;
  };
  Eigen::AlignedBox3d box;
  std::vector<Reach> hull;       ///< the face lies within the convex hull of these
  std::vector<Vec3> directions;  ///< unit; along these the face is likely to end beside another
  std::optional<Plane> plane;    ///< of a plane face
  std::optional<Axis> cylinder;  ///< of a cylindrical face

  /// Of the hull along a direction (unit), measured from a point.
  Extent along(const Vec3& direction, const Vec3& from) const;
};

FaceExtent extent_of(const TopoDS_Face& face);

/// Whether two faces may run through each other by `depth`, or lie on each other and look the same
/// way. Faces that only meet along an edge mostly cannot: a plane lies between them, or one of them
/// stays on one side of the other's plane.
bool may_cross(const FaceExtent& a, const FaceExtent& b, double depth);

}  // namespace planish::brep
