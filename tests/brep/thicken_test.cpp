#include "thicken.hpp"

#include "guarded.hpp"
#include "support/error_data.hpp"
#include "support/sheets.hpp"

#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace planish::brep {
namespace {

using planish::test::ConeJoint;
using planish::test::Crease;
using planish::test::l_bracket;
using planish::test::Straight;
using planish::test::strip;
using planish::test::Turn;
using std::numbers::pi;

double volume_of_solid(const Sheet& sheet) {
  const auto solid = guarded([&] { return thicken(sheet); });
  if (!solid) {
    ADD_FAILURE() << solid.error().message;
    return 0.0;
  }
  GProp_GProps properties;
  BRepGProp::VolumePropertiesGK(*solid, properties, 1e-9);
  return properties.Mass();
}

int count_of(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  TopTools_IndexedMapOfShape found;
  TopExp::MapShapes(shape, kind, found);
  return found.Extent();
}

TEST(Thicken, HoldsTheMaterialOfItsNeutralSurface) {
  // A layer of thickness t about a radius r holds α (r + t/2) t a millimetre of width.
  EXPECT_NEAR(volume_of_solid(l_bracket()), 40 * 2 * (80 + pi / 2 * 4), 1e-4);
  EXPECT_NEAR(volume_of_solid(planish::test::l_bracket_down()), 40 * 2 * (80 + pi / 2 * 4), 1e-4);
  EXPECT_NEAR(volume_of_solid(planish::test::u_channel()), 25 * 1.5 * (100 + pi * 2.75), 1e-4);
  EXPECT_NEAR(volume_of_solid(planish::test::ring(40, 15, 3)), 3 * pi * (1600 - 225), 1e-4);
  // Both cones of a frustum have their surface at the middle: the area there times the thickness.
  const double w = std::atan2(20, 50);
  EXPECT_NEAR(volume_of_solid(planish::test::truncated_cone(20, 40, 50, Angle::degrees(300), 1.5)),
              1.5 * (pi * 300 / 360) * std::hypot(20, 50) * (20 + 40 - 2 * 0.75 * std::cos(w)),
              1e-3);
}

TEST(Thicken, MitresSharpFolds) {
  // Each side of a fold loses, or gains, a triangle of t² tan(α/2) / 2.
  for (const double degrees : {30.0, 60.0, 90.0, 120.0})
    for (const BendDirection direction : {BendDirection::up, BendDirection::down}) {
      const Sheet sheet = strip(
          {Straight{40}, Crease{Angle::degrees(degrees), direction}, Straight{30}}, 25, 2);
      const double corner = 25 * 4 * std::tan(degrees / 360 * pi);
      // Bent up, the reference skin is inside: the corner is outside the two plates.
      EXPECT_NEAR(volume_of_solid(sheet),
                  25 * 2 * 70 + (direction == BendDirection::up ? corner : -corner), 1e-6);
    }
}

TEST(Thicken, IsBuiltOfTwoSkinsAndAWallForEachFreeBorder) {
  const TopoDS_Solid bracket = thicken(l_bracket()).value();
  // Three faces on both skins; eight free borders.
  EXPECT_EQ(count_of(bracket, TopAbs_FACE), 6 + 8);
  EXPECT_EQ(count_of(bracket, TopAbs_VERTEX), 16);
  EXPECT_EQ(count_of(bracket, TopAbs_EDGE), 2 * 10 + 8) << "the skins', and those across";
  EXPECT_EQ(count_of(bracket, TopAbs_SHELL), 1);
}

TEST(Thicken, LiesOnBothSidesOfASurfaceBetweenTheSkins) {
  // The same surface as neutral surface: bends hold their length times the thickness at ½.
  for (const double depth : {0.5, 1.0}) {
    Sheet sheet = l_bracket();
    sheet.reference_depth = depth;
    const double middle = 3 + 1 - depth;  // the radius half-way through the sheet
    EXPECT_NEAR(volume_of_solid(sheet), 40 * 2 * (80 + pi / 2 * middle), 1e-4);
  }
}

TEST(Thicken, RefusesABendWithoutInsideRadius) {
  const auto sharp = thicken(strip(
      {Straight{40}, Turn{Angle::degrees(90), 5e-8, BendDirection::up}, Straight{30}}, 25, 2));
  ASSERT_FALSE(sharp);
  EXPECT_EQ(sharp.error().code, code::unsupported_shape);
  EXPECT_NEAR(planish::test::number_in(sharp.error(), "radius"), 5e-8, 1e-12);
  Sheet down = planish::test::l_bracket_down();  // 5 outside, 3 inside
  down.thickness = 5.5;
  const auto folded_over = thicken(down);
  ASSERT_FALSE(folded_over);
  EXPECT_NEAR(planish::test::number_in(folded_over.error(), "radius"), -0.5, 1e-9);
}

TEST(Thicken, RefusesABorderThatItsMitresEatUp) {
  // Between two folds of 90° inwards a plate of less than 2 t has no inside.
  const auto between = [](double length) {
    return strip({Straight{40}, Crease{Angle::degrees(90), BendDirection::down}, Straight{length},
                  Crease{Angle::degrees(90), BendDirection::down}, Straight{40}},
                 25, 2);
  };
  EXPECT_TRUE(thicken(between(4.5)));
  EXPECT_FALSE(thicken(between(3.5)));
}

}  // namespace
}  // namespace planish::brep
