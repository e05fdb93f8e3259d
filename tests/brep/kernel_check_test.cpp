#include "kernel_check.hpp"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <gtest/gtest.h>

namespace planish::test {
namespace {

/// 110 × 20 × 2 with ten holes of Ø4: faces with eleven contours.
TopoDS_Shell perforated() {
  TopoDS_Shape plate = BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), 110, 20, 2).Shape();
  for (int i = 1; i <= 10; ++i) {
    const gp_Ax2 axis(gp_Pnt(10.0 * i, 10, -1), gp::DZ());
    plate = BRepAlgoAPI_Cut(plate, BRepPrimAPI_MakeCylinder(axis, 2, 4).Shape()).Shape();
  }
  return TopoDS::Shell(TopExp_Explorer(plate, TopAbs_SHELL).Current());
}

bool is_large(const TopoDS_Shape& face) {
  int contours = 0;
  for (TopExp_Explorer each(face, TopAbs_WIRE); each.More(); each.Next())
    ++contours;
  return contours == 11;
}

/// The shell with its faces replaced; a face that becomes nothing is left out.
template <typename Edit>
TopoDS_Shell with_faces(const TopoDS_Shell& shell, Edit edit) {
  const BRep_Builder builder;
  TopoDS_Shell made;
  builder.MakeShell(made);
  for (TopoDS_Iterator each(shell); each.More(); each.Next())
    if (const TopoDS_Shape face = edit(each.Value()); !face.IsNull()) builder.Add(made, face);
  return made;
}

TEST(KernelCheck, TakesClosedShellsWithFewAndManyContours) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(30, 20, 2).Shape();
  EXPECT_TRUE(brep::is_sound(TopoDS::Shell(TopExp_Explorer(box, TopAbs_SHELL).Current())));
  EXPECT_TRUE(brep::is_sound(perforated()));
  EXPECT_TRUE(brep::is_sound(with_faces(perforated(), [](const TopoDS_Shape& f) { return f; })));
}

TEST(KernelCheck, RefusesAShellThatIsOpen) {
  EXPECT_FALSE(brep::is_sound(with_faces(perforated(), [](const TopoDS_Shape& face) {
    return is_large(face) ? TopoDS_Shape() : face;
  })));
}

TEST(KernelCheck, RefusesAFaceThatLooksInwards) {
  EXPECT_FALSE(brep::is_sound(with_faces(perforated(), [](const TopoDS_Shape& face) {
    return is_large(face) ? face : face.Reversed();
  })));
}

TEST(KernelCheck, RefusesAContourThatIsOpenAmongMany) {
  // The outer contour without its last edge; its edge is missing from no other face.
  const auto opened = [](const TopoDS_Shape& face) {
    if (!is_large(face)) return face;
    const BRep_Builder builder;
    TopoDS_Shape copy = face.EmptyCopied().Oriented(TopAbs_FORWARD);
    for (TopoDS_Iterator wires(face, false, false); wires.More(); wires.Next()) {
      TopoDS_Shape wire = wires.Value().EmptyCopied().Oriented(TopAbs_FORWARD);
      int left = 3;  // of four
      for (TopoDS_Iterator edges(wires.Value(), false, false); edges.More(); edges.Next())
        if (left-- > 0) builder.Add(wire, edges.Value());
      builder.Add(copy, wire.Oriented(wires.Value().Orientation()));
    }
    return TopoDS_Shape(copy.Oriented(face.Orientation()));
  };
  EXPECT_FALSE(brep::is_sound(with_faces(perforated(), opened)));
}

}  // namespace
}  // namespace planish::test
