#include "surface_checks.hpp"

#include <planish/geometry/developable.hpp>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

namespace planish {
namespace {

using std::numbers::pi;
using test::any;
using test::simpson;
using test::Tangents;

using KnotAt = std::function<Ruled::Knot(double)>;

Ruled ruled_from(const KnotAt& knot, double begin, double end, int intervals) {
  Ruled result;
  for (int i = 0; i <= intervals; ++i)
    result.knots.push_back(knot(begin + (end - begin) * i / intervals));
  return result;
}

/// Upright cylinder over a plane curve.
KnotAt cylinder_over(const std::function<Vec2(double)>& curve,
                     const std::function<Vec2(double)>& derivative) {
  return [=](double u) -> Ruled::Knot {
    const Vec2 b = curve(u);
    const Vec2 d = derivative(u);
    return {u, {b.x(), b.y(), 0}, {d.x(), d.y(), 0}, Vec3::UnitZ(), Vec3::Zero()};
  };
}

KnotAt over_parabola() {
  return cylinder_over([](double u) { return Vec2(u, u * u); },
                       [](double u) { return Vec2(1, 2 * u); });
}

KnotAt over_ellipse(double a, double b) {
  return cylinder_over([=](double u) { return Vec2(a * std::cos(u), b * std::sin(u)); },
                       [=](double u) { return Vec2(-a * std::sin(u), b * std::cos(u)); });
}

KnotAt over_sine() {
  return cylinder_over([](double u) { return Vec2(u, std::sin(u)); },
                       [](double u) { return Vec2(1, std::cos(u)); });
}

/// Cone from the apex through the circle of that radius about the z axis in z = 0. v = 0 on the
/// circle; the apex is at v = −|circle − apex|.
KnotAt cone_through_circle(const Vec3& apex, double radius) {
  return [=](double u) -> Ruled::Knot {
    const Vec3 b = radius * Vec3(std::cos(u), std::sin(u), 0);
    const Vec3 b_prime = radius * Vec3(-std::sin(u), std::cos(u), 0);
    const Vec3 w = b - apex;
    const Vec3 g = w.normalized();
    return {u, b, b_prime, g, (b_prime - g * g.dot(b_prime)) / w.norm()};
  };
}

/// Tangents of the helix (a cos u, a sin u, pitch·u); v = 0 lies `reach` along them, so that the
/// helix, the edge of regression, is at v = −reach.
KnotAt tangents_of_helix(double a, double pitch, double reach) {
  return [=](double u) -> Ruled::Knot {
    const double speed = std::hypot(a, pitch);
    const Vec3 helix(a * std::cos(u), a * std::sin(u), pitch * u);
    const Vec3 g = Vec3(-a * std::sin(u), a * std::cos(u), pitch) / speed;
    const Vec3 g_prime = Vec3(-a * std::cos(u), -a * std::sin(u), 0) / speed;
    return {u, helix + reach * g, speed * g + reach * g_prime, g, g_prime};
  };
}

Ruled moved(Ruled ruled, const Eigen::Isometry3d& motion) {
  for (auto& k : ruled.knots) {
    k.b = motion * k.b;
    for (Vec3* x : {&k.b_prime, &k.g, &k.g_prime})
      *x = motion.linear() * *x;
  }
  return ruled;
}

Ruled scaled(Ruled ruled, double factor) {
  for (auto& k : ruled.knots) {
    k.b *= factor;
    k.b_prime *= factor;
  }
  return ruled;
}

/// The same point set, run through backwards: rulings kept, normal turned round.
Ruled backwards(const Ruled& ruled) {
  Ruled result;
  for (auto k = ruled.knots.rbegin(); k != ruled.knots.rend(); ++k)
    result.knots.push_back({-k->u, k->b, -k->b_prime, k->g, -k->g_prime});
  return result;
}

/// A surface and a part of it that is a regular patch at offsets within ±0.2.
struct Patch {
  KnotAt knot;
  Vec2 lo, hi;
};

const std::vector<Patch>& patches() {
  static const std::vector<Patch> all{
      {over_parabola(), {-1, -5}, {2, 5}},
      {over_ellipse(3, 2), {0, -5}, {5, 5}},
      {over_sine(), {-4, -5}, {5, 5}},
      {cone_through_circle({1, 2, 8}, 4), {-2, -5}, {3, 5}},
      {tangents_of_helix(3, 1, 4), {0, -3}, {3, 5}},
  };
  return all;
}

Ruled ruled_from(const Patch& patch, double spacing) {
  const double begin = patch.lo.x(), end = patch.hi.x();
  return ruled_from(patch.knot, begin, end, static_cast<int>((end - begin) / spacing));
}

/// One of the patches, an offset, and a point on it.
struct RuledCase {
  Ruled surface;
  double offset;
  Vec2 uv;
};

/// With few knots, for what must hold whatever surface the knots make.
RuledCase any_ruled_case() {
  const Patch& patch = patches()[*rc::gen::inRange<std::size_t>(0, patches().size())];
  return {ruled_from(patch, 0.2),
          any(-0.2, 0.2),
          {any(patch.lo.x(), patch.hi.x()), any(patch.lo.y(), patch.hi.y())}};
}

/// With so many knots that the surface is developable between them too; the development, which
/// takes long to make, is kept.
struct FineCase : RuledCase {
  const Development* image;
};

FineCase any_fine_case() {
  struct Developed {
    Ruled surface;
    double offset;
    Development image;
  };
  static std::map<std::pair<std::size_t, int>, Developed> kept;
  const std::size_t which = *rc::gen::inRange<std::size_t>(0, patches().size());
  const int side = *rc::gen::inRange(-1, 2);
  const Patch& patch = patches()[which];
  auto found = kept.find({which, side});
  if (found == kept.end()) {
    const Ruled surface = ruled_from(patch, 0.01);
    const double offset = 0.2 * side;
    found = kept.emplace(std::pair(which, side),
                         Developed{surface, offset, Development(surface, offset)})
                .first;
  }
  const Developed& d = found->second;
  return {{d.surface, d.offset, {any(patch.lo.x(), patch.hi.x()), any(patch.lo.y(), patch.hi.y())}},
          &d.image};
}

// How far fine cases are from developable: their normals turn at rates that are off by the square
// of the knots' spacing.
constexpr double interpolation = 1e-5;

RC_GTEST_PROP(UnrollRuled, IsAnIsometryOfEveryOffset, ()) {
  const FineCase c = any_fine_case();
  const test::Tangents t = test::tangents(c.surface, c.uv, c.offset);
  const Eigen::Matrix2d j = c.image->jacobian(c.uv);
  const Eigen::Matrix2d plane = j.transpose() * j;
  Eigen::Matrix2d space;
  space << t.u.dot(t.u), t.u.dot(t.v), t.u.dot(t.v), t.v.dot(t.v);
  RC_ASSERT((plane - space).norm() <= interpolation * (1.0 + plane.norm()));
}

RC_GTEST_PROP(UnrollRuled, IsNotMirroredSeenFromTheNormal, ()) {
  const FineCase c = any_fine_case();
  const test::Tangents t = test::tangents(c.surface, c.uv, c.offset);
  const double area = t.u.cross(t.v).dot(normal_on(c.surface, c.uv.x()));
  const double image = c.image->jacobian(c.uv).determinant();
  RC_ASSERT(area > 0.0);
  RC_ASSERT(std::abs(image - area) <= interpolation * (1.0 + area));
}

RC_GTEST_PROP(UnrollRuled, HasItsOwnDerivative, ()) {
  const RuledCase c = any_ruled_case();
  const Development image(c.surface, 0.0);
  constexpr double h = 1e-5;
  const Eigen::Matrix2d j = image.jacobian(c.uv);
  for (const Vec2& e : {Vec2(1, 0), Vec2(0, 1)}) {
    const Vec2 slope = (image.develop(c.uv + h * e) - image.develop(c.uv - h * e)) / (2 * h);
    RC_ASSERT((slope - j * e).norm() <= 1e-7 * (1.0 + j.norm()));
  }
}

RC_GTEST_PROP(UnrollRuled, IsUndoneByFold, ()) {
  const RuledCase c = any_ruled_case();
  const Development image(c.surface, c.offset);
  const Vec2 p = image.develop(c.uv);
  const Vec2 uv = image.fold(p);
  RC_ASSERT((image.develop(uv) - p).norm() <= 1e-12);
  RC_ASSERT((uv - c.uv).norm() <= 1e-10);
}

RC_GTEST_PROP(UnrollRuled, FoldsStraightLinesToGeodesics, ()) {
  const FineCase c = any_fine_case();
  const Development& image = *c.image;
  const Vec2 middle = image.develop(c.uv);
  const double angle = any(0, 2 * pi);
  const double h = 0.01;
  const auto folded = [&](double k) {
    const Vec2 p = middle + k * h * Vec2(std::cos(angle), std::sin(angle));
    return point_on(c.surface, image.fold(p), c.offset);
  };
  RC_PRE(c.uv.x() > c.surface.knots.front().u + 0.05);
  RC_PRE(c.uv.x() < c.surface.knots.back().u - 0.05);
  const Vec3 acceleration = (folded(1) - 2 * folded(0) + folded(-1)) / (h * h);
  const Vec3 n = normal_on(c.surface, c.uv.x());
  RC_ASSERT((acceleration - n * n.dot(acceleration)).norm() <= 0.02);
}

RC_GTEST_PROP(UnrollRuled, DoesNotSeeWhereTheSurfaceLies, ()) {
  const RuledCase c = any_ruled_case();
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.rotate(Eigen::AngleAxisd(any(0, 6), Vec3(any(0.1, 1), any(-1, 1), 0.3).normalized()));
  motion.pretranslate(Vec3(any(-100, 100), any(-100, 100), any(-100, 100)));
  const Ruled other = moved(c.surface, motion);
  const Vec3 p = motion * point_on(c.surface, c.uv, c.offset);
  RC_ASSERT((point_on(other, c.uv, c.offset) - p).norm() <= 1e-10);
  const Vec2 before = Development(c.surface, c.offset).develop(c.uv);
  RC_ASSERT((Development(other, c.offset).develop(c.uv) - before).norm() <= 1e-9);
}

RC_GTEST_PROP(UnrollRuled, ScalesWithTheSurface, ()) {
  const RuledCase c = any_ruled_case();
  const Development image(scaled(c.surface, 10), 10 * c.offset);
  const Vec2 after = image.develop({c.uv.x(), 10 * c.uv.y()});
  const Vec2 before = Development(c.surface, c.offset).develop(c.uv);
  RC_ASSERT((after - 10 * before).norm() <= 1e-9);
}

RC_GTEST_PROP(UnrollRuled, SeenFromTheOtherSideIsTheMirrorImage, ()) {
  const RuledCase c = any_ruled_case();
  const Development front(c.surface, c.offset);
  const Development back(backwards(c.surface), -c.offset);
  const Vec2 last(c.surface.knots.back().u, 0.0);
  const double reach = (front.develop(c.uv) - front.develop(last)).norm();
  RC_ASSERT(std::abs(back.develop({-c.uv.x(), c.uv.y()}).norm() - reach) <= 1e-9);
  // At a knot the speed of an offset jumps by O(h²)·offset, and either side may be meant.
  for (const Ruled::Knot& knot : c.surface.knots)
    RC_PRE(std::abs(knot.u - c.uv.x()) > 1e-6);
  const double area = front.jacobian(c.uv).determinant();
  RC_ASSERT(std::abs(back.jacobian({-c.uv.x(), c.uv.y()}).determinant() - area) <= 1e-9);
}

RC_GTEST_PROP(OffsetRuled, LiesAtItsDistanceAndKeepsTheTangentPlane, ()) {
  const FineCase c = any_fine_case();
  const Vec3 shift = point_on(c.surface, c.uv, c.offset) - point_on(c.surface, c.uv);
  const Vec3 n = normal_on(c.surface, c.uv.x());
  RC_ASSERT((shift - c.offset * n).norm() <= 1e-12);
  const test::Tangents t = test::tangents(c.surface, c.uv, c.offset);
  RC_ASSERT(std::abs(t.u.dot(n)) <= interpolation);
  RC_ASSERT((t.v - ruling_on(c.surface, c.uv.x())).norm() <= 1e-9);
}

RC_GTEST_PROP(ParametersOfRuled, NamesTheNormalLineOfEveryOffset, ()) {
  const RuledCase c = any_ruled_case();
  const Vec3 p = point_on(c.surface, c.uv, c.offset);
  RC_ASSERT((parameters_of(c.surface, p, c.uv.x()) - c.uv).norm() <= 1e-9);
}

RC_GTEST_PROP(ParametersOfRuled, FindsNoPointFartherThanAnyOther, ()) {
  const RuledCase c = any_ruled_case();
  const Vec3 p = point_on(c.surface, {c.uv.x(), any(-2, 2)}, any(-0.5, 0.5));
  const double distance = (point_on(c.surface, parameters_of(c.surface, p, 0)) - p).norm();
  RC_ASSERT(distance <= (point_on(c.surface, c.uv) - p).norm() + 1e-6);
}

TEST(ParametersOfRuled, AtTheSeamGivesTheEndAsked) {
  const Developable closed = ruled_from(over_ellipse(3, 2), 0, 2 * pi, 400);
  EXPECT_NEAR((parameters_of(closed, Vec3(3, 0, 1), 0.0) - Vec2(0, 1)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((parameters_of(closed, Vec3(3, 0, 1), 6.0) - Vec2(2 * pi, 1)).norm(), 0.0, 1e-12);
}

TEST(ParametersOfRuled, PastTheEndGivesTheLastRuling) {
  const Developable strip = ruled_from(over_parabola(), 0, 1, 100);
  const Vec2 uv = parameters_of(strip, Vec3(5, 5, 1), 0.0);
  EXPECT_NEAR(uv.x(), 1.0, 0.01);
  EXPECT_NEAR(uv.y(), 1.0, 1e-12);
}

TEST(ParametersOfRuled, PrefersTheEndToAFartherFoot) {
  // The other leg of the parabola has a foot at distance 3, the end of this leg is at 1.35.
  const Developable strip = ruled_from(over_parabola(), -2, 1, 300);
  EXPECT_NEAR(parameters_of(strip, Vec3(1.5, 2.25, 1), -1.5).x(), 1.0, 0.002);
}

TEST(ParametersOfRuled, InTheGapOfAnOpenRingGivesTheNearerEnd) {
  const Developable ring = ruled_from(over_ellipse(3, 2), 0, 5, 500);
  for (const double u : {5.1, 5.5, 6.0, 6.2}) {
    const Vec3 p(3 * std::cos(u), 2 * std::sin(u), 1);
    EXPECT_NEAR(parameters_of(ring, p, 2.0).x(), u < 5.7 ? 5.0 : 0.0, 0.002) << u;
  }
}

/// ∫ sqrt(1 + 4u²) du.
double parabola_length(double u) {
  return 0.5 * u * std::hypot(1.0, 2 * u) + 0.25 * std::asinh(2 * u);
}

TEST(UnrollRuled, ParabolaHasItsClosedFormLengthFromTwoKnots) {
  // A parabola is its own Hermite cubic.
  const Ruled surface = ruled_from(over_parabola(), -1, 2, 1);
  const Development image(surface, 0.0);
  for (const double u : {-1.0, -0.3, 0.0, 0.77, 2.0}) {
    const Vec2 expected(parabola_length(u) - parabola_length(-1), 3.0);
    EXPECT_NEAR((image.develop({u, 3.0}) - expected).norm(), 0.0, 1e-11) << u;
    EXPECT_NEAR((image.fold(expected) - Vec2(u, 3.0)).norm(), 0.0, 1e-11) << u;
  }
}

TEST(UnrollRuled, OffsetOfAParabolaIsLongerByOffsetTimesTurn) {
  // The normal of the surface points out of the parabola, away from its centres of curvature.
  const double turn = std::atan(4.0) - std::atan(-2.0);
  for (const double offset : {-0.4, 0.3, 2.0}) {
    const Development image(ruled_from(over_parabola(), -1, 2, 1), offset);
    const double length = parabola_length(2) - parabola_length(-1) + offset * turn;
    EXPECT_NEAR((image.develop({2.0, 0.0}) - Vec2(length, 0)).norm(), 0.0, 1e-11) << offset;
  }
}

TEST(UnrollRuled, EllipseHasTheLengthOfItsEllipticIntegral) {
  // 3 E(k, φ) is measured from the end of the minor axis.
  const double k = std::sqrt(1 - 4.0 / 9.0);
  const Development image(ruled_from(over_ellipse(3, 2), 0.5 * pi, 2 * pi, 1000), 0.0);
  for (const double phi : {0.5, 1.0, 1.5 * pi}) {
    const double length = 3 * std::ellint_2(k, phi);
    EXPECT_NEAR((image.develop({0.5 * pi + phi, 1.0}) - Vec2(length, 1)).norm(), 0.0, 1e-9) << phi;
  }
}

TEST(UnrollRuled, ConvergesWithTheFourthPowerOfTheKnotSpacing) {
  const double quarter = 3 * std::ellint_2(std::sqrt(5.0) / 3, 0.5 * pi);
  const auto error = [&](int intervals) {
    const Development image(ruled_from(over_ellipse(3, 2), 0.5 * pi, pi, intervals), 0.0);
    return std::abs(image.develop({pi, 0.0}).x() - quarter);
  };
  EXPECT_LT(error(20), error(10) / 12);
  EXPECT_LT(error(40), error(20) / 12);
}

TEST(UnrollRuled, CircularCylinderIsTheCylinder) {
  const Ruled ruled = ruled_from(over_ellipse(5, 5), 0, 4, 800);
  for (const double offset : {-0.5, 0.0, 0.5}) {
    const Development a(ruled, offset);
    const Development b(Cylinder{Frame{}, 5.0}, offset);
    for (const Vec2& uv : {Vec2(0, 0), Vec2(1.3, 7), Vec2(4, -2)})
      EXPECT_NEAR((a.develop(uv) - b.develop(uv)).norm(), 0.0, 1e-8);
  }
}

TEST(UnrollRuled, RightConeIsTheCone) {
  // Apex on the axis above the circle: half-angle atan(3/4), circle at distance 5 from the apex.
  const double sine = 0.6;
  const Ruled ruled = ruled_from(cone_through_circle({0, 0, 4}, 3), -1, 4, 1000);
  for (const double offset : {-0.5, 0.0, 0.5}) {
    const Development image(ruled, offset);
    // With the apex above, the normal b' × g points inwards: the apex of the offset moves the other
    // way.
    const double apex_v = -5.0 + offset / 0.75;
    const Vec2 apex = image.develop({0.0, apex_v});
    const Vec2 start = image.develop({-1.0, 2.0}) - apex;
    for (const double u : {0.0, 1.5, 4.0}) {
      const Vec2 p = image.develop({u, 2.0}) - apex;
      EXPECT_NEAR(p.norm(), 2.0 - apex_v, 1e-8);
      const double turn = std::atan2(start.x() * p.y() - start.y() * p.x(), start.dot(p));
      EXPECT_NEAR(std::remainder(turn + sine * (u + 1), 2 * pi), 0.0, 1e-8);
    }
  }
}

TEST(UnrollRuled, ObliqueConeFollowsThePolarFormula) {
  // math.md#general-cone: polar (|c − V|, ∫ |(c − V) × c′| / |c − V|² dτ) about the apex V.
  const Vec3 apex(1, 2, 8);
  const KnotAt knot = cone_through_circle(apex, 4);
  const Development image(ruled_from(knot, 0, 2 * pi, 2000), 0.0);
  const auto distance = [&](double u) { return (knot(u).b - apex).norm(); };
  const auto rate = [&](double u) {
    const Vec3 w = knot(u).b - apex;
    return w.cross(knot(u).b_prime).norm() / w.squaredNorm();
  };
  const Vec2 center = image.develop({0.0, -distance(0.0)});
  const Vec2 start = (image.develop({0.0, 0.0}) - center).normalized();
  for (const double u : {0.1, 1.0, 3.0, 6.0, 2 * pi}) {
    EXPECT_NEAR((image.develop({u, -distance(u)}) - center).norm(), 0.0, 1e-9) << u;
    const Vec2 p = image.develop({u, 0.0}) - center;
    EXPECT_NEAR(p.norm(), distance(u), 1e-9) << u;
    const double turn = std::atan2(start.x() * p.y() - start.y() * p.x(), start.dot(p));
    EXPECT_NEAR(std::remainder(turn + simpson(rate, 0, u), 2 * pi), 0.0, 1e-9) << u;
  }
}

TEST(UnrollRuled, EdgeOfRegressionOfAHelixBecomesACircleOfItsCurvature) {
  const double a = 3, pitch = 1, reach = 4;
  const double speed = std::hypot(a, pitch);
  const double curvature = a / (speed * speed);
  const Development image(ruled_from(tangents_of_helix(a, pitch, reach), 0, 6, 2000), 0.0);
  for (const double u0 : {0.0, 1.1}) {
    for (const double u1 : {2.0, 4.5, 6.0}) {
      const double turn = curvature * speed * (u1 - u0);
      const double chord = 2 / curvature * std::abs(std::sin(0.5 * turn));
      const Vec2 d = image.develop({u1, -reach}) - image.develop({u0, -reach});
      EXPECT_NEAR(d.norm(), chord, 1e-9);
      const Vec2 g0 = image.jacobian({u0, 0}).col(1), g1 = image.jacobian({u1, 0}).col(1);
      EXPECT_NEAR(g0.dot(g1), std::cos(turn), 1e-10);
    }
  }
}

TEST(UnrollRuled, FoldTellsTheSidesOfTheEdgeOfRegressionApart) {
  const Development image(ruled_from(tangents_of_helix(3, 1, 4), 0, 3, 300), 0.0);
  for (const double above_edge : {1e-5, 1e-3, 0.1})
    for (const double u : {0.5, 1.501, 2.5}) {
      const Vec2 uv(u, -4 + above_edge);
      EXPECT_NEAR((image.fold(image.develop(uv)) - uv).norm(), 0.0, 1e-6) << uv.transpose();
    }
}

TEST(UnrollRuled, FoldPastTheEndGivesTheLastRuling) {
  const Development image(ruled_from(over_parabola(), 0, 1, 100), 0.0);
  EXPECT_NEAR(image.fold(image.develop({1, 0}) + Vec2(4, 2)).x(), 1.0, 0.01);
  EXPECT_NEAR(image.fold(Vec2(-4, 2)).x(), 0.0, 0.01);
  const double rounding = 1e-9;
  EXPECT_NEAR(image.fold(Vec2(-rounding, 2)).x(), -rounding, 1e-12);
}

TEST(DevelopCurveOnRuled, RulingsAreSegmentsAndAllElseIsFitted) {
  const Development image(ruled_from(cone_through_circle({1, 2, 8}, 4), 0, 5, 1000), 0.1);
  const Curve2 ruling = image.develop(Curve2(Segment{{2, -1}, {2, 7}}), 1e-6);
  ASSERT_TRUE(std::holds_alternative<Segment>(ruling));
  EXPECT_NEAR(length(ruling), 8.0, 1e-12);

  const Segment directrix{{0, 0}, {5, 0}};
  const Arc opening{{2, 3}, 1.0, 0.0, 2 * pi};
  for (const double tolerance : {1e-3, 1e-6}) {
    for (const Curve2& curve : {Curve2(directrix), Curve2(opening)}) {
      const Curve2 result = image.develop(curve, tolerance);
      for (int i = 0; i <= 300; ++i) {
        const Vec2 p = image.develop(point_at(curve, i / 300.0));
        EXPECT_LE(nearest(result, p).distance, tolerance);
      }
    }
  }
}

TEST(DevelopCurveOnRuled, ProfilesKeepTheirLength) {
  const Development image(ruled_from(cone_through_circle({1, 2, 8}, 4), 0, 2 * pi, 1000), 0.0);
  const Curve2 profile = image.develop(Curve2(Segment{{0, 0}, {2 * pi, 0}}), 1e-8);
  EXPECT_NEAR(length(profile), 8 * pi, 1e-6);
}

}  // namespace
}  // namespace planish
