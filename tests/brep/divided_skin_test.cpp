#include "divided_skin.hpp"

#include "support/bent_bracket.hpp"
#include "support/unfolded_shape.hpp"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <gtest/gtest.h>

#include <numbers>
#include <vector>

// Plates of 3 mm and brackets with grooves that are milled half through from edge to edge, on one
// skin or on both: the blank is whole, and the grooves are drawn.

namespace planish::test {
namespace {

using std::numbers::pi;

constexpr double kThickness = 3.0;

enum class Cut { square, pointed };

struct Groove {
  double x, depth;
  bool above;
};

/// Across the whole width, 2 mm wide at the skin.
TopoDS_Shape tool(const Groove& of, Cut cut) {
  const double skin = of.above ? kThickness : 0.0, out = of.above ? 1.0 : -1.0;
  const auto at = [&](double dx, double dz) { return gp_Pnt(of.x + dx, -1, skin + out * dz); };
  BRepBuilderAPI_MakePolygon outline;
  if (cut == Cut::pointed) {
    for (const gp_Pnt& p : {at(0, -of.depth), at(2, of.depth), at(-2, of.depth)})
      outline.Add(p);
  } else {
    for (const gp_Pnt& p : {at(-1, -of.depth), at(1, -of.depth), at(1, 0.5), at(-1, 0.5)})
      outline.Add(p);
  }
  outline.Close();
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), gp_Vec(0, 62, 0))
      .Shape();
}

TopoDS_Shape grooved(TopoDS_Shape part, const std::vector<Groove>& grooves, Cut cut) {
  for (const Groove& groove : grooves)
    part = BRepAlgoAPI_Cut(part, tool(groove, cut)).Shape();
  return part;
}

void expect_whole(const TopoDS_Shape& part, double area, int openings) {
  const auto seen = unfolded_shape(part);
  ASSERT_TRUE(seen) << seen.error().message;
  EXPECT_NEAR(seen->sheet.thickness, kThickness, 1e-9);
  EXPECT_NEAR(seen->flat.area, area, 1e-6);
  EXPECT_EQ(std::ssize(seen->flat.openings), openings);
  EXPECT_EQ(seen->certificate.openings.lost(), 0);
  EXPECT_NEAR(seen->certificate.explained_ratio.value_or(0.0), 1.0, 1e-9);
  ASSERT_FALSE(seen->flat.features.empty());
  for (const auto& feature : seen->flat.features)
    EXPECT_EQ(feature.kind, "pocket");
}

const std::vector<std::vector<Groove>> kGrooves{
    {{25, 1.5, true}},
    {{25, 1.5, true}, {50, 1.5, true}, {75, 1.5, true}},
    {{20, 1.4, true}, {35, 1.4, false}, {50, 1.4, true}, {65, 1.4, false}, {80, 1.4, true}},
    {{25, 1.2, true}, {25, 1.2, false}, {70, 1.4, false}}};

TEST(DividedSkins, AreWholeBlanks) {
  for (const auto& grooves : kGrooves)
    for (const Cut cut : {Cut::square, Cut::pointed})
      expect_whole(grooved(BRepPrimAPI_MakeBox(100, 60, kThickness).Shape(), grooves, cut), 6000,
                   0);
}

TEST(DividedSkins, HaveTheHolesOfTheirPieces) {
  for (const auto& grooves : kGrooves) {
    TopoDS_Shape part = grooved(BRepPrimAPI_MakeBox(100, 60, kThickness).Shape(), grooves,
                                Cut::square);
    for (const double x : {10.0, 27.0, 43.0, 58.0, 90.0}) {
      const gp_Ax2 axis(gp_Pnt(x, 30, -1), gp_Dir(0, 0, 1));
      part = BRepAlgoAPI_Cut(part, BRepPrimAPI_MakeCylinder(axis, 3, 5).Shape());
    }
    expect_whole(part, 6000 - 5 * 9 * pi, 5);
  }
}

TEST(DividedSkins, MayBeBent) {
  const TopoDS_Shape bracket = bent_bracket({kThickness, 3, 90, 30, 60});
  for (const auto& grooves : kGrooves)
    expect_whole(grooved(bracket, grooves, Cut::square), 60 * (90 + 30 + 4.5 * pi / 2), 0);
}

TEST(DividedSkins, AreReadAlongTheSkinThatIsWhole) {
  // Recesses outside leave a corner of the flange between an edge and the bend, and the largest
  // skin is that one; inside a recess reaches the other edge.
  TopoDS_Shape part = bent_bracket({kThickness, 3, 60, 30, 60});
  for (const auto& [from, to] : {std::pair{gp_Pnt(48, -1, -1), gp_Pnt(52, 14, 1.2)},
                                 {gp_Pnt(50, 10, -1), gp_Pnt(61, 14, 1.2)},
                                 {gp_Pnt(10, 50, 1.8), gp_Pnt(30, 61, 4)}})
    part = BRepAlgoAPI_Cut(part, BRepPrimAPI_MakeBox(from, to).Shape()).Shape();
  expect_whole(part, 60 * (60 + 30 + 4.5 * pi / 2), 0);
}

TEST(DividedSkins, OnBothSkinsBesideABendHaveNoOutline) {
  // A corner of the flange hangs on the bend alone, on each skin one.
  TopoDS_Shape part = bent_bracket({kThickness, 3, 60, 30, 60});
  for (const auto& [from, to] : {std::pair{gp_Pnt(48, -1, -1), gp_Pnt(52, 14, 1.2)},
                                 {gp_Pnt(50, 10, -1), gp_Pnt(61, 14, 1.2)},
                                 {gp_Pnt(48, 46, 1.8), gp_Pnt(52, 61, 4)},
                                 {gp_Pnt(50, 46, 1.8), gp_Pnt(61, 50, 4)}})
    part = BRepAlgoAPI_Cut(part, BRepPrimAPI_MakeBox(from, to).Shape()).Shape();
  const auto seen = unfolded_shape(part);
  ASSERT_FALSE(seen);
  EXPECT_EQ(seen.error().code, code::unsupported_shape) << seen.error().message;
  EXPECT_EQ(seen.error().places.size(), 2);
}

}  // namespace
}  // namespace planish::test
