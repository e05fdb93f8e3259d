#include "borders.hpp"

#include "solid_models.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace planish::brep::test {
namespace {

using std::numbers::pi;
constexpr double kTolerance = 1e-6;

/// The bend of 3 mm inside radius of a strip 40 mm wide: face 3 its outside, of radius 5.
SolidModel bent() { return prism({strip_profile(2, {{50, pi / 2, 3}, {30}})}, 40); }

BorderLoop borders_of(const SolidModel& model, int face, int loop, double u_near = 0.0) {
  return read_borders(model, model.faces[face].loops[loop], model.faces[face].surface, u_near,
                      kTolerance);
}

Box2 box_of(const BorderLoop& loop) {
  Box2 box;
  for (const Border& border : loop)
    box.add(bounds(border.curve));
  return box;
}

TEST(ReadBorders, OfAPlaneAreExactLinesAndArcs) {
  const SolidModel model = plate(2, {100, 60}, {{{30, 20}, {{5, 2}, {5, 0}}}});
  for (const Border& border : borders_of(model, 1, 0))
    EXPECT_TRUE(std::holds_alternative<Segment>(border.curve));
  const BorderLoop hole = borders_of(model, 1, 1);
  ASSERT_EQ(hole.size(), 1u);
  const Arc& circle = std::get<Arc>(hole.front().curve);
  EXPECT_NEAR(circle.radius, 5.0, 1e-12);
  EXPECT_NEAR(circle.sweep, -2 * pi, 1e-12) << "openings run clockwise";
  EXPECT_NEAR(hole.front().edge_length.value(), 10 * pi, 1e-9);
}

TEST(ReadBorders, OfACylinderAreRulingsAndParallels) {
  const SolidModel model = bent();
  const BorderLoop loop = borders_of(model, 3, 0, -pi / 4);
  ASSERT_EQ(loop.size(), 4u);
  for (const Border& border : loop) {
    const Segment& line = std::get<Segment>(border.curve);
    EXPECT_TRUE(line.a.x() == line.b.x() || line.a.y() == line.b.y());
  }
  EXPECT_NEAR(box_of(loop).size().x(), pi / 2, 1e-12);
  EXPECT_NEAR(box_of(loop).size().y(), 40.0, 1e-12);
}

TEST(ReadBorders, RunOnTheTurnNearTheOneAsked) {
  const SolidModel model = bent();
  const Box2 here = box_of(borders_of(model, 3, 0, -pi / 4));
  const Box2 there = box_of(borders_of(model, 3, 0, -pi / 4 + 6 * pi));
  EXPECT_NEAR(there.lo.x() - here.lo.x(), 6 * pi, 1e-12);
}

TEST(ReadBorders, RunBackwardsStartOnTheTurnAsked) {
  SolidModel model;
  model.edges.emplace_back().curve = arc(Frame{}, 5, 0.0, 1.9 * pi);
  const Developable cylinder = Cylinder{Frame{}, 5};
  const BorderLoop loop = read_borders(model, {{0, false}}, cylinder, 0.0, kTolerance);
  EXPECT_NEAR(start_of(loop.front().curve).x(), -0.1 * pi, 1e-12);
  EXPECT_NEAR(end_of(loop.front().curve).x(), -2 * pi, 1e-12);
}

TEST(ReadBorders, OfAnObliqueCutAreWithinTheTolerance) {
  // The plane z = x cuts the cylinder of radius 7 along z = 7 cos u.
  SpaceCurve cut;
  cut.t0 = -1.0;
  cut.t1 = 1.5;
  cut.evaluate = [](double t, Vec3& point, Vec3& derivative) {
    point = {7 * std::cos(t), 7 * std::sin(t), 7 * std::cos(t)};
    derivative = {-7 * std::sin(t), 7 * std::cos(t), -7 * std::sin(t)};
  };
  cut.start = cut.point(cut.t0);
  cut.end = cut.point(cut.t1);
  SolidModel model;
  model.edges.emplace_back().curve = cut;
  const BorderLoop loop = read_borders(model, {{0, true}}, Developable(Cylinder{Frame{}, 7}), 0.0,
                                       kTolerance);
  ASSERT_EQ(loop.size(), 1u);
  for (int i = 0; i <= 100; ++i) {
    const Vec2 p = point_at(loop.front().curve, i / 100.0);
    EXPECT_NEAR(p.y(), 7 * std::cos(p.x()), 2 * kTolerance);
  }
  EXPECT_NEAR(start_of(loop.front().curve).x(), -1.0, 1e-9);
  EXPECT_NEAR(end_of(loop.front().curve).x(), 1.5, 1e-9);
}

TEST(ShiftedU, MovesACurveAlongUAlone) {
  const Curve2 moved = shifted_u(Segment{{1, 2}, {3, 4}}, 10);
  EXPECT_NEAR((start_of(moved) - Vec2(11, 2)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((end_of(moved) - Vec2(13, 4)).norm(), 0.0, 1e-12);
}

}  // namespace
}  // namespace planish::brep::test
