#include "side_wall.hpp"

#include "kernel_points.hpp"
#include "support/sheets.hpp"

#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <gp_Pln.hxx>
#include <gtest/gtest.h>

#include <numbers>

namespace planish::brep {
namespace {

using std::numbers::pi;

Depths depths_of(double thickness, double reference_depth = 0.0) {
  Sheet sheet;
  sheet.thickness = thickness;
  sheet.reference_depth = reference_depth;
  return Depths(sheet);
}

Face walled_face(const std::variant<Frame, Developable>& surface, int sense = 1) {
  Face face;
  face.surface = surface;
  face.sense = sense;
  return face;
}

Frame slanted_frame() { return frame_from_axes({5, -3, 8}, {1, 2, 2}, {2, -1, 0}); }

/// The wall's surface runs through the border at both depths, where its four curves say.
void expect_through_border(const Face& face, const BorderCurve& border, const Depths& depths,
                           const CurvedWall& made) {
  const SideWall& wall = made.wall;
  const auto at = [&](const Handle(Geom2d_Curve) & curve, double s) {
    const gp_Pnt2d uv = curve->Value(s);
    return vector_of(wall.surface->Value(uv.X(), uv.Y()));
  };
  for (const double share : {0.0, 0.3, 0.5, 1.0}) {
    const double s = share * border.length;
    const Vec3 first = point_below(face, border.at(s), depths.first);
    const Vec3 second = point_below(face, border.at(s), depths.second);
    EXPECT_NEAR((at(wall.on_reference, s) - first).norm(), 0.0, 1e-5);
    EXPECT_NEAR((at(wall.on_other, s) - second).norm(), 0.0, 1e-5);
    if (!made.reference_edge.IsNull()) {
      EXPECT_NEAR((vector_of(made.reference_edge->Value(s)) - first).norm(), 0.0, 1e-5);
      EXPECT_NEAR((vector_of(made.other_edge->Value(s)) - second).norm(), 0.0, 1e-5);
    }
  }
  const double across = depths.between();
  for (const double share : {0.0, 0.4, 1.0}) {
    const double depth = depths.first + share * across;
    const Vec3 start = point_below(face, border.at(0), depth);
    const Vec3 end = point_below(face, border.at(border.length), depth);
    EXPECT_NEAR((at(wall.at_start, share * across) - start).norm(), 0.0, 1e-5);
    EXPECT_NEAR((at(wall.at_end, share * across) - end).norm(), 0.0, 1e-5);
  }
  EXPECT_NEAR((vector_of(wall.surface->Value(wall.middle.x(), wall.middle.y())) -
               point_below(face, border.at(border.length / 2), depths.first))
                  .norm(),
              0.0, 1e-5);
}

TEST(Depths, AreThoseOfBothSkinsBelowTheReference) {
  EXPECT_EQ(depths_of(2).first, 0.0);
  EXPECT_EQ(depths_of(2).second, 2.0);
  EXPECT_EQ(depths_of(2, 0.5).first, -0.5);
  EXPECT_EQ(depths_of(2, 0.5).second, 1.5);
  EXPECT_EQ(depths_of(2, 0.5).between(), 2.0);
}

TEST(OutwardAcross, IsToTheRightOfTheBorderSeenFromOutside) {
  const Face plane = walled_face(slanted_frame());
  const Frame& frame = std::get<Frame>(plane.surface);
  const BorderCurve line = border_curve(plane, Segment{{0, 0}, {10, 0}}, 1e-6);
  EXPECT_NEAR((outward_across(plane, line, 5) + frame.y).norm(), 0.0, 1e-9);
  // Counter-clockwise about a disc: away from its centre.
  const BorderCurve circle = border_curve(plane, Arc{{0, 0}, 5, 0, 2 * pi}, 1e-6);
  EXPECT_NEAR((outward_across(plane, circle, pi / 2) - frame.y).norm(), 0.0, 1e-9);
  for (const int sense : {1, -1}) {
    const Face cylinder = walled_face(Developable(Cylinder{frame, 5}), sense);
    const BorderCurve round = border_curve(cylinder, Segment{{0, 20}, {1, 20}}, 1e-6);
    EXPECT_NEAR((outward_across(cylinder, round, 0.5) + sense * frame.z).norm(), 0.0, 1e-6);
  }
}

TEST(CurvedWall, OfAHoleIsACylinderRoundIt) {
  const Face plane = walled_face(slanted_frame());
  for (const double sweep : {2.0, -2.0, 2 * pi})
    for (const Depths& depths : {depths_of(2), depths_of(2, 0.5)}) {
      const BorderCurve border = border_curve(plane, Arc{{3, 1}, 5, 0.2, sweep}, 1e-6);
      const CurvedWall made = curved_wall(plane, border, depths, 1e-7);
      const auto cylinder = Handle(Geom_CylindricalSurface)::DownCast(made.wall.surface);
      ASSERT_FALSE(cylinder.IsNull());
      EXPECT_NEAR(cylinder->Radius(), 5, 1e-12);
      expect_through_border(plane, border, depths, made);
    }
}

TEST(CurvedWall, OfACircleOnACylinderIsAPlane) {
  const Face face = walled_face(Developable(Cylinder{slanted_frame(), 5}));
  const BorderCurve border = border_curve(face, Segment{{0.2, 20}, {1.7, 20}}, 1e-6);
  const CurvedWall made = curved_wall(face, border, depths_of(2), 1e-7);
  const auto plane = Handle(Geom_Plane)::DownCast(made.wall.surface);
  ASSERT_FALSE(plane.IsNull());
  const Frame frame = slanted_frame();
  EXPECT_NEAR((vector_of(plane->Pln().Axis().Direction().XYZ()) + frame.z).norm(), 0.0, 1e-6);
  EXPECT_NEAR((vector_of(plane->Location()) - frame.origin).dot(frame.z), 20, 1e-9);
}

TEST(CurvedWall, OfACircleOnAConeIsTheConeOfItsNormals) {
  for (const int sense : {1, -1})
    for (const double sweep : {1.5, -1.5}) {
      const Face face = walled_face(Developable(Cone{slanted_frame(), pi / 6}), sense);
      const BorderCurve border = border_curve(face, Segment{{0.2, 40}, {0.2 + sweep, 40}}, 1e-6);
      const CurvedWall made = curved_wall(face, border, depths_of(2), 1e-7);
      const auto cone = Handle(Geom_ConicalSurface)::DownCast(made.wall.surface);
      ASSERT_FALSE(cone.IsNull());
      EXPECT_NEAR(cone->SemiAngle(), pi / 3, 1e-9) << "normals stand across the rulings";
      expect_through_border(face, border, depths_of(2), made);
    }
}

TEST(CurvedWall, OfOtherBordersRunsThroughBothSkins) {
  const CubicSpline spline{{{0, 10}, {1, 11}, {2, 11}, {3, 10}}};
  const Face plane = walled_face(slanted_frame());
  const BorderCurve planar = border_curve(plane, spline, 1e-6);
  const CurvedWall extruded = curved_wall(plane, planar, depths_of(2), 1e-7);
  EXPECT_TRUE(extruded.reference_edge.IsNull());
  expect_through_border(plane, planar, depths_of(2), extruded);
  for (const int sense : {1, -1}) {
    const Face face = walled_face(Developable(Cylinder{slanted_frame(), 5}), sense);
    for (const Curve2& curve : {Curve2(spline), Curve2(Segment{{0.2, 10}, {1.2, 20}})}) {
      const BorderCurve border = border_curve(face, curve, 1e-6);
      const CurvedWall made = curved_wall(face, border, depths_of(2, 0.5), 1e-7);
      EXPECT_FALSE(made.reference_edge.IsNull());
      expect_through_border(face, border, depths_of(2, 0.5), made);
    }
  }
}

TEST(StraightWall, IsThePlaneOfItsCornersThatLooksOut) {
  const std::array<Vec3, 4> corners{Vec3{0, 0, 0}, {10, 0, 0}, {0, 0, -2}, {11, 0, -2}};
  for (const double side : {1.0, -1.0}) {
    const SideWall wall = straight_wall(corners, {0, side, 0}, 1e-6);
    const auto plane = Handle(Geom_Plane)::DownCast(wall.surface);
    ASSERT_FALSE(plane.IsNull());
    EXPECT_NEAR((vector_of(plane->Pln().Axis().Direction().XYZ()) - Vec3(0, side, 0)).norm(), 0.0,
                1e-12);
    EXPECT_TRUE(wall.on_reference.IsNull());
    EXPECT_NEAR((wall.outward - Vec3(0, side, 0)).norm(), 0.0, 1e-12);
  }
}

TEST(StraightWall, IsRuledWhereMitresTwistIt) {
  for (int moved = 0; moved < 4; ++moved) {
    std::array<Vec3, 4> corners{Vec3{0, 0, 0}, {10, 0, 0}, {0, 0, -2}, {10, 0, -2}};
    corners[moved].y() += 0.5;
    const SideWall wall = straight_wall(corners, {0, 1, 0}, 1e-6);
    ASSERT_TRUE(Handle(Geom_Plane)::DownCast(wall.surface).IsNull());
    const auto ends = [&](const Handle(Geom2d_Curve) & curve, const Vec3& from, const Vec3& to) {
      for (const double share : {0.0, 0.3, 1.0}) {
        const gp_Pnt2d uv = curve->Value(share * (to - from).norm());
        EXPECT_NEAR(
            (vector_of(wall.surface->Value(uv.X(), uv.Y())) - ((1 - share) * from + share * to))
                .norm(),
            0.0, 1e-9);
      }
    };
    ends(wall.on_reference, corners[0], corners[1]);
    ends(wall.on_other, corners[2], corners[3]);
    ends(wall.at_start, corners[0], corners[2]);
    ends(wall.at_end, corners[1], corners[3]);
    EXPECT_NEAR((vector_of(wall.surface->Value(wall.middle.x(), wall.middle.y())) -
                 (corners[0] + corners[1]) / 2)
                    .norm(),
                0.0, 1e-9);
    std::array<Vec3, 4> hardly{Vec3{0, 0, 0}, {10, 0, 0}, {0, 0, -2}, {10, 0, -2}};
    hardly[moved].y() += 1e-7;
    EXPECT_FALSE(
        Handle(Geom_Plane)::DownCast(straight_wall(hardly, {0, 1, 0}, 1e-6).surface).IsNull());
  }
}

}  // namespace
}  // namespace planish::brep
