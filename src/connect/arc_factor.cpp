#include <planish/connect/edge_search.hpp>

#include <cmath>
#include <numbers>

namespace planish {

double arc_factor(Angle beta, EdgeKind kind, double slope) {
  const double tangent = std::tan(0.5 * beta.radians());
  const double alpha = std::numbers::pi - beta.radians();
  if (slope == 0.0)
    return (kind == EdgeKind::facing ? alpha : 2.0 * std::numbers::pi - alpha) * tangent;
  // ω from math.md#tangent-cone; tan φ / sin ω, where both are small together, by their quotient.
  const double phi = std::atan(std::abs(slope));
  const double omega = std::atan(std::sin(phi) * tangent);
  const double theta = std::atan2(std::tan(phi), std::sin(omega));
  const double azimuth = kind == EdgeKind::facing ? theta : std::numbers::pi - theta;
  return 2.0 * azimuth * std::sin(omega) / std::sin(phi);
}

}  // namespace planish
