#include "hull_oracle.hpp"
#include "sample_transitions.hpp"

#include <planish/sheet/flat_pattern.hpp>
#include <planish/transition/codes.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

// Transitions whose lengths and areas are known, in space and laid flat.

namespace planish::test {
namespace {

std::vector<PatchKind> kinds_of(const Transition& transition) {
  std::vector<PatchKind> kinds;
  for (const TransitionPatch& patch : transition.patches)
    kinds.push_back(patch.kind);
  return kinds;
}

long count_of(const Transition& transition, PatchKind kind) {
  const auto kinds = kinds_of(transition);
  return std::ranges::count(kinds, kind);
}

TEST(MakeTransition, MakesACylinderOfTwoEqualCircles) {
  const TransitionSpec spec = between(EllipseProfile{50, 50}, EllipseProfile{50, 50}, {0, 0, 80});
  expect_sizes(spec, 2.0 * kPi * 50 * 80, 2.0 * kPi * 50, 2.0 * kPi * 50);
  const Transition transition = made(spec);
  ASSERT_EQ(transition.patches.size(), 1u);
  EXPECT_EQ(transition.patches[0].kind, PatchKind::cylinder);
  EXPECT_NEAR(transition.patches[0].turn.radians(), 2.0 * kPi, 1e-12);
  ASSERT_EQ(transition.pieces[0].bends.size(), 1u);
  EXPECT_EQ(transition.pieces[0].bends.front().kind, BendKind::cylinder);
  const FlatPattern pattern = laid_flat(transition.pieces[0], spec);
  const Vec2 blank = blank_size(pattern);
  EXPECT_NEAR(blank.x(), 2.0 * kPi * 50, 1e-9);
  EXPECT_NEAR(blank.y(), 80.0, 1e-9);
}

TEST(MakeTransition, CallsAnObliqueCylinderOne) {
  const Transition transition = made(
      between(EllipseProfile{50, 30}, EllipseProfile{50, 30}, {20, 10, 80}));
  for (const TransitionPatch& patch : transition.patches)
    EXPECT_EQ(patch.kind, PatchKind::cylinder);
}

/// Net, area and folded piece of a roof.
Transition roof(const PolygonProfile& eaves, const PolygonProfile& top, const Vec3& apart,
                double area) {
  const TransitionSpec spec = between(eaves, top, apart);
  const Transition transition = made(spec);
  EXPECT_NEAR(transition.area, area, 1e-9 * area);
  EXPECT_NEAR(laid_flat(transition.pieces.front(), spec).area, area, 1e-9 * area);
  const auto folded = folded_pieces(spec);
  EXPECT_TRUE(folded);
  if (!folded) return transition;
  // What is cut off in its corners is as long as the sheet is thick.
  const double cut = area - laid_flat(folded->front().sheet, spec).area;
  EXPECT_GE(cut, 0.0);
  EXPECT_LT(cut, 16 * spec.thickness * spec.thickness);
  return transition;
}

TEST(MakeTransition, RoofsARectangleToARidge) {
  // 400 × 240 to a ridge of 160, 150 above: two trapezoids and two triangles.
  const double side = std::hypot(120.0, 150.0), hip = std::hypot(120.0, 150.0);
  const Transition hipped = roof(rectangle(400, 240), {{{-80, 0}, {80, 0}}}, {0, 0, 150},
                                 (400 + 160) * side + 240 * hip);
  EXPECT_EQ(count_of(hipped, PatchKind::plane), 4);
  EXPECT_EQ(hipped.patches.size(), 4u);
  EXPECT_NEAR(hipped.perimeters[1], 2 * 160, 1e-9);
  // A ridge across, or given the other way, is as good.
  roof(rectangle(400, 240), {{{80, 0}, {-80, 0}}}, {0, 0, 150}, (400 + 160) * side + 240 * hip);
  const double over = std::hypot(200.0, 150.0), short_hip = std::hypot(80.0, 150.0);
  roof(rectangle(400, 240), {{{0, 40}, {0, -40}}}, {0, 0, 150},
       (240 + 80) * over + 400 * short_hip);
}

TEST(MakeTransition, RoofsAPolygonToAnApex) {
  const double r = 100, height = 80, slant = std::hypot(r * std::cos(kPi / 6), height);
  const Transition pyramid = roof(regular_polygon(6, r), {{{0, 0}}}, {0, 0, height},
                                  6 * 0.5 * r * slant);
  EXPECT_EQ(count_of(pyramid, PatchKind::plane), 6);
  EXPECT_NEAR(pyramid.perimeters[1], 0.0, 1e-12);
}

TEST(MakeTransition, MakesAConeOfACircleAndAnApex) {
  const TransitionSpec spec = between(EllipseProfile{60, 60}, PolygonProfile{{{0, 0}}}, {0, 0, 80});
  const Transition cone = made(spec);
  ASSERT_EQ(cone.patches.size(), 1u);
  EXPECT_EQ(cone.patches[0].kind, PatchKind::cone);
  EXPECT_NEAR(cone.area, kPi * 60 * 100, 1e-8);
  EXPECT_NEAR(laid_flat(cone.pieces.front(), spec).area, kPi * 60 * 100, 1e-4);
}

TEST(MakeTransition, ClosesARoundEndToARidge) {
  // A circle to a ridge along a diameter: two half cones about its ends and two triangles; the
  // ridge's planes touch the circle where its tangents are parallel to it.
  const double r = 50, half = 30, height = 120;
  const Transition tent = made(
      between(EllipseProfile{r, r}, PolygonProfile{{{-half, 0}, {half, 0}}}, {0, 0, height}));
  EXPECT_EQ(count_of(tent, PatchKind::plane), 2);
  EXPECT_EQ(count_of(tent, PatchKind::cone), 2);
  for (const TransitionPatch& patch : tent.patches) {
    if (patch.kind != PatchKind::plane) continue;
    EXPECT_NEAR(patch.area, 0.5 * 2 * half * std::hypot(r, height), 1e-6);
  }
}

TEST(MakeTransition, RefusesARidgeAsTheFirstProfile) {
  const auto refused = make_transition(
      between(PolygonProfile{{{-80, 0}, {80, 0}}}, rectangle(400, 240), {0, 0, 150}));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, code::too_few_corners);
  EXPECT_EQ(refused.error().where, "/from/profile/polygon");
}

TEST(MakeTransition, MakesAConeFrustumBothWaysUp) {
  const double slant = std::hypot(80.0, 30.0), area = kPi * (50 + 20) * slant;
  for (const bool opens : {false, true}) {
    const double r1 = opens ? 20 : 50, r2 = opens ? 50 : 20;
    const TransitionSpec spec = between(EllipseProfile{r1, r1}, EllipseProfile{r2, r2}, {0, 0, 80});
    expect_sizes(spec, area, 2.0 * kPi * r1, 2.0 * kPi * r2);
    const Transition transition = made(spec);
    ASSERT_EQ(transition.patches.size(), 1u);
    EXPECT_NEAR(transition.patches[0].turn.radians(), 2.0 * kPi * 80 / slant, 1e-11);
    EXPECT_EQ(transition.pieces[0].bends.front().kind, BendKind::cone);
    for (const Contour& contour : {laid_flat(transition.pieces[0], spec).outer}) {
      ASSERT_EQ(contour.loop.size(), 4u);
      EXPECT_EQ(std::ranges::count_if(
                    contour.loop, [](const Curve2& c) { return std::holds_alternative<Arc>(c); }),
                2);
    }
  }
}

TEST(MakeTransition, MakesAnObliqueCylinder) {
  for (const Vec3& axis : {Vec3(30, 0, 80), Vec3(-20, 55, 60)}) {
    const TransitionSpec spec = between(EllipseProfile{50, 50}, EllipseProfile{50, 50}, axis);
    const double area = simpson(
        [&](double t) { return axis.cross(50.0 * Vec3(-std::sin(t), std::cos(t), 0.0)).norm(); }, 0,
        2 * kPi);
    expect_sizes(spec, area, 2.0 * kPi * 50, 2.0 * kPi * 50);
    // The section across the axis is an ellipse.
    EXPECT_NEAR(area / axis.norm(), ellipse_perimeter(50, 50 * axis.z() / axis.norm()),
                1e-9 * area);
  }
}

TEST(MakeTransition, MakesAnObliqueConeFrustum) {
  for (const double r2 : {20.0, 75.0}) {
    const double r1 = 50, rise = 80;
    const Vec3 second(35, -12, rise);
    const Vec3 apex = second * (r1 / (r1 - r2));
    const double area = std::abs(circle_cone_area(apex, Vec3::Zero(), r1, 0, 2 * kPi) -
                                 circle_cone_area(apex, second, r2, 0, 2 * kPi));
    expect_sizes(between(EllipseProfile{r1, r1}, EllipseProfile{r2, r2}, second), area,
                 2 * kPi * r1, 2 * kPi * r2);
  }
}

TEST(MakeTransition, MakesAPrismAndAPyramidFrustum) {
  const TransitionSpec prism = between(regular_polygon(6, 40), regular_polygon(6, 40), {0, 0, 30});
  expect_sizes(prism, 6 * 40 * 30, 240, 240);
  EXPECT_EQ(kinds_of(made(prism)), std::vector(6, PatchKind::plane));
  const TransitionSpec pyramid = between(regular_polygon(6, 40), regular_polygon(6, 25),
                                         {0, 0, 30});
  expect_sizes(pyramid, 6 * 0.5 * (40 + 25) * std::hypot(30, 15 * std::cos(kPi / 6)), 240, 150);
  const Transition transition = made(pyramid);
  EXPECT_EQ(kinds_of(transition), std::vector(6, PatchKind::plane));
  ASSERT_EQ(transition.pieces[0].joints.size(), transition.pieces[0].faces.size() - 1);
  for (const Joint& joint : transition.pieces[0].joints)
    EXPECT_TRUE(joint.sharp);
  // Between faces of slope 60°·cos: cosine of the turn is n₁ · n₂.
  const Vec3 n(30, 0, 15 * std::cos(kPi / 6));
  const Vec3 m = Eigen::AngleAxisd(kPi / 3, Vec3::UnitZ()) * n;
  for (const Bend& bend : transition.pieces[0].bends)
    EXPECT_NEAR(std::cos(bend.angle.radians()), n.dot(m) / n.squaredNorm(), 1e-12);
}

TEST(MakeTransition, MakesATwistedPrismOfTriangles) {
  TransitionSpec spec = between(rectangle(100, 100), rectangle(100, 100), {0, 0, 70});
  spec.to.frame = frame_at({0, 0, 70}, 0.0, kPi / 4);
  // Each edge leans out to the tip over its middle, 50 (√2 − 1) outside it.
  const double triangle = 0.5 * 100 * std::hypot(70, 50 * (std::sqrt(2.0) - 1.0));
  expect_sizes(spec, 8 * triangle, 400, 400);
  EXPECT_EQ(kinds_of(made(spec)), std::vector(8, PatchKind::plane));
}

TEST(MakeTransition, MakesFourTrianglesAndFourConesOfASquareToACircle) {
  for (const double radius : {30.0, 50.0, 90.0}) {
    const double rise = 80, half = 50;
    const TransitionSpec spec = between(rectangle(100, 100), EllipseProfile{radius, radius},
                                        {0, 0, rise});
    const double triangle = half * std::hypot(rise, half - radius);
    const double cone = circle_cone_area({half, half, 0}, {0, 0, rise}, radius, 0, kPi / 2);
    expect_sizes(spec, 4 * triangle + 4 * cone, 400, 2 * kPi * radius);
    const Transition transition = made(spec);
    EXPECT_EQ(count_of(transition, PatchKind::plane), 4);
    EXPECT_EQ(count_of(transition, PatchKind::cone), 4);
    for (const TransitionPatch& patch : transition.patches) {
      EXPECT_NEAR(patch.area / (patch.kind == PatchKind::plane ? triangle : cone), 1.0, 1e-9);
      EXPECT_NEAR(patch.border[1], patch.kind == PatchKind::plane ? 0.0 : 0.5 * kPi * radius,
                  1e-9 * radius);
    }
  }
}

TEST(MakeTransition, MakesTheSameOfACircleToASquare) {
  const TransitionSpec spec = between(EllipseProfile{30, 30}, rectangle(100, 100), {0, 0, 80});
  const double area = 4 * 50 * std::hypot(80, 20) +
                      4 * circle_cone_area({50, 50, 80}, Vec3::Zero(), 30, 0, kPi / 2);
  expect_sizes(spec, area, 2 * kPi * 30, 400);
}

TEST(MakeTransition, TakesTheTangentPointsOnACircleBesideTheSquare) {
  // The edge x = 50 and the circle about (20, −15) touch the plane at the point farthest towards
  // +x.
  const Vec3 centre(20, -15, 80);
  const TransitionSpec spec = between(rectangle(100, 100), EllipseProfile{30, 30}, centre);
  double area = 0.0;
  for (int i = 0; i < 4; ++i) {
    const double t = 0.5 * kPi * i;
    const Vec3 out(std::cos(t), std::sin(t), 0), touched = centre + 30 * out;
    area += 50 * std::hypot(80.0, 50 - out.dot(touched));
    const Vec3 corner = 50 * out + 50 * Vec3(-out.y(), out.x(), 0);
    area += circle_cone_area(corner, centre, 30, t, t + 0.5 * kPi);
  }
  expect_sizes(spec, area, 400, 2 * kPi * 30);
}

TEST(MakeTransition, MeasuresEllipsesByEllipticIntegrals) {
  const double rise = 60;
  // A cylinder over an ellipse.
  const double round = ellipse_perimeter(70, 30);
  expect_sizes(between(EllipseProfile{70, 30}, EllipseProfile{70, 30}, {0, 0, rise}), round * rise,
               round, round);
  // A cone over an ellipse: similar ones, apex on the axis.
  const Vec3 apex(0, 0, 2 * rise);
  const auto c = [](double t) { return Vec3(70 * std::cos(t), 30 * std::sin(t), 0); };
  const auto c_prime = [](double t) { return Vec3(-70 * std::sin(t), 30 * std::cos(t), 0); };
  const double whole = cone_area(apex, c, c_prime, 0, 2 * kPi);
  expect_sizes(between(EllipseProfile{70, 30}, EllipseProfile{35, 15}, {0, 0, rise}), 0.75 * whole,
               round, 0.5 * round);
}

TEST(MakeTransition, PairsEllipsesWhereTheirTangentsAreParallel) {
  // In parallel planes rulings join points of equal normals: r(φ) of support functions.
  const double rise = 60;
  const auto point = [](double rx, double ry, double t, double z) {
    const Vec2 n(rx * std::cos(t), ry * std::sin(t));
    return Vec3(rx * n.x() / n.norm(), ry * n.y() / n.norm(), z);
  };
  const auto h = [](double rx, double ry, double t) {
    return std::hypot(rx * std::cos(t), ry * std::sin(t));
  };
  const auto bend = [&](double rx, double ry, double t) {
    return rx * rx * ry * ry / std::pow(h(rx, ry, t), 3);
  };
  const double area = simpson(
      [&](double t) {
        const Vec3 arm = point(40, 55, t, rise) - point(70, 30, t, 0);
        const double across = std::hypot(rise, arm.dot(Vec3(std::cos(t), std::sin(t), 0)));
        return 0.5 * across * (bend(70, 30, t) + bend(40, 55, t));
      },
      0, 2 * kPi);
  const TransitionSpec spec = between(EllipseProfile{70, 30}, EllipseProfile{40, 55}, {0, 0, rise});
  expect_sizes(spec, area, ellipse_perimeter(70, 30), ellipse_perimeter(40, 55));
  EXPECT_EQ(kinds_of(made(spec)), std::vector{PatchKind::general});
}

TEST(MakeTransition, MakesRoundedRectanglesOfPlanesAndCones) {
  // A loft of straight sides and right quarter cones.
  const double rise = 60;
  const TransitionSpec spec = between(RoundedRectangleProfile{120, 80, 20},
                                      RoundedRectangleProfile{100, 60, 10}, {0, 0, rise});
  const double slant = std::hypot(rise, 10.0),
               area = 2 * (80 + 40) * slant + kPi * (20 + 10) * slant;
  expect_sizes(spec, area, 2 * (80 + 40) + 2 * kPi * 20, 2 * (80 + 40) + 2 * kPi * 10);
  const TransitionSpec straight = between(ObroundProfile{120, 40}, ObroundProfile{120, 40},
                                          {0, 0, rise});
  expect_sizes(straight, (160 + kPi * 40) * rise, 160 + kPi * 40, 160 + kPi * 40);
}

}  // namespace
}  // namespace planish::test
