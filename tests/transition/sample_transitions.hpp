#pragma once

#include <planish/sheet/certificate.hpp>
#include <planish/transition/transition.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

// Transitions to test with, and their flat patterns.

namespace planish::test {

constexpr double kPi = std::numbers::pi;

inline Frame frame_at(const Vec3& origin, double tilt = 0.0, double twist = 0.0) {
  const Eigen::AngleAxisd tilted(tilt, Vec3::UnitX()), twisted(twist, Vec3::UnitZ());
  const Eigen::Matrix3d axes = (tilted * twisted).toRotationMatrix();
  return {origin, axes.col(0), axes.col(1), axes.col(2)};
}

/// Between two profiles in parallel planes, the second `rise` above the first, moved by (x, y).
inline TransitionSpec between(Profile from, Profile to, const Vec3& apart) {
  TransitionSpec spec;
  spec.thickness = 1.0;
  spec.from = {std::move(from), frame_at(Vec3::Zero())};
  spec.to = {std::move(to), frame_at(apart)};
  return spec;
}

inline PolygonProfile rectangle(double width, double height) {
  const double x = 0.5 * width, y = 0.5 * height;
  return {{{-x, -y}, {x, -y}, {x, y}, {-x, y}}};
}

inline PolygonProfile regular_polygon(int corners, double radius) {
  PolygonProfile polygon;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * kPi * i / corners;
    polygon.corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return polygon;
}

inline Transition made(const TransitionSpec& spec) {
  auto transition = make_transition(spec);
  EXPECT_TRUE(transition) << code_name(transition.error().code) << ": "
                          << transition.error().message;
  return transition ? std::move(*transition) : Transition{};
}

inline FlattenOptions flatten_options(const TransitionSpec& spec) {
  return {.allowance = ConstantK{spec.k_factor, "test"},
          .curve_tolerance = 1e-7,
          .merge_tolerance = 1e-7};
}

inline FlatPattern laid_flat(const Sheet& sheet, const TransitionSpec& spec) {
  auto pattern = flatten(sheet, flatten_options(spec));
  EXPECT_TRUE(pattern) << code_name(pattern.error().code) << ": " << pattern.error().message;
  return pattern ? std::move(*pattern) : FlatPattern{};
}

inline double flat_area(const Transition& transition, const TransitionSpec& spec) {
  double area = 0.0;
  for (const Sheet& piece : transition.pieces)
    area += laid_flat(piece, spec).area;
  return area;
}

/// Whether a border of a piece runs along a profile: all of it in the profile's plane, and no apex.
inline bool lies_on(const Face& face, const Border& border, const PlacedProfile& profile) {
  if (border.edge_length == 0.0) return false;
  for (const double t : {0.0, 0.5, 1.0}) {
    const Vec3 p = profile.frame.local(skin_point(face, point_at(border.curve, t)));
    if (std::abs(p.z()) > 1e-7 * (1.0 + p.norm())) return false;
  }
  return true;
}

/// Length of the images of the borders on a profile.
inline double flat_border_length(const Transition& transition, const TransitionSpec& spec,
                                 const PlacedProfile& profile) {
  double sum = 0.0;
  for (const Sheet& piece : transition.pieces) {
    const auto flat = flat_sheet(piece, flatten_options(spec));
    for (const FaceId id : piece.faces.ids()) {
      const BorderLoop& loop = piece[id].loops.front();
      for (std::size_t i = 0; i < loop.size(); ++i)
        if (lies_on(piece[id], loop[i], profile)) sum += length(flat->layout.outline(id)[i]);
    }
  }
  return sum;
}

/// The area and both perimeters, in space and laid flat, relative 1e-9.
inline void expect_sizes(const TransitionSpec& spec, double area, double first, double second) {
  constexpr double kClose = 1e-9;
  const Transition transition = made(spec);
  ASSERT_FALSE(transition.pieces.empty());
  EXPECT_NEAR(transition.area / area, 1.0, kClose);
  EXPECT_NEAR(transition.perimeters[0] / first, 1.0, kClose);
  EXPECT_NEAR(transition.perimeters[1] / second, 1.0, kClose);
  double patches = 0.0;
  for (const TransitionPatch& patch : transition.patches)
    patches += patch.area;
  EXPECT_NEAR(patches / area, 1.0, kClose);
  EXPECT_NEAR(flat_area(transition, spec) / area, 1.0, kClose);
  EXPECT_NEAR(flat_border_length(transition, spec, spec.from) / first, 1.0, kClose);
  EXPECT_NEAR(flat_border_length(transition, spec, spec.to) / second, 1.0, kClose);
}

inline double simpson(const std::function<double(double)>& f, double a, double b,
                      int intervals = 4000) {
  const double h = (b - a) / intervals;
  double sum = f(a) + f(b);
  for (int i = 1; i < intervals; ++i)
    sum += (i % 2 == 1 ? 4.0 : 2.0) * f(a + i * h);
  return sum * h / 3.0;
}

/// Area of the cone over a curve from its apex to the curve: ½ ∫ |(c − apex) × c′|.
inline double cone_area(const Vec3& apex, const std::function<Vec3(double)>& c,
                        const std::function<Vec3(double)>& c_prime, double t0, double t1) {
  return 0.5 * simpson([&](double t) { return (c(t) - apex).cross(c_prime(t)).norm(); }, t0, t1);
}

inline double circle_cone_area(const Vec3& apex, const Vec3& centre, double radius, double t0,
                               double t1) {
  return cone_area(
      apex, [&](double t) -> Vec3 { return centre + radius * Vec3(std::cos(t), std::sin(t), 0.0); },
      [&](double t) -> Vec3 { return radius * Vec3(-std::sin(t), std::cos(t), 0.0); }, t0, t1);
}

inline double ellipse_perimeter(double rx, double ry) {
  const double a = std::max(rx, ry), b = std::min(rx, ry);
  return 4.0 * a * std::comp_ellint_2(std::sqrt(1.0 - b * b / (a * a)));
}

}  // namespace planish::test
