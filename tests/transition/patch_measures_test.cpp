#include "ruled_patch.hpp"
#include "sample_rings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace planish::test {
namespace {

using namespace transition_detail;

const double kSlant = std::hypot(80.0, 30.0);

TEST(PatchArea, IsThatOfAFrustum) {
  const Ring ring = frustum();
  EXPECT_NEAR(ring.patch(0).area(0.0, 1.0), kPi * 70 * kSlant, 1e-8);
  EXPECT_NEAR(ring.patch(0).area(0.2, 0.3), 0.1 * kPi * 70 * kSlant, 1e-9);
}

TEST(PatchArea, IsThatOfTrapeziaAndObliqueCones) {
  double area = 0.0;
  for (const RuledPatch& patch : pyramid().patches)
    area += patch.area(0.0, 1.0);
  EXPECT_NEAR(area, 4 * 80 * std::hypot(80, 20), 1e-9);
  const Ring ring = square_to_circle();
  EXPECT_NEAR(first_cone(ring).area(0.0, 1.0),
              circle_cone_area({50, 50, 0}, {0, 0, 80}, 30, 0.0, kPi / 2), 1e-7);
}

TEST(PatchBorderLength, IsTheArcOrZeroWhereASideStands) {
  EXPECT_NEAR(frustum().patch(0).border_length(0, 0.0, 0.25), 0.5 * kPi * 50, 1e-11);
  const Ring ring = square_to_circle();
  EXPECT_EQ(first_cone(ring).border_length(0, 0.0, 1.0), 0.0);
  EXPECT_NEAR(first_cone(ring).border_length(1, 0.0, 1.0), 0.5 * kPi * 30, 1e-9);
}

TEST(PatchTurn, OfAConeIsItsAzimuthTimesTheCosineOfItsHalfAngle) {
  EXPECT_NEAR(frustum().patch(0).turn(0.0, 1.0), 2 * kPi * 80 / kSlant, 1e-11);
  EXPECT_EQ(pyramid().patch(0).turn(0.0, 1.0), 0.0);
}

TEST(PatchTurned, IsBetweenTheNormalsTheLongWayRoundBeyondAHalf) {
  const Ring ring = frustum();
  // Normals of a quarter turn apart, both 30/80 upwards.
  const double quarter = std::acos(30 * 30 / (kSlant * kSlant));
  EXPECT_NEAR(ring.patch(0).turned(0.1, 0.35), quarter, 1e-12);
  EXPECT_NEAR(ring.patch(0).turned(0.1, 0.85), 2 * kPi - quarter, 1e-12);
}

TEST(PatchTurned, GoesTheLongWayRoundFromHalfATurnOn) {
  // Of a frustum that is nearly a tube, so that normals turn about its axis by their rulings' share
  // of the circle, wherever they begin.
  const Ring ring = ring_between(EllipseProfile{50, 50}, EllipseProfile{49, 49}, {0, 0, 80});
  for (const double share : {0.02, 0.25, 0.49, 0.51, 0.75, 0.98})
    for (const double from : {0.0, 0.01, 0.3, 1.0 - share}) {
      if (from + share > 1.0) continue;
      const double between = std::acos((80 * 80 * std::cos(2 * kPi * share) + 1) / (80 * 80 + 1));
      EXPECT_NEAR(ring.patch(0).turned(from, from + share),
                  share < 0.5 ? between : 2 * kPi - between, 1e-8)
          << share;
    }
}

TEST(PatchRadii, OfAConeGrowWithTheDistanceFromItsAxis) {
  const RuledPatch::Radii radii = frustum().patch(0).smallest_radii(0.0, 1.0);
  EXPECT_NEAR(radii.end, 20 * kSlant / 80, 1e-10);
  EXPECT_NEAR(radii.middle, 35 * kSlant / 80, 1e-10);
}

/// Radius of curvature of the cone over the circle at the circle (Meusnier, Euler).
double radius_at_circle(const Vec3& apex, const Vec3& centre, double radius, double t) {
  const Vec3 out(std::cos(t), std::sin(t), 0.0), along(-std::sin(t), std::cos(t), 0.0);
  const Vec3 g = (centre + radius * out - apex).normalized(), n = along.cross(g).normalized();
  const double sine = along.cross(g).norm();
  return sine * sine * radius / std::abs(n.dot(out));
}

TEST(PatchDistanceOfRadius, IsWhereTheTightestRulingOfAnObliqueConeIsWideEnough) {
  const Vec3 apex(50, 50, 0), centre(0, 0, 80);
  double expected = 0.0;
  for (int i = 0; i <= 10000; ++i) {
    const double t = 0.5 * kPi * i / 10000;
    const double length = (centre + 30 * Vec3(std::cos(t), std::sin(t), 0) - apex).norm();
    expected = std::max(expected, 2.5 * length / radius_at_circle(apex, centre, 30, t));
  }
  const Ring ring = square_to_circle();
  EXPECT_NEAR(first_cone(ring).distance_of_radius(2.5), expected, 1e-4 * expected);
}

TEST(PatchTipArea, OfAConeIsASectorOfItsDevelopment) {
  const Vec3 apex(50, 50, 0), centre(0, 0, 80);
  const auto arm = [&](int i) -> Vec3 {
    const double t = 0.5 * kPi * i / 20000;
    return (centre + 30 * Vec3(std::cos(t), std::sin(t), 0) - apex).normalized();
  };
  double angle = 0.0;
  for (int i = 0; i < 20000; ++i)
    angle += (arm(i + 1) - arm(i)).norm();
  const Ring ring = square_to_circle();
  EXPECT_NEAR(first_cone(ring).tip_area(0.0, 1.0, {.at_from = {3.0, 0.0}, .at_to = {3.0, 0.0}}),
              0.5 * 9.0 * angle, 1e-6);
}

TEST(PatchTipArea, OfAPlaneAreTrianglesInItsCorners) {
  const RuledPatch patch = pyramid().patch(0);
  const auto [p0, q0] = patch.ruling(0.0);
  const Vec3 p1 = patch.ruling(1.0)[0];
  const double sine = (p1 - p0).normalized().cross((q0 - p0).normalized()).norm();
  EXPECT_NEAR(patch.tip_area(0.0, 1.0, {.at_from = {2.0, 0.0}, .at_to = {3.0, 0.0}}),
              0.5 * (4.0 + 9.0) * sine, 1e-12);
}

// ---- by small steps from ruling to ruling

/// Sizes of a patch as triangles between its rulings and their normals tell.
struct Stepped {
  double area = 0.0, turn = 0.0, middle = 1e300, end = 1e300;
  std::array<double, 2> border{};
};

Stepped stepped(const RuledPatch& patch, double from, double to) {
  constexpr int kSteps = 4000;
  Stepped sum;
  const bool apex = patch.stands(0) || patch.stands(1);
  for (int i = 0; i < kSteps; ++i) {
    const double here = std::lerp(from, to, i / double(kSteps)),
                 next = std::lerp(from, to, (i + 1) / double(kSteps));
    const auto [p0, q0] = patch.ruling(here);
    const auto [p1, q1] = patch.ruling(next);
    const double turn = patch.normal(here).cross(patch.normal(next)).norm();
    sum.area += 0.5 * (q1 - p0).cross(q0 - p1).norm();
    sum.turn += turn;
    sum.border[0] += (p1 - p0).norm();
    sum.border[1] += (q1 - q0).norm();
    const Vec3 along = (q0 + q1 - p0 - p1).normalized();
    const auto across = [&](const Vec3& step) { return (step - step.dot(along) * along).norm(); };
    const double near = across(p1 - p0), far = across(q1 - q0);
    sum.middle = std::min(sum.middle, 0.5 * (near + far) / turn);
    sum.end = std::min(sum.end, (apex ? std::max(near, far) : std::min(near, far)) / turn);
  }
  return sum;
}

Ring ellipses() {
  return ring_between(EllipseProfile{50, 30}, EllipseProfile{20, 40}, {10, 5, 80});
}

/// Four cones that are not alike: none is symmetric, and of none is the tightest place in its
/// middle.
Ring uneven_cones() {
  return ring_between(rectangle(200, 60), EllipseProfile{30, 30}, {25, 10, 80});
}

/// The same the other way up.
Ring uneven_cones_turned() {
  return ring_between(EllipseProfile{30, 20}, rectangle(200, 60), {25, 10, 80});
}

/// A rounded square, nearly flat in the middle of its sides: there a ruling's end on a circle
/// hardly moves.
SplineProfile squarish(double radius) {
  SplineProfile spline;
  for (int i = 0; i < 32; ++i) {
    const double angle = 2 * kPi * i / 32;
    const double r = radius * (1.0 + 0.055 * std::cos(4 * angle));
    spline.points.emplace_back(r * std::cos(angle), r * std::sin(angle));
  }
  return spline;
}

TEST(PatchMeasures, OfAnyPatchAreThoseOfSmallSteps) {
  for (const Ring& ring : {ellipses(), uneven_cones(), uneven_cones_turned(), frustum(),
                           ring_between(squarish(60), EllipseProfile{30, 30}, {5, 3, 80}),
                           ring_between(EllipseProfile{30, 30}, squarish(60), {5, 3, 80})})
    for (const RuledPatch& patch : ring.patches) {
      if (patch.plane()) continue;
      for (const auto& [from, to] : {std::pair{0.0, 1.0}, std::pair{0.1, 0.45}}) {
        const Stepped sum = stepped(patch, from, to);
        EXPECT_NEAR(patch.area(from, to) / sum.area, 1.0, 1e-5);
        EXPECT_NEAR(patch.turn(from, to) / sum.turn, 1.0, 1e-5);
        for (int side = 0; side < 2; ++side)
          EXPECT_NEAR(patch.border_length(side, from, to), sum.border[side],
                      1e-5 * (sum.border[side] + 1e-9));
        // Found on 64 rulings.
        const RuledPatch::Radii radii = patch.smallest_radii(from, to);
        EXPECT_NEAR(radii.middle / sum.middle, 1.0, 0.05);
        EXPECT_NEAR(radii.end / sum.end, 1.0, 0.05);
      }
    }
}

TEST(PatchTurned, IsTheAngleBetweenTheNormalsUpToHalfATurnAndTheRestBeyond) {
  const Ring ring = ellipses();
  const RuledPatch& patch = ring.patch(0);
  for (const auto& [from, to] : {std::pair{0.0, 0.2}, std::pair{0.3, 0.7}, std::pair{0.1, 0.9}}) {
    const double between = std::acos(patch.normal(from).dot(patch.normal(to)));
    // The normals turn once about the axis, roughly evenly.
    EXPECT_NEAR(patch.turned(from, to), to - from < 0.5 ? between : 2 * kPi - between, 1e-9);
  }
}

TEST(PatchDistanceOfRadius, IsFoundWhereverOnAConeItsTightestRulingIs) {
  const Vec3 centre(25, 10, 80);
  const Ring ring = uneven_cones();
  int cones = 0;
  for (const RuledPatch& patch : ring.patches) {
    if (patch.plane()) continue;
    ++cones;
    const Vec3 apex = patch.ruling(0.0)[0];
    const Vec3 arm = patch.ruling(0.0)[1] - centre;
    const double first = std::atan2(arm.y(), arm.x());
    double expected = 0.0, tightest = 1e300, angle = 0.0;
    Vec3 last = (patch.ruling(0.0)[1] - apex).normalized();
    for (int i = 0; i <= 10000; ++i) {
      const double t = first + 0.5 * kPi * i / 10000;
      const Vec3 way = centre + 30 * Vec3(std::cos(t), std::sin(t), 0) - apex;
      const double radius = radius_at_circle(apex, centre, 30, t);
      expected = std::max(expected, 2.5 * way.norm() / radius);
      tightest = std::min(tightest, radius);
      angle += (way.normalized() - last).norm();
      last = way.normalized();
    }
    EXPECT_NEAR(patch.distance_of_radius(2.5) / expected, 1.0, 1e-3);
    EXPECT_NEAR(patch.distance_of_radius(5.0), 2.0 * patch.distance_of_radius(2.5), 1e-9);
    EXPECT_NEAR(patch.smallest_radii(0.0, 1.0).end / tightest, 1.0, 1e-3);
    EXPECT_NEAR(patch.smallest_radii(0.0, 1.0).middle / tightest, 0.5, 1e-3) << "half-way";
    EXPECT_NEAR(patch.tip_area(0.0, 1.0, {.at_from = {3.0, 0.0}, .at_to = {3.0, 0.0}}), 4.5 * angle,
                1e-5);
    EXPECT_EQ(patch.tip_area(0.0, 1.0, {.at_from = {0.0, 3.0}, .at_to = {0.0, 3.0}}), 0.0)
        << "only its apex is a corner";
  }
  EXPECT_EQ(cones, 4);
}

}  // namespace
}  // namespace planish::test
