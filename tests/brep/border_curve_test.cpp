#include "border_curve.hpp"

#include "kernel_points.hpp"
#include "support/sheets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace planish::brep {
namespace {

using std::numbers::pi;
using Shape = BorderCurve::Shape;
constexpr double kShape = 1e-6;

Frame tilted_frame() { return frame_from_axes({5, -3, 8}, {1, 2, 2}, {2, -1, 0}); }

Face face_of(const std::variant<Frame, Developable>& surface, int sense = 1) {
  Face face;
  face.surface = surface;
  face.sense = sense;
  return face;
}

Face cylinder_face(int sense = 1) {
  return face_of(Developable(Cylinder{tilted_frame(), 5}), sense);
}
Face cone_face(int sense = 1) { return face_of(Developable(Cone{tilted_frame(), pi / 6}), sense); }

TEST(PointBelow, LiesAgainstTheOutwardNormal) {
  const Frame frame = tilted_frame();
  EXPECT_NEAR((point_below(face_of(frame), {3, 4}, 2) - (frame.point({3, 4}) - 2 * frame.z)).norm(),
              0.0, 1e-12);
  const Vec3 radial = std::cos(0.7) * frame.x + std::sin(0.7) * frame.y;
  for (const int sense : {1, -1})
    EXPECT_NEAR((point_below(cylinder_face(sense), {0.7, 11}, 2) -
                 (frame.origin + (5 - sense * 2) * radial + 11 * frame.z))
                    .norm(),
                0.0, 1e-12);
}

TEST(BorderCurve, KeepsTheLengthOfALineAndTheAngleOfAnArcOnAPlane) {
  const BorderCurve line = border_curve(face_of(tilted_frame()), Segment{{1, 2}, {4, 6}}, kShape);
  EXPECT_EQ(line.shape, Shape::line);
  EXPECT_NEAR(line.length, 5, 1e-12);
  EXPECT_NEAR((line.at(2.5) - Vec2(2.5, 4)).norm(), 0.0, 1e-12);
  for (const double sweep : {2.0, -2.0}) {
    const BorderCurve arc = border_curve(face_of(tilted_frame()), Arc{{1, 2}, 3, 0.4, sweep},
                                         kShape);
    EXPECT_EQ(arc.shape, Shape::circle);
    EXPECT_NEAR(arc.length, 2.0, 1e-12);
    const double angle = 0.4 + sweep / 4;
    EXPECT_NEAR((arc.at(0.5) - Vec2(1 + 3 * std::cos(angle), 2 + 3 * std::sin(angle))).norm(), 0.0,
                1e-12);
  }
}

TEST(BorderCurve, TellsRulingsAndCirclesFromOtherCurves) {
  const auto shape = [](const Face& face, const Segment& segment) {
    return border_curve(face, segment, kShape).shape;
  };
  const Segment along{{0.3, 10}, {0.3, 40}}, round{{0.3, 20}, {1.3, 20}}, other{{0.3, 10}, {1, 20}};
  for (const Face& face : {cylinder_face(), cone_face()}) {
    EXPECT_EQ(shape(face, along), Shape::line);
    EXPECT_EQ(shape(face, round), Shape::circle);
    EXPECT_EQ(shape(face, other), Shape::general);
    EXPECT_EQ(border_curve(face, Arc{{1, 20}, 0.2, 0, 1}, kShape).shape, Shape::general);
    // Off by less, and by more, than the tolerance in space.
    EXPECT_EQ(shape(face, {{0.3, 10}, {0.3 + 1e-8, 40}}), Shape::line);
    EXPECT_EQ(shape(face, {{0.3, 10}, {0.3 + 1e-6, 40}}), Shape::general);
    EXPECT_EQ(shape(face, {{0.3, 20}, {1.3, 20 + 1e-7}}), Shape::circle);
  }
  const Sheet ruled = planish::test::as_ruled(planish::test::l_bracket(), Angle::degrees(5));
  const Face& bend = ruled[ruled.bends.front().faces.front()];
  const Box2 box = parameter_box(bend);
  const double u = (box.lo.x() + box.hi.x()) / 2;
  EXPECT_EQ(shape(bend, {{u, box.lo.y()}, {u, box.hi.y()}}), Shape::line);
  EXPECT_EQ(shape(bend, {box.lo, {box.hi.x(), box.lo.y()}}), Shape::general);
}

TEST(BorderCurve, OfASplineIsPlanarOnPlanesOnly) {
  const CubicSpline spline{{{0, 10}, {1, 11}, {2, 11}, {3, 10}}};
  EXPECT_EQ(border_curve(face_of(tilted_frame()), spline, kShape).shape, Shape::planar_spline);
  EXPECT_EQ(border_curve(cylinder_face(), spline, kShape).shape, Shape::general);
}

TEST(CircleBelow, IsRoundTheAxisOfItsSurface) {
  const Frame frame = tilted_frame();
  for (const int sense : {1, -1})
    for (const double turn : {1.0, -1.0}) {
      const Segment border{{0.3, 20}, {0.3 + turn, 20}};
      const Face cylinder = cylinder_face(sense);
      const SpaceCircle on_cylinder = circle_below(cylinder, border_curve(cylinder, border, kShape),
                                                   2);
      EXPECT_NEAR(on_cylinder.radius, 5 - sense * 2, 1e-12);
      EXPECT_NEAR((on_cylinder.center - (frame.origin + 20 * frame.z)).norm(), 0.0, 1e-12);
      EXPECT_NEAR((on_cylinder.axis - turn * frame.z).norm(), 0.0, 1e-12);
      // A cone's normal rises by the cosine of its half-angle outwards, falls by its sine.
      const Face cone = cone_face(sense);
      const SpaceCircle on_cone = circle_below(cone, border_curve(cone, border, kShape), 2);
      EXPECT_NEAR(on_cone.radius, 20 * 0.5 - sense * 2 * std::cos(pi / 6), 1e-12);
      EXPECT_NEAR((on_cone.center - frame.origin).dot(frame.z),
                  20 * std::cos(pi / 6) + sense * 2 * 0.5, 1e-12);
      EXPECT_NEAR((on_cone.axis - turn * frame.z).norm(), 0.0, 1e-12);
    }
}

TEST(SpaceCurveBelow, RunsThroughThePointsOfItsBorderAtEqualParameters) {
  const CubicSpline spline{{{0, 10}, {1, 11}, {2, 12}, {3, 10}, {4, 8}, {5, 9}, {6, 10}}};
  const std::vector<Curve2> borders{Segment{{0.3, 10}, {0.3, 40}},
                                    Segment{{0.3, 20}, {1.3, 20}},
                                    Segment{{1.3, 20}, {0.3, 20}},
                                    Segment{{0.3, 10}, {1.0, 20}},
                                    Arc{{1, 20}, 0.5, 0, 3},
                                    Arc{{1, 20}, 0.5, 3, -3},
                                    spline};
  for (const Face& face :
       {face_of(tilted_frame()), cylinder_face(), cylinder_face(-1), cone_face(), cone_face(-1)})
    for (const Curve2& curve : borders)
      for (const double depth : {0.0, 1.5}) {
        const BorderCurve border = border_curve(face, curve, kShape);
        const auto in_space = space_curve_below(face, border, depth, 1e-6);
        for (const double share : {0.0, 0.13, 0.5, 0.77, 1.0}) {
          const double s = share * border.length;
          // A ruling's points below may be as far apart along another length on a cone only.
          EXPECT_NEAR(
              (vector_of(in_space->Value(s)) - point_below(face, border.at(s), depth)).norm(), 0.0,
              3e-6);
        }
      }
}

TEST(FitTwoDepths, HoldsThePointsOfBoth) {
  const Face face = cylinder_face(-1);
  const BorderCurve border = border_curve(face, Segment{{0.3, 10}, {1.0, 20}}, kShape);
  const FittedPath path = fit_two_depths(face, border, 0.0, 2.0, 1e-7);
  for (size_t i = 0; i < path.knots.size(); ++i) {
    const Vec2 uv = border.at(path.knots[i]);
    EXPECT_NEAR((path.values[i].head<3>() - point_below(face, uv, 0.0)).norm(), 0.0, 1e-12);
    EXPECT_NEAR((path.values[i].tail<3>() - point_below(face, uv, 2.0)).norm(), 0.0, 1e-12);
  }
  EXPECT_EQ(path.knots.front(), 0.0);
  EXPECT_NEAR(path.knots.back(), border.length, 1e-15);
}

TEST(FitTwoDepths, HasAKnotWhereTheSurfaceHasOne) {
  const Sheet ruled = planish::test::as_ruled(planish::test::l_bracket(), Angle::degrees(30));
  const Face& bend = ruled[ruled.bends.front().faces.front()];
  const auto& knots = std::get<Ruled>(std::get<Developable>(bend.surface)).knots;
  const Box2 box = parameter_box(bend);
  const BorderCurve border = border_curve(bend, Segment{{box.hi.x(), 5}, {box.lo.x(), 5}}, kShape);
  const FittedPath path = fit_two_depths(bend, border, 0.0, 1.0, 10.0);
  for (const Ruled::Knot& knot : knots) {
    if (knot.u < box.lo.x() + 1e-6 || knot.u > box.hi.x() - 1e-6) continue;
    EXPECT_TRUE(std::ranges::any_of(path.knots, [&](double s) {
      return std::abs(border.at(s).x() - knot.u) < 1e-9;
    })) << knot.u;
  }
}

/// A plane that touches the cylinder along its ruling at azimuth 0, u along the ruling.
TEST(AcrossJoint, GivesTheNeighboursBorderTheLeadersParameter) {
  const Frame axes;
  const Face plane = face_of(Frame{{5, 0, 0}, Vec3::UnitZ(), Vec3::UnitY(), -Vec3::UnitX()});
  const Face cylinder = face_of(Developable(Cylinder{axes, 5}), -1);
  const BorderCurve leading = border_curve(plane, Segment{{2, 0}, {12, 0}}, kShape);
  const auto across = across_joint(plane, leading, cylinder, Segment{{0, 2}, {0, 12}}, kShape);
  ASSERT_FALSE(across.IsNull());
  for (const double s : {0.0, 3.0, 10.0})
    EXPECT_NEAR(across->Value(s).Distance(gp_Pnt2d(0, 2 + s)), 0.0, 1e-12);
  EXPECT_TRUE(across_joint(cylinder, leading, plane, Segment{{2, 0}, {12, 0}}, kShape).IsNull())
      << "planes need no curve";
}

TEST(AcrossJoint, ProjectsWhereTheNeighbourRunsAtAnotherSpeed) {
  // The same ruling, by a spline whose speed is not even.
  const Face plane = face_of(Frame{{5, 0, 0}, Vec3::UnitZ(), Vec3::UnitY(), -Vec3::UnitX()});
  const Face cylinder = face_of(Developable(Cylinder{Frame{}, 5}), -1);
  const CubicSpline uneven{{{2, 0}, {2.5, 0}, {4, 0}, {12, 0}}};
  const BorderCurve leading = border_curve(plane, uneven, kShape);
  const auto across = across_joint(plane, leading, cylinder, Segment{{0, 2}, {0, 12}}, kShape);
  for (const double share : {0.0, 0.3, 0.5, 0.9, 1.0}) {
    const double s = share * leading.length;
    EXPECT_NEAR(across->Value(s).Distance(gp_Pnt2d(0, leading.at(s).x())), 0.0, 1e-5);
  }
}

TEST(AcrossJoint, EndsWhereTheNeighboursLoopHasItsCorners) {
  // The neighbour's border begins 0.0005 late; what its projection misses there fades to the end.
  const Face plane = face_of(Frame{{5, 0, 0}, Vec3::UnitZ(), Vec3::UnitY(), -Vec3::UnitX()});
  const Face cylinder = face_of(Developable(Cylinder{Frame{}, 5}), -1);
  const CubicSpline uneven{{{2, 0}, {2.5, 0}, {3, 0}, {4, 0}, {5, 0}, {8, 0}, {12, 0}}};
  const BorderCurve leading = border_curve(plane, uneven, kShape);
  const auto across = across_joint(plane, leading, cylinder, Segment{{0, 2.0005}, {0, 12}}, kShape);
  ASSERT_FALSE(across.IsNull());
  EXPECT_NE(leading.length, 1.0);
  for (const double share : {0.0, 0.3, 0.5, 0.9, 1.0}) {
    const double s = share * leading.length, late = 0.0005 * (1.0 - share);
    EXPECT_NEAR(across->Value(s).Distance(gp_Pnt2d(0, leading.at(s).x() + late)), 0.0, 1e-5);
  }
}

}  // namespace
}  // namespace planish::brep
