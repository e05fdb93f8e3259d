#include "solid_check.hpp"
#include "support/sheets.hpp"

#include <planish/brep/step.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace planish::test {
namespace {

using brep::SolidCheck;
using std::numbers::pi;

SolidCheck surface(const Sheet& sheet) {
  const auto text = folded_surface_step(sheet, "surface");
  if (!text) {
    ADD_FAILURE() << text.error().message << " (" << text.error().where << ")";
    return {};
  }
  const auto check = brep::check_step_solid(*text);
  if (!check) ADD_FAILURE() << check.error().message;
  return check.value_or(SolidCheck{});
}

int border_count(const Sheet& sheet) {
  std::size_t count = 0;
  for (const Face& face : sheet.faces)
    for (const BorderLoop& loop : face.loops)
      count += loop.size();
  return static_cast<int>(count);
}

SolidCheck expect_one_shell(const Sheet& sheet) {
  const SolidCheck check = surface(sheet);
  EXPECT_EQ(check.solids, 0);
  EXPECT_EQ(check.shells, 1);
  EXPECT_TRUE(check.valid);
  EXPECT_EQ(check.faces, static_cast<int>(sheet.faces.size()));
  EXPECT_EQ(check.free_edges, border_count(sheet) - 2 * static_cast<int>(sheet.joints.size()));
  EXPECT_EQ(check.product, "surface");
  return check;
}

Sheet creased(double width) {
  return strip({Straight{30}, Crease{Angle::degrees(60), BendDirection::up}, Straight{20},
                Crease{Angle::degrees(25), BendDirection::down}, Straight{10}},
               width, 1.5);
}

TEST(FoldedSurface, IsOneShellWhoseFacesShareTheirEdges) {
  for (const Sheet& sheet :
       {l_bracket(), l_bracket_down(), u_channel(), z_profile(), staircase(3), box(),
        plate_with_holes(), cone_joined(), lofted_corner(), creased(15)})
    expect_one_shell(sheet);
}

TEST(FoldedSurface, HasTheAreaOfTheReferenceSkin) {
  EXPECT_NEAR(expect_one_shell(l_bracket()).area, 40 * (50 + 30 + 3 * pi / 2), 1e-6);
  EXPECT_NEAR(expect_one_shell(l_bracket_down()).area, 40 * (50 + 30 + 5 * pi / 2), 1e-6);
  EXPECT_NEAR(expect_one_shell(truncated_cone(20, 40, 50, Angle::degrees(300), 1.5)).area,
              pi * 60 * std::hypot(20, 50) * 300 / 360, 1e-6);
  const SolidCheck check = expect_one_shell(creased(15));
  EXPECT_NEAR(check.area, 15 * 60, 1e-9);
  EXPECT_EQ(check.planes, 3);
  EXPECT_EQ(check.free_edges, 8);
}

TEST(FoldedSurface, KeepsCylindersAndCones) {
  EXPECT_EQ(surface(l_bracket()).cylinders, 1);
  EXPECT_EQ(surface(truncated_cone(20, 40, 50, Angle::degrees(300), 1.5)).cones, 1);
}

TEST(FoldedSurface, LeavesAGapOpen) {
  Sheet sheet = creased(15);
  auto& frame = std::get<Frame>(sheet.faces.back().surface);
  frame.origin += 0.5 * frame.z;
  const SolidCheck check = surface(sheet);
  EXPECT_TRUE(check.valid);
  EXPECT_EQ(check.shells, 2);
  EXPECT_EQ(check.faces, 3);
  EXPECT_EQ(check.free_edges, 10);
}

TEST(FoldedSurface, RefusesASheetWithoutFaces) {
  const auto text = folded_surface_step(Sheet{}, "none");
  ASSERT_FALSE(text);
  EXPECT_EQ(text.error().code, code::invalid_input);
}

}  // namespace
}  // namespace planish::test
