#include <planish/base/assert.hpp>
#include <planish/geometry/frame.hpp>

namespace planish {

Frame frame_from_normal(const Vec3& origin, const Vec3& z) {
  // The axis least aligned with z gives the best conditioned product.
  int least = 0;
  z.cwiseAbs().minCoeff(&least);
  return frame_from_axes(origin, z, Vec3::Unit(least));
}

Frame frame_from_axes(const Vec3& origin, const Vec3& z, const Vec3& x_hint) {
  Frame frame;
  frame.origin = origin;
  frame.z = z.stableNormalized();
  const Vec3 hint = x_hint.stableNormalized();
  Vec3 x = hint - hint.dot(frame.z) * frame.z;
  PLANISH_ASSERT(x.norm() > 0.0);
  x.normalize();
  // Repeated: the first projection of a hint nearly parallel to z leaves a remnant of z.
  frame.x = (x - x.dot(frame.z) * frame.z).normalized();
  frame.y = frame.z.cross(frame.x);
  return frame;
}

}  // namespace planish
