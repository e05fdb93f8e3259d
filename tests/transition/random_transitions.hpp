#pragma once

#include "hull_oracle.hpp"
#include "sample_transitions.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace planish::test {

inline Profile random_profile(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const auto between = [&](double low, double high) { return low + (high - low) * unit(random); };
  switch (random() % 7) {
    case 0: {  // corners on an ellipse, somewhere
      PolygonProfile polygon;
      const int n = static_cast<int>(3 + random() % 6);
      const double rx = between(30, 80), ry = between(30, 80);
      for (int i = 0; i < n; ++i) {
        const double t = 2.0 * kPi * (i + between(0.1, 0.9)) / n;
        polygon.corners.emplace_back(rx * std::cos(t), ry * std::sin(t));
      }
      if (unit(random) < 0.5) std::ranges::reverse(polygon.corners);
      return polygon;
    }
    case 1:
      return rectangle(between(40, 120), between(40, 120));
    case 2: {
      const double radius = between(20, 80);
      return EllipseProfile{radius, radius};
    }
    case 3:
      return EllipseProfile{between(30, 80), between(30, 80)};
    case 4:
      return RoundedRectangleProfile{between(60, 140), between(60, 140), between(5, 28)};
    case 5: {
      const double width = between(30, 80);
      return ObroundProfile{width + between(5, 70), width};
    }
    default: {
      SplineProfile spline;
      const int n = static_cast<int>(7 + random() % 6);
      const double rx = between(40, 80), ry = rx * between(0.7, 1.4), start = between(0, 1);
      for (int i = 0; i < n; ++i) {
        const double t = 2.0 * kPi * (i + start) / n, r = between(0.99, 1.01);
        spline.points.emplace_back(r * rx * std::cos(t), r * ry * std::sin(t));
      }
      return spline;
    }
  }
}

/// A plane pose in which each profile lies wholly on one side of the other's plane; often one with
/// parallel edges or planes.
inline TransitionSpec random_transition(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const auto often_zero = [&](double value) { return unit(random) < 0.4 ? 0.0 : value; };
  TransitionSpec spec;
  spec.thickness = 0.01;
  spec.from.profile = random_profile(random);
  spec.to.profile = random_profile(random);
  spec.from.frame = frame_at(Vec3::Zero(), 0.0, often_zero(2.0 * kPi * unit(random)));
  const double tilt = often_zero(kPi / 3 * unit(random)),
               twist = often_zero(2.0 * kPi * unit(random));
  const Vec3 aside(often_zero(160 * unit(random) - 80), often_zero(160 * unit(random) - 80), 0);
  const Eigen::AngleAxisd turned(2.0 * kPi * unit(random), Vec3::UnitZ());
  const auto from = sampled_in_space(spec.from, 50);
  for (double rise = 40 + 60 * unit(random);; rise *= 1.3) {
    Frame& frame = spec.to.frame;
    frame = frame_at(aside + rise * Vec3::UnitZ(), tilt, twist);
    if (tilt != 0.0)
      for (Vec3* axis : {&frame.x, &frame.y, &frame.z})
        *axis = turned * *axis;
    const auto to = sampled_in_space(spec.to, 50);
    const bool above = std::ranges::all_of(to, [](const Vec3& p) { return p.z() > 5.0; });
    const bool below = std::ranges::all_of(
        from, [&](const Vec3& p) { return frame.local(p).z() < -5.0; });
    if (above && below) break;
  }
  return spec;
}

inline Eigen::Isometry3d random_motion(std::mt19937& random) {
  std::uniform_real_distribution<double> around(-1.0, 1.0);
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.rotate(Eigen::Quaterniond(around(random), around(random), around(random), around(random))
                    .normalized());
  motion.pretranslate(300.0 * Vec3(around(random), around(random), around(random)));
  return motion;
}

inline PlacedProfile moved(PlacedProfile profile, const Eigen::Isometry3d& motion) {
  profile.frame.origin = motion * profile.frame.origin;
  for (Vec3* axis : {&profile.frame.x, &profile.frame.y, &profile.frame.z})
    *axis = motion.linear() * *axis;
  return profile;
}

}  // namespace planish::test
