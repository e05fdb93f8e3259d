#include "support/unfolded_shape.hpp"

#include <planish/sheet/codes.hpp>

#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Tool.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gmock/gmock.h>
#include <gp_Ax1.hxx>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

// Parts as shops draw them: recesses on one side and counterbores on the other, beads and louvres
// with sharp edges, boxes notched along a corner, gussets, strips as narrow as a bar.

namespace planish::test {
namespace {

using std::numbers::pi;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

TopoDS_Shape cuboid(const gp_Pnt& corner, double x, double y, double z) {
  return BRepPrimAPI_MakeBox(corner, x, y, z).Shape();
}
TopoDS_Shape cuboid(double x, double y, double z) { return cuboid({0, 0, 0}, x, y, z); }

TopoDS_Shape cut(const TopoDS_Shape& shape, const TopoDS_Shape& tool) {
  return BRepAlgoAPI_Cut(shape, tool).Shape();
}

TopoDS_Shape fused(const TopoDS_Shape& shape, const TopoDS_Shape& other) {
  ShapeUpgrade_UnifySameDomain whole(BRepAlgoAPI_Fuse(shape, other).Shape());
  whole.Build();
  return whole.Shape();
}

TopoDS_Shape pin(double x, double y, double z, double radius, double height) {
  return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(x, y, z), gp_Dir(0, 0, 1)), radius, height).Shape();
}

/// Edges both of whose ends satisfy the test are rounded.
TopoDS_Shape rounded(const TopoDS_Shape& shape, double radius,
                     const std::function<bool(const gp_Pnt&)>& at) {
  BRepFilletAPI_MakeFillet fillet(shape);
  for (TopExp_Explorer it(shape, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge edge = TopoDS::Edge(it.Current());
    if (at(BRep_Tool::Pnt(TopExp::FirstVertex(edge))) &&
        at(BRep_Tool::Pnt(TopExp::LastVertex(edge))))
      fillet.Add(radius, edge);
  }
  return fillet.Shape();
}

UnfoldedShape seen_in(const TopoDS_Shape& shape, const RecognizeOptions& options = {}) {
  auto made = unfolded_shape(shape, options);
  EXPECT_TRUE(made) << made.error().message;
  return made ? std::move(*made) : UnfoldedShape{};
}

TopoDS_Shape with_recesses(TopoDS_Shape plate, double depth) {
  for (const double x : {8.0, 38.0, 68.0})
    plate = cut(plate, cuboid({x, 10, 0}, 20, 15, depth));
  return plate;
}

TopoDS_Shape with_counterbores(TopoDS_Shape plate, double depth) {
  for (const double x : {15.0, 37.0, 59.0, 81.0})
    plate = cut(cut(plate, pin(x, 55, -1, 3, 10)), pin(x, 55, 2 - depth, 6, 10));
  return plate;
}

TEST(ShopParts, PlatesMayHaveRecessesBelowAndCounterboresAbove) {
  const TopoDS_Shape plate = cuboid(100, 80, 2);
  for (const TopoDS_Shape& part : {with_recesses(plate, 0.3), with_counterbores(plate, 1),
                                   with_counterbores(with_recesses(plate, 0.3), 1)}) {
    const UnfoldedShape seen = seen_in(part);
    EXPECT_NEAR(seen.sheet.thickness, 2.0, 1e-9);
    EXPECT_NEAR(seen.flat.area + pi * 9 * static_cast<double>(seen.flat.openings.size()), 8000,
                1e-6);
    EXPECT_NEAR(*seen.certificate.explained_ratio, 1.0, 1e-9);
  }
}

TEST(ShopParts, HolesThatShareARecessAreCutAsWhatPassesEach) {
  const TopoDS_Shape plate = cuboid(100, 80, 2);
  // A recess below all four bores, one above and below, and bores whose counterbores run together.
  const TopoDS_Shape below = with_counterbores(cut(plate, cuboid({5, 45, 0}, 90, 20, 0.1)), 1);
  TopoDS_Shape both = plate, joined = plate;
  for (const double x : {35.0, 50.0, 65.0})
    both = cut(both, pin(x, 55, -1, 3, 10));
  both = cut(cut(both, cuboid({25, 45, 0}, 50, 20, 0.4)), cuboid({25, 45, 1.6}, 50, 20, 1));
  for (const double x : {40.0, 51.0})
    joined = cut(cut(joined, pin(x, 55, -1, 3, 10)), pin(x, 55, 1.2, 6, 10));
  joined = cut(joined, cuboid({30, 45, 0}, 40, 20, 0.3));
  for (const auto& [part, holes] :
       {std::pair{below, 4}, std::pair{both, 3}, std::pair{joined, 2}}) {
    const UnfoldedShape seen = seen_in(part);
    ASSERT_EQ(std::ssize(seen.flat.openings), holes);
    EXPECT_NEAR(seen.flat.area, 8000 - holes * pi * 9, 1e-6);
    EXPECT_NEAR(*seen.certificate.explained_ratio, 1.0, 1e-9);
    EXPECT_EQ(seen.certificate.openings.lost(), 0);
  }
}

TEST(ShopParts, GroovesAllRoundAreNoOpenings) {
  // For a seal, about a hole; and a letter O, on either skin.
  for (const double below : {0.0, 1.0}) {
    const TopoDS_Shape ring = cut(pin(50, 40, below == 0.0 ? 0 : 2 - 0.5, 20, 0.5),
                                  pin(50, 40, -1, 16, 10));
    for (const int holes : {0, 1}) {
      TopoDS_Shape part = cut(cuboid(100, 80, 2), ring);
      if (holes > 0) part = cut(part, pin(50, 40, -1, 5, 10));
      const UnfoldedShape seen = seen_in(part);
      EXPECT_EQ(std::ssize(seen.flat.openings), holes);
      EXPECT_EQ(seen.certificate.openings.lost(), 0);
      EXPECT_NEAR(seen.flat.area, 8000 - holes * pi * 25, 1e-6);
    }
  }
}

/// Half a tube along x of 50 mm, with quarters of a ball at its ends.
TopoDS_Shape capsule(double radius) {
  const gp_Ax2 along(gp_Pnt(25, 30, 0), gp_Dir(1, 0, 0));
  TopoDS_Shape whole = BRepPrimAPI_MakeCylinder(along, radius, 50).Shape();
  for (const double x : {25.0, 75.0})
    whole = BRepAlgoAPI_Fuse(whole, BRepPrimAPI_MakeSphere(gp_Pnt(x, 30, 0), radius).Shape())
                .Shape();
  return BRepAlgoAPI_Common(whole, cuboid(100, 60, 20)).Shape();
}

TEST(ShopParts, BeadsAndLouvresWithSharpEdgesAreForms) {
  // Pressed up from a plate of 1 mm.
  const TopoDS_Shape pressed = cut(fused(cuboid(100, 60, 1), capsule(5)), capsule(4));
  // The half of the bead below y = 30 is cut off, and the plate there stays.
  const TopoDS_Shape louvre = fused(cut(pressed, cuboid({10, 10, -5}, 80, 20, 20)),
                                    cuboid(100, 30, 1));
  for (const TopoDS_Shape& part : {pressed, louvre}) {
    const UnfoldedShape seen = seen_in(part);
    EXPECT_NEAR(seen.sheet.thickness, 1.0, 1e-9);
    EXPECT_EQ(seen.sheet.flanges.size(), 1u);
    EXPECT_EQ(seen.sheet.bends.size(), 0u);
    ASSERT_EQ(seen.flat.features.size(), 1u);
    EXPECT_EQ(seen.flat.features[0].kind, "formed");
    EXPECT_NEAR(seen.flat.area, 6000, 1e-6) << "nothing is cut away";
    EXPECT_EQ(seen.certificate.openings.lost(), 0);
  }
}

constexpr double kWall = 1.5;

/// Open at the top, bent up along its bottom edges, sharp along its upright ones, with windows at
/// the lower corners and six holes.
TopoDS_Shape box() {
  const auto at_bottom = [](double z) {
    return [z](const gp_Pnt& p) { return std::abs(p.Z() - z) < 1e-9; };
  };
  const TopoDS_Shape outside = rounded(cuboid(80, 60, 30), 2 + kWall, at_bottom(0));
  const TopoDS_Shape inside = rounded(
      cuboid({kWall, kWall, kWall}, 80 - 2 * kWall, 60 - 2 * kWall, 30), 2, at_bottom(kWall));
  TopoDS_Shape part = cut(outside, inside);
  for (const double x : {0.0, 76.0})
    for (const double y : {0.0, 56.0})
      part = cut(part, cuboid({x, y, 0}, 4, 4, 4));
  for (int i = 0; i < 6; ++i)
    part = cut(part, pin(15 + 10 * i, 30, -1, 3, 10));
  return part;
}

TEST(ShopParts, BoxesMayTouchAtCornersThatAreNotchedOutside) {
  TopoDS_Shape part = box();
  for (const double x : {0.0, 80.0 - 0.6 * kWall})
    part = cut(part, cuboid({x, 0, 0}, 0.6 * kWall, 0.6 * kWall, 30));
  const auto closed = recognized_shape(part);
  ASSERT_FALSE(closed);
  EXPECT_EQ(closed.error().code, code::closed_loop) << "at the two other corners";
  std::vector<int> rips;
  for (const Place& place : closed.error().places)
    if (place.kind == PlaceKind::edge) rips.push_back(std::get<int>(place.id));
  const UnfoldedShape seen = seen_in(part, {.rip_edges = rips});
  EXPECT_EQ(seen.flat.openings.size(), 6u);
  EXPECT_EQ(seen.certificate.openings.lost(), 0);
  EXPECT_EQ(seen.certificate.openings.features, 2) << "where the walls touch";
}

/// 60 and 40 long, 50 wide, of 2 mm with an inside radius of 3.
TopoDS_Shape angle() {
  const auto along_y = [](double x, double z) {
    return [x, z](const gp_Pnt& p) { return std::hypot(p.X() - x, p.Z() - z) < 1e-9; };
  };
  return cut(rounded(cuboid(60, 50, 40), 5, along_y(0, 0)),
             rounded(cuboid({2, 0, 2}, 60, 50, 40), 3, along_y(2, 2)));
}

/// A triangle in the corner of the angle, this wide, 2 mm thick, in the middle of its length.
TopoDS_Shape gusset(double leg) {
  BRepBuilderAPI_MakePolygon triangle(gp_Pnt(1, 24, 1), gp_Pnt(2 + leg, 24, 1),
                                      gp_Pnt(1, 24, 2 + leg), true);
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(triangle.Wire()).Face(), gp_Vec(0, 2, 0))
      .Shape();
}

TEST(ShopParts, GussetAcrossABendIsAnotherPlate) {
  EXPECT_EQ(seen_in(angle()).sheet.bends.size(), 1u);
  for (const double leg : {7.0, 12.0, 20.0}) {
    const auto found = recognized_shape(fused(angle(), gusset(leg)));
    ASSERT_FALSE(found) << leg;
    EXPECT_EQ(found.error().code, code::not_a_sheet);
    EXPECT_THAT(found.error().message, HasSubstr("beyond the sheet of 2 mm"));
  }
}

/// A strip of 5 mm bent to an L, this wide.
TopoDS_Shape strip(double width) {
  const auto along_y = [](double x, double z) {
    return [x, z](const gp_Pnt& p) { return std::hypot(p.X() - x, p.Z() - z) < 1e-9; };
  };
  return cut(rounded(cuboid(70, width, 50), 11, along_y(0, 0)),
             rounded(cuboid({5, 0, 5}, 70, width, 50), 6, along_y(5, 5)));
}

TEST(ShopParts, StripsAsNarrowAsABarAreSheetsOfTheThicknessThatIsStated) {
  const auto bar = recognized_shape(strip(4));
  ASSERT_FALSE(bar);
  EXPECT_EQ(bar.error().code, code::not_a_sheet);
  std::vector<std::string> offered;
  for (const Remedy& remedy : bar.error().remedies)
    if (remedy.option == "thickness") offered.push_back(remedy.value);
  EXPECT_THAT(offered, ElementsAre("4", "5"));
  const UnfoldedShape bent = seen_in(strip(4), {.thickness = 5.0}),
                      flat = seen_in(strip(4), {.thickness = 4.0});
  EXPECT_EQ(bent.sheet.bends.size(), 1u);
  EXPECT_NEAR(bent.flat.area, 4 * (59 + 39 + pi / 2 * 8.5), 1e-6);
  EXPECT_EQ(flat.sheet.bends.size(), 0u);
  EXPECT_NEAR(flat.flat.area * 4, bent.flat.area * 5, 1e-6) << "of one volume";
  EXPECT_EQ(seen_in(strip(3), {.thickness = 5.0}).sheet.bends.size(), 1u);
  EXPECT_FALSE(recognized_shape(strip(4), {.thickness = 7.0}));
}

/// A tray folded sharply, 80 × 60 inside, its walls apart by gaps at the corners: from `from` to
/// `to` along the longer side, from the inside of the shorter walls.
TopoDS_Shape gapped_tray(double t, double high, double from, double to) {
  TopoDS_Shape tray = cut(cuboid({-t, -t, 0}, 80 + 2 * t, 60 + 2 * t, high),
                          cuboid({0, 0, t}, 80, 60, high));
  for (const double y : {-t, 60.0}) {
    tray = cut(tray, cuboid({from, y, t}, to - from, t, high));
    tray = cut(tray, cuboid({80 - to, y, t}, to - from, t, high));
  }
  return tray;
}

TEST(ShopParts, WallsKeepTheirEndsWhereAGapThinsThem) {
  // The gap lies partly in the wall whose end it parts from the next one. What is left there is
  // beside the fold, as high as the wall, and is cut with it. The floor of the gap goes with the
  // base.
  for (const double t : {1.0, 1.5, 3.0})
    for (const double from : {0.0, -0.04 * t, -0.3 * t}) {
      const double to = 0.1, high = 25, wall = high - t;
      const UnfoldedShape seen = seen_in(gapped_tray(t, high, from, to));
      const bool thinned = from < 0;
      const double ends = 60 + 2 * t, sides = 80 - 2 * to;
      const double folds = 2 * sides + 2 * (thinned ? 60 : ends);
      const double floors = 4 * t * (thinned ? to - from : to);
      EXPECT_NEAR(seen.flat.area, 80 * 60 + floors + 2 * wall * (ends + sides) + folds * pi / 4 * t,
                  1e-6)
          << t << ", " << from;
    }
}

/// A channel along x, its base 60 × 60 between the tangent lines, its walls longer by `beyond` at
/// both ends.
TopoDS_Shape channel(double t, double inside, double high, double beyond) {
  const double outside = inside + t;
  TopoDS_Shape body = cuboid({0, -outside, 0}, 60, 60 + 2 * outside, high),
               room = cuboid({-1, -inside, t}, 62, 60 + 2 * inside, high);
  for (const bool far : {false, true}) {
    const auto along = [far](double from, double z) {
      return [=](const gp_Pnt& p) {
        return std::abs(p.Y() - (far ? 60 + from : -from)) < 1e-6 && std::abs(p.Z() - z) < 1e-6;
      };
    };
    body = rounded(body, outside, along(outside, 0));
    room = rounded(room, inside, along(inside, t));
  }
  TopoDS_Shape whole = cut(body, room);
  for (const double x : {-beyond, 60.0})
    for (const double y : {-outside, 60 + inside})
      whole = fused(whole, cuboid({x, y, outside}, beyond, t, high - outside));
  return whole;
}

TEST(ShopParts, WallsMayTouchAlongAnEdge) {
  // The end of a wall that is flush with a skin of the next one is no ledge of that.
  for (const double t : {1.0, 2.0})
    for (const double inside : {0.5, 2.0}) {
      const TopoDS_Shape along = channel(t, inside, 25, inside);
      gp_Trsf turn;
      turn.SetRotation(gp_Ax1(gp_Pnt(30, 30, 0), gp_Dir(0, 0, 1)), pi / 2);
      const TopoDS_Shape across = BRepBuilderAPI_Transform(along, turn).Shape();
      const UnfoldedShape seen = seen_in(fused(along, across));
      EXPECT_EQ(seen.flat.bends.size(), 4u);
      EXPECT_NEAR(
          seen.flat.area,
          60 * 60 + 4 * 60 * pi / 2 * (inside + t / 2) + 4 * (60 + 2 * inside) * (25 - inside - t),
          1e-6)
          << t << ", " << inside;
    }
}

TEST(ShopParts, BlocksAreToldTheirWidth) {
  const auto cube = recognized_shape(cuboid(40, 40, 40));
  ASSERT_FALSE(cube);
  EXPECT_THAT(cube.error().message, HasSubstr("40 mm thick and only about 40 mm wide"));
}

}  // namespace
}  // namespace planish::test
