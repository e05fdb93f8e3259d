#include "fit_surface.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

// The plane, cylinder or cone through sampled points and normals. Normals tell the axis: they are
// perpendicular to a cylinder's and equally inclined to a cone's, so it is the direction of least
// spread, about zero or about their mean. With the axis known, radius and place are linear least
// squares, and a cone's apex lies in every tangent plane. A fit holds only if points and normals
// agree, as points alone leave a wobbling spline undetected.

namespace planish::brep {
namespace {

using Samples = std::vector<SurfaceSample>;

/// A normal may lean this much (radians) from the fitted surface's: a spline that stays within the
/// tolerance of a cylinder wobbles by less than this.
constexpr double kNormalAgreement = 0.02;

Vec3 mean_point(const Samples& samples) {
  Vec3 mean = Vec3::Zero();
  for (const SurfaceSample& sample : samples)
    mean += sample.point;
  return mean / static_cast<double>(samples.size());
}

/// Direction of least spread of the normals: about their mean (cone, `centred`) or about zero.
Vec3 least_spread(const Samples& samples, bool centred) {
  Vec3 mean = Vec3::Zero();
  if (centred) {
    for (const SurfaceSample& sample : samples)
      mean += sample.normal;
    mean /= static_cast<double>(samples.size());
  }
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const SurfaceSample& sample : samples) {
    const Vec3 d = sample.normal - mean;
    spread += d * d.transpose();
  }
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(0);
}

std::optional<SurfaceFit> fit_plane(const Samples& samples, double tolerance) {
  Vec3 normal = Vec3::Zero();
  for (const SurfaceSample& sample : samples)
    normal += sample.normal;
  if (normal.norm() == 0.0) return {};
  const Frame frame = frame_from_normal(mean_point(samples), normal.normalized());
  double deviation = 0.0;
  for (const SurfaceSample& sample : samples) {
    deviation = std::max(deviation, std::abs(frame.local(sample.point).z()));
    if (sample.normal.dot(frame.z) < std::cos(kNormalAgreement)) return {};
  }
  if (deviation > tolerance) return {};
  return SurfaceFit{frame, deviation};
}

/// Largest distance of a sample from a developable, infinite where the normals disagree.
double deviation_from(const Developable& surface, const Samples& samples) {
  double deviation = 0.0;
  for (const SurfaceSample& sample : samples) {
    const Vec2 uv = parameters_of(surface, sample.point, 0.0);
    deviation = std::max(deviation, (point_on(surface, uv) - sample.point).norm());
    if (std::abs(normal_on(surface, uv.x()).dot(sample.normal)) < std::cos(kNormalAgreement))
      return std::numeric_limits<double>::infinity();
  }
  return deviation;
}

std::optional<SurfaceFit> fit_cylinder(const Samples& samples, double tolerance) {
  const Vec3 axis = least_spread(samples, false);
  const Frame frame = frame_from_normal(mean_point(samples), axis);
  // p = c + r n in the plane across the axis: linear in (c, r).
  Eigen::MatrixXd rows(2 * static_cast<Eigen::Index>(samples.size()), 3);
  Eigen::VectorXd right(rows.rows());
  for (Eigen::Index i = 0; i < static_cast<Eigen::Index>(samples.size()); ++i) {
    const SurfaceSample& sample = samples[i];
    const Vec2 n(sample.normal.dot(frame.x), sample.normal.dot(frame.y));
    const Vec2 p = frame.local2(sample.point);
    rows.row(2 * i) << 1, 0, n.x();
    rows.row(2 * i + 1) << 0, 1, n.y();
    right.segment<2>(2 * i) = p;
  }
  const Vec3 solution = rows.colPivHouseholderQr().solve(right);
  constexpr double kOfRadius = 0.05;  // small bends are fitted more closely than the tolerance
  if (!solution.allFinite() || solution.z() == 0.0) return {};
  Frame placed = frame;
  placed.origin = frame.point(solution.head<2>());
  const Cylinder cylinder{placed, std::abs(solution.z())};
  const double deviation = deviation_from(cylinder, samples);
  if (deviation > std::min(tolerance, kOfRadius * cylinder.radius)) return {};
  return SurfaceFit{Developable(cylinder), deviation};
}

std::optional<SurfaceFit> fit_cone(const Samples& samples, double tolerance) {
  Vec3 axis = least_spread(samples, true);
  // Every tangent plane contains the apex: n · apex = n · p.
  Eigen::Matrix3d normal_matrix = Eigen::Matrix3d::Zero();
  Vec3 right = Vec3::Zero();
  const Vec3 mean = mean_point(samples);
  double inclination = 0.0;
  for (const SurfaceSample& sample : samples) {
    normal_matrix += sample.normal * sample.normal.transpose();
    right += sample.normal * sample.normal.dot(sample.point - mean);
    inclination += sample.normal.dot(axis) / static_cast<double>(samples.size());
  }
  const Vec3 apex = mean + normal_matrix.colPivHouseholderQr().solve(right);
  if (!apex.allFinite()) return {};
  if ((mean - apex).dot(axis) < 0) axis = -axis;
  const double half_angle = std::asin(std::clamp(std::abs(inclination), 0.0, 1.0));
  constexpr double kCylinderLike = 1e-4;  // radians; below, the apex is too far to be placed
  if (half_angle < kCylinderLike) return {};
  const Cone cone{frame_from_normal(apex, axis), half_angle};
  const double deviation = deviation_from(cone, samples);
  if (deviation > tolerance) return {};
  return SurfaceFit{Developable(cone), deviation};
}

}  // namespace

std::optional<SurfaceFit> fit_surface(const Samples& samples, double tolerance) {
  if (samples.size() < 4) return {};
  if (auto plane = fit_plane(samples, tolerance)) return plane;
  if (auto cylinder = fit_cylinder(samples, tolerance)) return cylinder;
  return fit_cone(samples, tolerance);
}

}  // namespace planish::brep
