#include "guarded.hpp"
#include "solid_models.hpp"
#include "step_out.hpp"
#include "thickness.hpp"

#include <planish/brep/step.hpp>
#include <planish/sheet/codes.hpp>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <gp_Ax2.hxx>
#include <gtest/gtest.h>

#include <numbers>

// Plates, frames and bars narrower than other sheets, and what looks like them and is none.

namespace planish::test {
namespace {

using std::numbers::pi;

Result<Sheet> sheet_in(const TopoDS_Shape& shape) {
  const auto text = brep::guarded([&] { return brep::step_text(shape, "part"); });
  if (!text) return tl::unexpected(text.error());
  const auto file = read_step_text(*text, "part.step");
  if (!file) return tl::unexpected(file.error());
  auto recognized = recognize(file->bodies.front());
  if (!recognized) return tl::unexpected(recognized.error());
  return std::move(recognized->sheet);
}

struct Expected {
  double thickness = 0.0;
  double area = 0.0;
};

/// The pattern at K = ½, whose area times the thickness is the solid's volume.
void expect_plate(const TopoDS_Shape& shape, const Expected& expected) {
  const auto sheet = sheet_in(shape);
  ASSERT_TRUE(sheet) << sheet.error().message;
  EXPECT_NEAR(sheet->thickness, expected.thickness, 1e-9);
  const auto flat = flatten(*sheet, {.allowance = ConstantK{0.5, "test"}});
  ASSERT_TRUE(flat) << flat.error().message;
  EXPECT_NEAR(flat->area, expected.area, 1e-6);
}

void expect_refusal(const TopoDS_Shape& shape, ErrorCode code) {
  const auto sheet = sheet_in(shape);
  ASSERT_FALSE(sheet) << "a sheet of " << sheet->thickness << " mm";
  EXPECT_EQ(sheet.error().code, code) << sheet.error().message;
}

TopoDS_Shape block_at(const gp_Pnt& corner, const gp_XYZ& size) {
  return BRepPrimAPI_MakeBox(corner, size.X(), size.Y(), size.Z()).Shape();
}

TopoDS_Shape block(double x, double y, double z) { return block_at({0, 0, 0}, {x, y, z}); }

TopoDS_Shape without(const TopoDS_Shape& shape, const TopoDS_Shape& tool) {
  return BRepAlgoAPI_Cut(shape, tool).Shape();
}

TopoDS_Shape ring_body(double outer, double inner, double height) {
  return without(
      BRepPrimAPI_MakeCylinder(outer, height).Shape(),
      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, -1), gp_Dir(0, 0, 1)), inner, height + 2)
          .Shape());
}

TopoDS_Shape frame(double x, double y, double web, double height) {
  return without(block(x, y, height),
                 block_at({web, web, -1}, {x - 2 * web, y - 2 * web, height + 2}));
}

/// Windows of 20 mm, 4 mm apart and from the rim.
TopoDS_Shape grating(int columns, int rows, double height) {
  TopoDS_Shape shape = block(4 + 24 * columns, 4 + 24 * rows, height);
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j)
      shape = without(shape, block_at({4.0 + 24 * i, 4.0 + 24 * j, -1}, {20, 20, height + 2}));
  return shape;
}

/// Two legs of 50 mm and a bend of 90° between, 10 mm inside.
TopoDS_Shape bent_bar(double thickness, double width) {
  const auto leg = [&](double x, double z, double dx, double dz) {
    return block_at({x, 0, z}, {dx, width, dz});
  };
  const double r = 10 + thickness;
  const gp_Ax2 axis(gp_Pnt(50, 0, r), gp_Dir(0, 1, 0));
  TopoDS_Shape bend = without(BRepPrimAPI_MakeCylinder(axis, r, width).Shape(),
                              BRepPrimAPI_MakeCylinder(axis, 10, width).Shape());
  bend = without(bend, leg(50 - 2 * r, -r, 2 * r, 4 * r));
  bend = without(bend, leg(0, r, 50 + 2 * r, 2 * r));
  return BRepAlgoAPI_Fuse(BRepAlgoAPI_Fuse(leg(0, 0, 50, thickness), bend).Shape(),
                          leg(60, r, thickness, 50))
      .Shape();
}

TEST(NarrowPlate, IsAGratingWithWebsNarrowerThanThick) {
  expect_plate(grating(8, 4, 5), {5.0, 196.0 * 100 - 32 * 400});
}

TEST(NarrowPlate, IsARingNarrowerThanThick) {
  expect_plate(ring_body(50, 45, 8), {8.0, pi * (50 * 50 - 45 * 45)});
}

TEST(NarrowPlate, IsARingOfSquareSection) {
  expect_plate(ring_body(50, 45, 5), {5.0, pi * (50 * 50 - 45 * 45)});
}

TEST(NarrowPlate, IsAFrameNarrowerThanThick) {
  expect_plate(frame(100, 60, 5, 8), {8.0, 100 * 60 - 90 * 50});
}

TEST(NarrowPlate, IsAGasketWithEarsAndHoles) {
  TopoDS_Shape gasket = frame(100, 60, 5, 8);
  const auto turned = [](double x, double y, double radius, double low, double height) {
    const gp_Ax2 axis(gp_Pnt(x, y, low), gp_Dir(0, 0, 1));
    return BRepPrimAPI_MakeCylinder(axis, radius, height).Shape();
  };
  // Each ear adds three quarters of its disc; the last quarter lies within the frame.
  for (const double x : {0.0, 100.0})
    for (const double y : {0.0, 60.0}) {
      gasket = BRepAlgoAPI_Fuse(gasket, turned(x, y, 5, 0, 8)).Shape();
      gasket = without(gasket, turned(x, y, 2.5, -1, 10));
    }
  expect_plate(gasket, {8.0, 100 * 60 - 90 * 50 + 4 * (0.75 * pi * 25 - pi * 6.25)});
}

TEST(NarrowPlate, IsAStripHardlyWiderThanThick) {
  expect_plate(block(100, 4, 3), {3.0, 400.0});
  expect_plate(block(100, 12, 10), {10.0, 1200.0});
}

TEST(NarrowPlate, IsABarBentOverItsFlatOrItsEdge) {
  // Over the flat the skins are 12 mm wide, and unroll. On edge, the larger skins are the L itself,
  // which is cut out of a plate.
  expect_plate(bent_bar(10, 12), {10.0, 12 * (100 + 15 * pi / 2)});
  expect_plate(bent_bar(12, 10), {10.0, 12 * 100 + pi / 4 * (22 * 22 - 10 * 10)});
}

TEST(NarrowPlate, IsNoBarOfSquareSection) {
  expect_refusal(block(200, 10, 10), code::not_a_sheet);
  expect_refusal(bent_bar(10, 10), code::not_a_sheet);
}

TEST(NarrowPlate, IsNoWire) { expect_refusal(block(40, 0.45, 0.36), code::not_a_sheet); }

TEST(NarrowPlate, IsNoBlock) {
  expect_refusal(block(30, 20, 20), code::not_a_sheet);
  expect_refusal(block(50, 40, 30), code::not_a_sheet);
  expect_refusal(block(100, 60, 40), code::not_a_sheet);
  expect_refusal(without(block(50, 40, 30), block_at({15, 15, -1}, {20, 10, 40})),
                 code::not_a_sheet);
}

TEST(NarrowPlate, IsNoTubeHoweverShort) {
  expect_refusal(ring_body(50, 48, 60), code::closed_loop);
  expect_refusal(ring_body(50, 48, 8), code::closed_loop);
  expect_refusal(frame(100, 60, 3, 200), code::closed_loop);
}

TEST(PlateThickness, IsTheDepthBelowTheLargestPlane) {
  // The inner and outer walls of this frame are larger than its skins together.
  const auto polygon = [](const std::vector<Vec2>& points) {
    Loop loop;
    for (size_t i = 0; i < points.size(); ++i)
      loop.push_back(Segment{points[i], points[(i + 1) % points.size()]});
    return loop;
  };
  const brep::SolidModel model = brep::test::prism(
      {polygon(brep::test::rectangle_at({0, 0}, {100, 60})),
       polygon(brep::test::clockwise(brep::test::rectangle_at({5, 5}, {95, 55})))},
      8);
  const auto thickness = brep::plate_thickness(model, brep::outlines_of(model));
  ASSERT_TRUE(thickness);
  EXPECT_NEAR(*thickness, 8.0, 1e-9);
}

}  // namespace
}  // namespace planish::test
