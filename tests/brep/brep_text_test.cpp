#include "brep_text.hpp"

#include "body.hpp"
#include "support/sheets.hpp"

#include <planish/brep/codes.hpp>
#include <planish/brep/step.hpp>
#include <planish/sheet/flat_pattern.hpp>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BinTools.hxx>
#include <BinTools_ShapeSet.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Pln.hxx>
#include <gp_Trsf.hxx>
#include <gtest/gtest.h>

#include <sstream>

// Shapes in the kernel's own form, as other programs built on it hand them over.

namespace planish::test {
namespace {

std::string text_of(const TopoDS_Shape& shape) {
  std::ostringstream stream;
  BRepTools::Write(shape, stream);
  return stream.str();
}

std::string binary_of(const TopoDS_Shape& shape) {
  std::ostringstream stream;
  BinTools::Write(shape, stream);
  return stream.str();
}

/// As FreeCAD writes it.
std::string freecad_binary_of(const TopoDS_Shape& shape) {
  std::ostringstream stream;
  BinTools_ShapeSet shapes;
  const int row = shapes.Add(shape);
  shapes.Write(stream);
  BinTools::PutInteger(stream, row);
  BinTools::PutInteger(stream, shapes.Locations().Index(shape.Location()));
  BinTools::PutInteger(stream, shape.Orientation());
  return stream.str();
}

TopoDS_Shape bracket() { return folded_body(l_bracket(), "bracket").value().shape().solid; }

double flat_area(const StepFile& file) {
  const auto found = recognize(file.bodies.at(0));
  EXPECT_TRUE(found) << found.error().message;
  return found ? flatten(found->sheet)->area : 0.0;
}

TEST(KernelShape, IsUnfoldedLikeTheStepFileOfIt) {
  const double area = flatten(l_bracket())->area;
  gp_Trsf away;
  away.SetTranslation(gp_Vec(0, 0, 70));
  for (const std::string& bytes :
       {text_of(bracket()), binary_of(bracket()), freecad_binary_of(bracket()),
        freecad_binary_of(bracket().Moved(away)), "DBRep_DrawableShape\n\n" + text_of(bracket())}) {
    const auto file = read_step_text(bytes, "bracket.brep");
    ASSERT_TRUE(file) << file.error().message;
    ASSERT_EQ(file->bodies.size(), 1u);
    EXPECT_EQ(file->unit, "mm");
    EXPECT_EQ(file->bodies[0].name(), "body-1");
    EXPECT_NEAR(flat_area(*file), area, 1e-6 * area);
  }
}

TEST(KernelShape, HoldsABodyInSeveralPlacesOnce) {
  TopoDS_Compound both;
  BRep_Builder builder;
  builder.MakeCompound(both);
  gp_Trsf away;
  away.SetTranslation(gp_Vec(500, 0, 0));
  const TopoDS_Shape part = bracket();
  builder.Add(both, part);
  builder.Add(both, part.Moved(away));
  const auto file = read_step_text(binary_of(both), "two.brep");
  ASSERT_TRUE(file) << file.error().message;
  ASSERT_EQ(file->bodies.size(), 1u);
  EXPECT_EQ(file->bodies[0].quantity(), 2);
}

TEST(KernelShape, WithoutASolidIsRefused) {
  const TopoDS_Shape face = BRepBuilderAPI_MakeFace(gp_Pln(), 0, 10, 0, 10).Shape();
  EXPECT_EQ(read_step_text(text_of(face), "face.brep").error().code, code::shell_not_solid);
  TopoDS_Compound nothing;
  BRep_Builder().MakeCompound(nothing);
  EXPECT_EQ(read_step_text(text_of(nothing), "nothing.brep").error().code, code::no_solid);
  gp_Trsf far;
  far.SetTranslation(gp_Vec(2e9, 0, 0));
  EXPECT_EQ(read_step_text(text_of(bracket().Moved(far)), "far.brep").error().code,
            code::too_far_away);
}

TEST(KernelShape, ThatWasCutShortIsAnError) {
  for (const std::string& whole : {text_of(bracket()), binary_of(bracket())})
    for (const double share : {0.01, 0.3, 0.6, 0.9}) {
      const auto length = static_cast<std::size_t>(share * static_cast<double>(whole.size()));
      if (length < 100) continue;
      const auto file = read_step_text(whole.substr(0, length), "cut.brep");
      EXPECT_FALSE(file) << share;
    }
}

}  // namespace
}  // namespace planish::test
