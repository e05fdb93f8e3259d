// A cone over a conic arc (math.md#general-cone): the arc as the image of a circular one, so that
// the tangents of its ends meet in the given point.

#include <planish/base/assert.hpp>
#include <planish/geometry/general_cone.hpp>
#include <planish/geometry/ruled_fit.hpp>

#include <cmath>

namespace planish {
Ruled cone_over(const Vec3& apex, const SpaceCurve& curve, double t0, double t1, double tolerance) {
  PLANISH_ASSERT(t0 < t1);
  return ruled_through(
      [&](double t) -> Ruling {
        const SpaceCurvePoint c = curve(t);
        const Vec3 arm = c.point - apex;
        const Vec3 g = arm.normalized();
        return {
            {t, c.point, c.derivative, g, (c.derivative - g * g.dot(c.derivative)) / arm.norm()},
            -arm.norm()};
      },
      {t0, t1}, tolerance);
}

SpaceCurve conic_arc(const Vec3& p0, const Vec3& tangent_point, const Vec3& p1) {
  const Vec3 middle = 0.5 * (p0 + p1), half_chord = 0.5 * (p1 - p0), rise = tangent_point - middle;
  const Vec3 in = tangent_point - p0, out = p1 - tangent_point;
  // The unit circle from −α to α has its ends at (± sin α, cos α) and its tangents meet in
  // (0, 1/cos α): half its chord is sin α, the rise above the chord sin² α / cos α.
  const double alpha = 0.5 * angle_between(in, out);
  const double sine = std::sin(alpha), cosine = std::cos(alpha);
  PLANISH_ASSERT(sine > 0.0 && cosine > 0.0);
  const Vec3 along = half_chord / sine, up = cosine / (sine * sine) * rise;
  return [=](double t) -> SpaceCurvePoint {
    const double theta = alpha * (2.0 * t - 1.0), rate = 2.0 * alpha;
    // cos θ − cos α, without cancellation if the arc is flat
    const double height = 2.0 * std::sin(0.5 * (alpha + theta)) * std::sin(0.5 * (alpha - theta));
    return {middle + std::sin(theta) * along + height * up,
            rate * (std::cos(theta) * along - std::sin(theta) * up),
            -rate * rate * (std::sin(theta) * along + std::cos(theta) * up)};
  };
}

}  // namespace planish
