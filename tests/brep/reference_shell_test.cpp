#include "reference_shell.hpp"

#include "support/error_data.hpp"
#include "support/sheets.hpp"

#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <gtest/gtest.h>

#include <numbers>
#include <utility>

namespace planish::brep {
namespace {

using planish::test::Crease;
using planish::test::Straight;
using planish::test::strip;
using std::numbers::pi;

double area_of_shell(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(shape, properties, 1e-9);
  return properties.Mass();
}

int parts_of(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  TopTools_IndexedMapOfShape found;
  TopExp::MapShapes(shape, kind, found);
  return found.Extent();
}

Sheet three_plates() {
  return strip({Straight{30}, Crease{Angle::degrees(60), BendDirection::up}, Straight{20},
                Crease{Angle::degrees(25), BendDirection::down}, Straight{10}},
               15, 1.5);
}

TEST(ReferenceShell, HasTheAreaAndTheEdgesOfTheSheet) {
  const TopoDS_Shape bracket = reference_shell(planish::test::l_bracket()).value();
  EXPECT_NEAR(area_of_shell(bracket), 40 * (80 + 3 * pi / 2), 1e-6);
  EXPECT_EQ(parts_of(bracket, TopAbs_FACE), 3);
  EXPECT_EQ(parts_of(bracket, TopAbs_EDGE), 10);
  EXPECT_EQ(parts_of(bracket, TopAbs_VERTEX), 8);
  EXPECT_EQ(bracket.ShapeType(), TopAbs_SHELL);
  EXPECT_NEAR(area_of_shell(reference_shell(planish::test::ring(40, 15, 3)).value()),
              pi * (1600 - 225), 1e-6);
}

TEST(ReferenceShell, LeavesJointsOpenThatGapeMoreThanTheTolerance) {
  Sheet sheet = three_plates();
  auto& frame = std::get<Frame>(sheet.faces.back().surface);
  frame.origin += 0.01 * frame.z;
  ReferenceShellOptions options;
  const TopoDS_Shape open = reference_shell(sheet, options).value();
  EXPECT_EQ(open.ShapeType(), TopAbs_COMPOUND);
  EXPECT_EQ(parts_of(open, TopAbs_SHELL), 2);
  EXPECT_EQ(parts_of(open, TopAbs_EDGE), 11);
  options.joint_tolerance = 0.02;
  const TopoDS_Shape closed = reference_shell(sheet, options).value();
  EXPECT_EQ(closed.ShapeType(), TopAbs_SHELL);
  EXPECT_EQ(parts_of(closed, TopAbs_EDGE), 10);
}

TEST(ReferenceShell, SeesAGapAtOneEndOfAJoint) {
  // The last plate turned about one end of its joint, in the plane across it: 0.01 at the other.
  for (const bool about_start : {true, false}) {
    Sheet sheet = three_plates();
    const BorderRef& ref = sheet.joints.back().b;
    const Curve2& border = sheet[ref].curve;
    Vec3 pivot = skin_point(sheet[ref.face], start_of(border));
    Vec3 other = skin_point(sheet[ref.face], end_of(border));
    if (!about_start) std::swap(pivot, other);
    auto& frame = std::get<Frame>(sheet.faces[ref.face].surface);
    const Vec3 axis = frame.z.cross(other - pivot).normalized();
    const Eigen::AngleAxisd turn(0.01 / (other - pivot).norm(), axis);
    frame.origin = pivot + turn * (frame.origin - pivot);
    for (Vec3* along : {&frame.x, &frame.y, &frame.z})
      *along = turn * *along;
    EXPECT_EQ(parts_of(reference_shell(sheet).value(), TopAbs_SHELL), 2);
  }
}

TEST(ReferenceShell, IsOneShellForEachConnectedPart) {
  Sheet sheet = planish::test::l_bracket();
  sheet.joints.clear();
  EXPECT_EQ(parts_of(reference_shell(sheet).value(), TopAbs_SHELL), 3);
}

TEST(ReferenceShell, RefusesABendWithoutRadius) {
  const auto shell = reference_shell(
      strip({Straight{40}, planish::test::Turn{Angle::degrees(90), 5e-8, BendDirection::up},
             Straight{30}},
            25, 2));
  ASSERT_FALSE(shell);
  EXPECT_EQ(shell.error().code, code::unsupported_shape);
  EXPECT_FALSE(reference_shell(Sheet{}));
}

}  // namespace
}  // namespace planish::brep
