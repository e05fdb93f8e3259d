#include "support/unfolded_shape.hpp"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeHalfSpace.hxx>
#include <TopoDS.hxx>
#include <gp_Ax2.hxx>
#include <gp_Pln.hxx>
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

// Parts sawn obliquely, by a plane that is not normal to the sheet.

namespace planish::test {
namespace {

using std::numbers::pi;

/// What lies behind the plane, seen against its normal.
TopoDS_Shape sawn(const TopoDS_Shape& shape, const gp_Pnt& point, const gp_Dir& normal) {
  const TopoDS_Shape plane = BRepBuilderAPI_MakeFace(gp_Pln(point, normal)).Shape();
  const gp_Pnt before = point.Translated(gp_Vec(normal));
  const TopoDS_Shape tool = BRepPrimAPI_MakeHalfSpace(TopoDS::Face(plane), before).Shape();
  return BRepAlgoAPI_Cut(shape, tool).Shape();
}

bool is_noted(const UnfoldedShape& part) {
  return std::ranges::any_of(part.flat.features, [](const FlatFeature& feature) {
    return feature.kind == "slanted cut" && !feature.along.empty();
  });
}

TEST(SlantedCut, OfAPlateKeepsTheWiderSkin) {
  const TopoDS_Shape plate = BRepPrimAPI_MakeBox(100, 60, 6).Shape();
  const auto part = unfolded_shape(sawn(plate, {80, 0, 0}, {1, 0, 1}));
  ASSERT_TRUE(part) << part.error().message;
  EXPECT_NEAR(part->flat.area, 80 * 60, 1e-6);
  EXPECT_NEAR(*part->certificate.volume_ratio, 80.0 / 77.0, 1e-9);
  EXPECT_NEAR(*part->certificate.explained_ratio, 1.0, 1e-9);
  ASSERT_TRUE(is_noted(*part));
  ASSERT_EQ(part->flat.features.front().along.size(), 1u);
  EXPECT_NEAR(part->flat.features.front().beyond_cut.value_or(0), -6.0, 1e-9) << "6 tan 45°";
  const Box2 size = bounds(part->flat.outer.loop);
  const Vec2 place = part->flat.features.front().along.front();
  EXPECT_NEAR(std::min(place.x() - size.lo.x(), size.hi.x() - place.x()), 0.0, 1e-6);
  EXPECT_NEAR(place.y(), (size.lo.y() + size.hi.y()) / 2, 1e-6) << "the middle of the sawn edge";
}

TEST(SlantedCut, OpensToTheSideFromWhichItIsSeen) {
  // Both ends sawn along parallel planes: one is seen from above, the other from below.
  const TopoDS_Shape plate = BRepPrimAPI_MakeBox(100, 60, 6).Shape();
  const auto part = unfolded_shape(
      sawn(sawn(plate, {80, 0, 0}, {1, 0, 1}), {20, 0, 0}, {-1, 0, -1}));
  ASSERT_TRUE(part) << part.error().message;
  ASSERT_EQ(part->flat.features.size(), 2u);
  EXPECT_EQ(part->flat.features[0].side, other_side(part->flat.features[1].side));
  for (const FlatFeature& feature : part->flat.features)
    EXPECT_EQ(feature.along.size(), 1u);
}

TEST(SlantedCut, OfAStraightCutIsNone) {
  const TopoDS_Shape plate = BRepPrimAPI_MakeBox(100, 60, 6).Shape();
  const auto part = unfolded_shape(sawn(plate, {80, 0, 0}, {2, 1, 0}));
  ASSERT_TRUE(part) << part.error().message;
  EXPECT_TRUE(part->flat.features.empty());
}

/// 3 mm, legs of 40 mm along x, a web of 60 mm between bends of 3 mm inside, 200 mm along y.
TopoDS_Shape channel() {
  const auto block = [](double x, double z, double dx, double dz) {
    return BRepPrimAPI_MakeBox(gp_Pnt(x, 0, z), dx, 200, dz).Shape();
  };
  const auto quarter = [&](double z, double corner) {
    const gp_Ax2 axis(gp_Pnt(40, 0, z), gp_Dir(0, 1, 0));
    const TopoDS_Shape ring = BRepAlgoAPI_Cut(BRepPrimAPI_MakeCylinder(axis, 6, 200).Shape(),
                                              BRepPrimAPI_MakeCylinder(axis, 3, 200).Shape())
                                  .Shape();
    TopoDS_Shape bend = BRepAlgoAPI_Cut(ring, block(20, z - 20, 20, 40)).Shape();
    return BRepAlgoAPI_Cut(bend, block(20, corner, 40, 20)).Shape();
  };
  TopoDS_Shape part = block(0, 0, 40, 3);
  part = BRepAlgoAPI_Fuse(part, quarter(6, 6)).Shape();
  part = BRepAlgoAPI_Fuse(part, block(43, 6, 3, 60)).Shape();
  part = BRepAlgoAPI_Fuse(part, quarter(66, 46)).Shape();
  return BRepAlgoAPI_Fuse(part, block(0, 69, 40, 3)).Shape();
}

TEST(SlantedCut, OfAChannelFollowsOneSkinThroughItsBends) {
  // y < 150 − x: legs and web are cut at 45°, the legs normal to the sheet. On the inside skin the
  // web ends at 150 − 43, and each bend at 150 − 40 − 3 sin θ.
  const auto part = unfolded_shape(sawn(channel(), {0, 150, 0}, {1, 1, 0}));
  ASSERT_TRUE(part) << part.error().message;
  const double legs = 2 * (40 * 150 - 800);
  const double bends = 2 * 4.5 * (110 * pi / 2 - 3);
  EXPECT_NEAR(part->flat.area, legs + bends + 60 * 107, 1e-4);
  const double volume = 3 * legs + 110 * pi * 13.5 - 126 + 3 * 60 * 105.5;
  EXPECT_NEAR(*part->certificate.volume_ratio, 3 * part->flat.area / volume, 1e-9);
  // Half the difference of the skins leaves out 4.5 mm³ of the bends.
  EXPECT_NEAR(*part->certificate.explained_ratio, 1.0, 5.0 / volume);
  EXPECT_LT(*part->certificate.refold_deviation, 1e-4);
  EXPECT_TRUE(is_noted(*part));
}

TEST(SlantedCut, OfARolledSheetIsAccountedFor) {
  TopoDS_Shape tube = BRepAlgoAPI_Cut(BRepPrimAPI_MakeCylinder(30, 100).Shape(),
                                      BRepPrimAPI_MakeCylinder(27, 100).Shape())
                          .Shape();
  tube = BRepAlgoAPI_Cut(tube, BRepPrimAPI_MakeBox(gp_Pnt(0, -1, -1), 40, 2, 102).Shape()).Shape();
  const auto part = unfolded_shape(sawn(tube, {0, 0, 70}, {1, 0, 0.5}));
  ASSERT_TRUE(part) << part.error().message;
  EXPECT_TRUE(is_noted(*part));
  EXPECT_NEAR(*part->certificate.explained_ratio, 1.0, 1e-3);
}

}  // namespace
}  // namespace planish::test
