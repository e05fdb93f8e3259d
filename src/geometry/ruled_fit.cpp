// Knots for a general developable: an interval is halved until the Hermite span between its ends is
// within the tolerance, in points and in slopes, where their errors are largest.

#include "ruled.hpp"

#include <planish/base/assert.hpp>
#include <planish/geometry/ruled_fit.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

// Knots of a ruled surface through given rulings (math.md#general-developable). An interval is
// halved until a Hermite span through its ends is near enough: points at the directrix and at the
// end of the reach, and normals, compared where the error of a span and that of its slope are
// largest. Breaks, where rulings are less smooth, are knots.

namespace planish {
namespace {

using namespace geometry_detail;

class KnotPlacer {
 public:
  KnotPlacer(const std::function<Ruling(double)>& ruling, double u0, double u1, double tolerance)
      : ruling_(ruling), tolerance_(tolerance) {
    constexpr int kSamples = 16;
    double size = 0.0;
    for (int i = 0; i <= kSamples; ++i)
      size = std::max(size, std::abs(ruling(std::lerp(u0, u1, i / double(kSamples))).reach));
    largest_tilt_ = std::pow(tolerance / size, 0.75);
  }

  Ruled::Knot knot(double u) const {
    const Ruled::Knot k = ruling_(u).knot;
    constexpr double kAlong = 64 * std::numeric_limits<double>::epsilon();
    PLANISH_ASSERT(k.b_prime.cross(k.g).norm() > kAlong * k.b_prime.norm());
    return k;
  }

  /// Appends the knots after k0 up to k1, halving the interval until it is accurate enough.
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
  /// Where the error of a Hermite span and that of its slope are largest, and a place between.
  static constexpr std::array<double, 5> kChecked{0.5, 0.35, 0.65, 0.2, 0.8};

  bool near_enough(const Ruled::Knot& k0, const Ruled::Knot& k1) const {
    const Ruled span{{k0, k1}};
    return std::ranges::all_of(kChecked, [&](double share) {
      const auto [meant, reach] = ruling_(std::lerp(k0.u, k1.u, share));
      const RulingFrame found = frame_at(span, meant.u);
      const Vec3 normal = meant.b_prime.cross(meant.g).normalized();
      return (found.b - meant.b).norm() <= tolerance_ &&
             (found.b + reach * found.g - meant.b - reach * meant.g).norm() <= tolerance_ &&
             (found.n - normal).norm() <= largest_tilt_;
    });
  }

  const std::function<Ruling(double)>& ruling_;
  const double tolerance_;
  double largest_tilt_ = 0.0;
};

}  // namespace

Ruled ruled_through(const std::function<Ruling(double)>& ruling, const std::vector<double>& breaks,
                    double tolerance) {
  PLANISH_ASSERT(breaks.size() >= 2 && tolerance > 0.0);
  const KnotPlacer placer(ruling, breaks.front(), breaks.back(), tolerance);
  constexpr int kHalvings = 12;
  Ruled ruled{{placer.knot(breaks.front())}};
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    PLANISH_ASSERT(breaks[i] < breaks[i + 1]);
    const Ruled::Knot start = ruled.knots.back();
    placer.append(ruled.knots, start, placer.knot(breaks[i + 1]), kHalvings);
  }
  return ruled;
}

}  // namespace planish
