#include "ruling_range.hpp"

#include "border_curve.hpp"
#include "support/sheets.hpp"

#include <Geom2d_Ellipse.hxx>
#include <Geom2d_Line.hxx>
#include <gtest/gtest.h>

#include <cmath>

namespace planish::brep {
namespace {

const Face& bend_of(const Sheet& sheet) { return sheet[sheet.bends.front().faces.front()]; }

TEST(ParameterBox, IsThatOfCurvesNotOfTheirEnds) {
  Face face;
  face.surface = Frame{};
  const double half = 1.0, end = 5 + 6 * std::sin(half);
  face.loops = {
      {{Segment{{1, end}, {1, 5 - 6 * std::sin(half)}}},
       {Segment{{1, 5 - 6 * std::sin(half)}, {5 + 6 * std::cos(half), 5 - 6 * std::sin(half)}}},
       {Arc{{5, 5}, 6, -half, 2 * half}},
       {Segment{{5 + 6 * std::cos(half), end}, {1, end}}}}};
  const Box2 box = parameter_box(face);
  EXPECT_NEAR((box.lo - Vec2(1, 5 - 6 * std::sin(half))).norm(), 0.0, 1e-9);
  EXPECT_NEAR((box.hi - Vec2(11, end)).norm(), 0.0, 1e-9) << "the arc bulges";
}

TEST(SpeedAcross, IsTheRadiusAtThatDepth) {
  using planish::test::as_ruled;
  // Of a cylinder at K the radius; u is its azimuth.
  for (const Sheet& sheet : {planish::test::l_bracket(), planish::test::l_bracket_down()}) {
    const Face& plain = bend_of(sheet);
    const double radius = std::get<Cylinder>(std::get<Developable>(plain.surface)).radius;
    const Sheet ruled = as_ruled(sheet, Angle::degrees(1));
    const Face& face = bend_of(ruled);
    const Box2 box = parameter_box(face);
    for (const double depth : {0.0, 1.0, 2.0})
      EXPECT_NEAR(speed_across(face, {box.lo.x() + 0.4 * box.size().x(), 7.0}, depth),
                  radius - plain.sense * depth, 1e-4);
  }
  // Of a cone v sin ω, less the depth's cosine; the ruled surface counts v from the nearer end.
  const Sheet cone = planish::test::truncated_cone(20, 40, 50, Angle::degrees(300), 1.5);
  const Face& plain = bend_of(cone);
  const double near = parameter_box(plain).lo.y();
  const double half = std::get<Cone>(std::get<Developable>(plain.surface)).half_angle;
  const Sheet ruled = as_ruled(cone, Angle::degrees(3));
  for (const double v : {0.0, 20.0, 50.0})
    for (const double depth : {0.0, 1.5})
      EXPECT_NEAR(speed_across(bend_of(ruled), {1.0, v}, depth),
                  (near + v) * std::sin(half) - plain.sense * depth * std::cos(half), 1e-4);
}

/// A triangle of a cone whose apex is at v = −30, given as a ruled surface of which v = 0 is 30
/// from it: its lower corner is so near the apex that the rectangle of its (u, v) would reach
/// beyond.
Face narrow_face(double lower) {
  const Cone cone{Frame{}, 0.5};
  Ruled ruled;
  for (int i = 0; i <= 60; ++i) {
    const double u = i / 60.0, h = 1e-6;
    const auto b = [&](double t) { return point_on(cone, {t, 30 * (1 + 0.5 * t)}); };
    const auto g = [&](double t) { return ruling_on(cone, t); };
    ruled.knots.push_back(
        {u, b(u), (b(u + h) - b(u - h)) / (2 * h), g(u), (g(u + h) - g(u - h)) / (2 * h)});
  }
  Face face;
  face.surface = Developable(ruled);
  // At u = 0 the apex is at v = −30, at u = 1 at v = −45.
  face.loops = {{{Segment{{0, -20}, {1, -lower}}},
                 {Segment{{1, -lower}, {1, 10}}},
                 {Segment{{1, 10}, {0, 10}}},
                 {Segment{{0, 10}, {0, -20}}}}};
  return face;
}

TEST(RulingRange, IsTheExtentWhereNothingNarrows) {
  const Sheet ruled = planish::test::as_ruled(planish::test::l_bracket(), Angle::degrees(5));
  const RulingRange range = ruling_range(bend_of(ruled), 0.0);
  const Box2 box = parameter_box(bend_of(ruled));
  EXPECT_TRUE(range.constant());
  for (const double u : {box.lo.x(), (box.lo.x() + box.hi.x()) / 2}) {
    EXPECT_EQ(range.lo(u), box.lo.y());
    EXPECT_EQ(range.hi(u), box.hi.y());
  }
  EXPECT_TRUE(ruling_range(narrow_face(20), 0.0).constant());
}

TEST(RulingRange, HoldsTheFaceAndStaysClearOfTheEdgeOfRegression) {
  const Face face = narrow_face(40);
  const RulingRange range = ruling_range(face, 0.0);
  ASSERT_FALSE(range.constant()) << "the box reaches to v = −40, and at u = 0 the apex is at −30";
  for (int i = 0; i <= 50; ++i) {
    const double u = i / 50.0;
    const double border = -20 - 20 * u;  // the lower one
    EXPECT_LE(range.lo(u), border);
    EXPECT_GT(range.lo(u), -30 * (1 + 0.5 * u)) << "the apex";
    EXPECT_GT(speed_across(face, {u, range.lo(u)}, 0.0), 0.0);
    EXPECT_EQ(range.hi(u), 10.0);
  }
}

TEST(NodePolynomial, NearsAnalyticFunctionsGeometricallyWithItsNodes) {
  const auto runge = [](double u) { return 1.0 / (1.0 + 25.0 * u * u); };
  // Analytic within the ellipse about −1 and 1 whose half axes add up to 1.2, and below 6.3 there.
  constexpr double kAxes = 1.2, kLargest = 6.3;
  for (const int nodes : {9, 33, 129}) {
    const NodePolynomial polynomial(runge, -1.0, 1.0, nodes);
    for (int i = 0; i <= 200; ++i) {
      const double u = -1.0 + 0.01 * i;
      EXPECT_NEAR(polynomial(u), runge(u), 4 * kLargest * std::pow(kAxes, 1 - nodes) / (kAxes - 1));
    }
  }
}

/// The oblique cone over half a circle about (150, 0), of radius 100, from the apex at 200 above
/// the origin, and a border at which one thousandth of it is left on every ruling.
TEST(RulingRange, StaysBetweenBorderAndApexOnAnObliqueCone) {
  const Vec3 apex(0, 0, 200);
  const auto base = [](double u) -> Vec3 {
    return {150 + 100 * std::cos(u), 100 * std::sin(u), 0};
  };
  const auto far = [&](double u) { return (base(u) - apex).norm(); };
  Ruled ruled;
  for (int i = 0; i <= 200; ++i) {
    const double u = 3.1 * i / 200;
    const Vec3 slope(-100 * std::sin(u), 100 * std::cos(u), 0), g = (base(u) - apex) / far(u);
    ruled.knots.push_back({u, base(u), slope, g, (slope - g * g.dot(slope)) / far(u)});
  }
  Face face;
  face.surface = Developable(ruled);
  constexpr double kLeft = 1e-3;
  BorderLoop loop{{Segment{{3.1, 0}, {0, 0}}}};
  const auto border = [&](double u) { return Vec2(u, -(1.0 - kLeft) * far(u)); };
  loop.push_back({Segment{{0, 0}, border(0)}});
  for (int i = 0; i < 200; ++i)
    loop.push_back({Segment{border(3.1 * i / 200), border(3.1 * (i + 1) / 200)}});
  loop.push_back({Segment{border(3.1), {3.1, 0}}});
  face.loops = {loop};
  const RulingRange range = ruling_range(face, 0.0);
  ASSERT_FALSE(range.constant());
  for (int i = 0; i <= 300; ++i) {
    const double u = 3.1 * i / 300;
    EXPECT_LT(range.lo(u), border(u).y());
    EXPECT_GT(range.lo(u), -(1.0 - 0.4 * kLeft) * far(u)) << "near the apex";
  }
}

TEST(CarriedInto, GivesEachPointItsShareOfItsRuling) {
  const Face face = narrow_face(40);
  const RulingRange range = ruling_range(face, 0.0);
  const Box2 box = range.box();
  for (const auto& [a, b] : {std::pair{Vec2(0, -20), Vec2(1, -40)},
                             {Vec2(1, -40), Vec2(1, 10)},
                             {Vec2(1, 5), Vec2(0, 2)}}) {
    const Vec2 d = b - a;
    const Handle(Geom2d_Curve)
        line = new Geom2d_Line(gp_Pnt2d(a.x(), a.y()), gp_Dir2d(d.x(), d.y()));
    const auto carried = carried_into(range, line, d.norm(), 1e-7);
    for (const double share : {0.0, 0.3, 0.8, 1.0}) {
      const Vec2 uv = a + share * d;
      const double v = box.lo.y() + box.size().y() * (uv.y() - range.lo(uv.x())) /
                                        (range.hi(uv.x()) - range.lo(uv.x()));
      const gp_Pnt2d p = carried->Value(share * d.norm());
      EXPECT_NEAR(p.X(), uv.x(), 1e-6);
      EXPECT_NEAR(p.Y(), v, 1e-5);
    }
  }
}

TEST(CarriedInto, HoldsTheToleranceAcrossTheRulingsToo) {
  // An ellipse of ± 0.4 in u, which is 20 mm of a box 50 high, and ± 2 in v.
  const Face face = narrow_face(40);
  const RulingRange range = ruling_range(face, 0.0);
  const Box2 box = range.box();
  const double scale = box.size().y() / box.size().x();
  const Handle(Geom2d_Curve)
      ellipse = new Geom2d_Ellipse(gp_Ax2d(gp_Pnt2d(0.5, 4), gp_Dir2d(0, 1)), 2.0, 0.4);
  constexpr double kTolerance = 1e-4;
  const auto carried = carried_into(range, ellipse, 3.0, kTolerance);
  for (int i = 0; i <= 300; ++i) {
    const double s = i / 100.0;
    const gp_Pnt2d uv = ellipse->Value(s), p = carried->Value(s);
    const double v = box.lo.y() + box.size().y() * (uv.Y() - range.lo(uv.X())) /
                                      (range.hi(uv.X()) - range.lo(uv.X()));
    EXPECT_NEAR(scale * p.X(), scale * uv.X(), 2 * kTolerance);
    EXPECT_NEAR(p.Y(), v, 2 * kTolerance);
  }
}

}  // namespace
}  // namespace planish::brep
