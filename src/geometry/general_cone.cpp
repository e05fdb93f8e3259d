#include "ruled.hpp"

#include <planish/base/assert.hpp>
#include <planish/geometry/general_cone.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace planish {
namespace {

class ConePlacer {
 public:
  ConePlacer(const Vec3& apex, const SpaceCurve& curve, double t0, double t1, double tolerance)
      : apex_(apex), curve_(curve), tolerance_(tolerance) {
    constexpr int samples = 16;
    for (int i = 0; i <= samples; ++i)
      size_ = std::max(size_, (curve(std::lerp(t0, t1, i / double(samples))).point - apex).norm());
  }

  Ruled::Knot knot(double t) const {
    const SpaceCurvePoint c = curve_(t);
    const Vec3 arm = c.point - apex_;
    const Vec3 g = arm.normalized();
    const Vec3 turning = c.derivative - g * g.dot(c.derivative);
    constexpr double along = 64 * std::numeric_limits<double>::epsilon();
    PLANISH_ASSERT(turning.norm() > along * c.derivative.norm());
    return {t, c.point, c.derivative, g, turning / arm.norm()};
  }

  /// Appends the knots after k0 up to k1, whatever lies between halved until it is near enough.
  void append(std::vector<Ruled::Knot>& knots, const Ruled::Knot& k0, const Ruled::Knot& k1,
              int halvings) const {
    if (halvings == 0 || near_enough(k0, k1)) {
      knots.push_back(k1);
      return;
    }
    const Ruled::Knot middle = knot(std::midpoint(k0.u, k1.u));
    append(knots, k0, middle, halvings - 1);
    append(knots, middle, k1, halvings - 1);
  }

 private:
  /// Where the error of a Hermite piece and that of its slope are largest, and a place between.
  static constexpr std::array<double, 5> checked{0.2, 0.35, 0.5, 0.65, 0.8};

  bool near_enough(const Ruled::Knot& k0, const Ruled::Knot& k1) const {
    const Ruled piece{{k0, k1}};
    const double largest_tilt = std::pow(tolerance_ / size_, 0.75);
    return std::ranges::all_of(checked, [&](double share) {
      const Ruled::Knot meant = knot(std::lerp(k0.u, k1.u, share));
      const RulingFrame found = frame_at(piece, meant.u);
      const double reach = (meant.b - apex_).norm();
      const Vec3 normal = meant.b_prime.cross(meant.g).normalized();
      return (found.b - meant.b).norm() <= tolerance_ &&
             (found.b - reach * found.g - apex_).norm() <= tolerance_ &&
             (found.n - normal).norm() <= largest_tilt;
    });
  }

  const Vec3 apex_;
  const SpaceCurve& curve_;
  const double tolerance_;
  double size_ = 0.0;
};

}  // namespace

Ruled cone_over(const Vec3& apex, const SpaceCurve& curve, double t0, double t1, double tolerance) {
  PLANISH_ASSERT(t0 < t1 && tolerance > 0.0);
  const ConePlacer placer(apex, curve, t0, t1, tolerance);
  constexpr int halvings = 12;
  Ruled ruled{{placer.knot(t0)}};
  placer.append(ruled.knots, placer.knot(t0), placer.knot(t1), halvings);
  return ruled;
}

SpaceCurve conic_arc(const Vec3& p0, const Vec3& tangent_point, const Vec3& p1) {
  const Vec3 middle = 0.5 * (p0 + p1), half_chord = 0.5 * (p1 - p0), rise = tangent_point - middle;
  const Vec3 in = tangent_point - p0, out = p1 - tangent_point;
  // The unit circle from −α to α has its ends at (± sin α, cos α) and its tangents meet in
  // (0, 1/cos α): half its chord is sin α, the rise above the chord sin² α / cos α.
  const double alpha = 0.5 * std::atan2(in.cross(out).norm(), in.dot(out));
  const double sine = std::sin(alpha), cosine = std::cos(alpha);
  PLANISH_ASSERT(sine > 0.0 && cosine > 0.0);
  const Vec3 along = half_chord / sine, up = cosine / (sine * sine) * rise;
  return [=](double t) -> SpaceCurvePoint {
    const double theta = alpha * (2.0 * t - 1.0), rate = 2.0 * alpha;
    // cos θ − cos α, without loss where the arc is flat
    const double height = 2.0 * std::sin(0.5 * (alpha + theta)) * std::sin(0.5 * (alpha - theta));
    return {middle + std::sin(theta) * along + height * up,
            rate * (std::cos(theta) * along - std::sin(theta) * up),
            -rate * rate * (std::sin(theta) * along + std::cos(theta) * up)};
  };
}

}  // namespace planish
