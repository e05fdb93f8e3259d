#include "support/trihedron.hpp"

namespace planish::test {
namespace {

Eigen::Isometry3d isometry_of(const Frame& frame) {
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.linear().col(0) = frame.x;
  motion.linear().col(1) = frame.y;
  motion.linear().col(2) = frame.z;
  motion.translation() = frame.origin;
  return motion;
}

}  // namespace

Frame border_trihedron(const Sheet& sheet, const BorderRef& ref) {
  const Face& face = sheet[ref.face];
  const Curve2& curve = sheet[ref].curve;
  const Vec3 start = skin_point(face, start_of(curve));
  return frame_from_axes(start, outward_normal(face, start_of(curve)),
                         skin_point(face, end_of(curve)) - start);
}

Eigen::Isometry3d unfolding_by_steps(const Frame& parent, const Frame& child, Angle turn,
                                     double allowance) {
  // The child's border runs against the parent's: its end lies where the parent's starts.
  const Vec3 along = parent.x;
  const Vec3 edge_offset = parent.origin - child.origin;
  const Vec3 to_parent = edge_offset - along * along.dot(edge_offset);
  const Eigen::Translation3d tr(to_parent);
  const Eigen::Translation3d to_axis(parent.origin);
  const Eigen::Translation3d from_axis(-parent.origin);
  const Eigen::AngleAxisd turn_back(turn.radians(), along);
  const Eigen::Translation3d tc(-allowance * parent.y);
  return Eigen::Isometry3d(tc * (to_axis * turn_back * from_axis) * tr);
}

Eigen::Isometry3d unfolding_by_trihedra(const Frame& parent, const Frame& child,
                                        double border_length, double allowance) {
  Frame image;
  image.origin = parent.origin + border_length * parent.x - allowance * parent.y;
  image.x = -parent.x;
  image.y = -parent.y;
  image.z = parent.z;
  return isometry_of(image) * isometry_of(child).inverse();
}

}  // namespace planish::test
