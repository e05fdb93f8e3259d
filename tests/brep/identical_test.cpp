#include "identical.hpp"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>
#include <gtest/gtest.h>

#include <cmath>

namespace planish::brep {
namespace {

TopoDS_Solid solid_in(const TopoDS_Shape& shape) {
  return TopoDS::Solid(TopExp_Explorer(shape, TopAbs_SOLID).Current());
}

Fingerprint of_box(double a, double b, double c) {
  return fingerprint_of(solid_in(BRepPrimAPI_MakeBox(a, b, c).Shape()));
}

/// A block with a hole and a notch: no plane mirrors it onto itself.
TopoDS_Shape handed() {
  const gp_Ax2 axis(gp_Pnt(12, 31, -1), gp::DZ());
  const TopoDS_Shape drilled = BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(100, 60, 10).Shape(),
                                               BRepPrimAPI_MakeCylinder(axis, 5, 20).Shape());
  return BRepAlgoAPI_Cut(drilled, BRepPrimAPI_MakeBox(gp_Pnt(80, 50, 6), 30, 30, 30).Shape());
}

TopoDS_Shape moved_copy(const TopoDS_Shape& shape) {
  gp_Trsf motion, turn;
  motion.SetTranslation(gp_Vec(300, -200, 50));
  turn.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, 2, -1)), 0.8);
  return BRepBuilderAPI_Transform(shape, motion * turn, true).Shape();
}

TopoDS_Shape mirror_image(const TopoDS_Shape& shape) {
  gp_Trsf mirror;
  mirror.SetMirror(gp_Ax2(gp_Pnt(3, 4, 5), gp_Dir(1, 1, 0)));
  return BRepBuilderAPI_Transform(shape, mirror, true).Shape();
}

TEST(Fingerprint, OfABoxIsWhatItsEdgesAre) {
  // Corners count three times and middles of edges once: Σ x² is 2a²/9 of each of the 36 points.
  const Fingerprint box = of_box(3, 6, 2);
  EXPECT_EQ(box.counts, (std::array<int, 3>{6, 12, 8}));
  EXPECT_NEAR(box.moments[0], std::sqrt(2 * 49 / 9.0), 1e-12);
  EXPECT_NEAR(box.moments[1], 4 / 49.0, 1e-12);
  EXPECT_NEAR(box.moments[2], 9 / 49.0, 1e-12);
  EXPECT_NEAR(box.moments[3], 36 / 49.0, 1e-12);
  // Corners lie √49/2 away, the middles √(49 − a²)/2 and so on, four of each.
  const double fourth = (24 * 49 * 49 + 4 * (40 * 40 + 13 * 13 + 45 * 45)) / (36 * 16.0);
  EXPECT_NEAR(box.moments[4], fourth / std::pow(98 / 9.0, 2), 1e-12);
  for (int odd : {5, 6, 7})
    EXPECT_NEAR(box.moments[odd], 0.0, 1e-12) << "a box is its own image through its centre";
}

TEST(Identical, HoldsForMovedCopies) {
  EXPECT_TRUE(identical(fingerprint_of(solid_in(handed())),
                        fingerprint_of(solid_in(moved_copy(handed())))));
  EXPECT_TRUE(identical(of_box(3, 6, 2), of_box(2, 3, 6)));
}

TEST(Identical, DoesNotHoldForTheOtherHand) {
  const Fingerprint part = fingerprint_of(solid_in(handed()));
  const Fingerprint mirrored = fingerprint_of(solid_in(mirror_image(handed())));
  EXPECT_FALSE(identical(part, mirrored));
  EXPECT_NEAR(part.moments[7], -mirrored.moments[7], 1e-9);
  EXPECT_GT(std::abs(part.moments[7]), 1e-5);
  for (int i = 0; i < 7; ++i)
    EXPECT_NEAR(part.moments[i], mirrored.moments[i], 1e-9 * part.moments[0]);
  EXPECT_TRUE(identical(part, fingerprint_of(solid_in(mirror_image(mirror_image(handed()))))));
}

TEST(Identical, SeesEverySizeBeyondARounding) {
  EXPECT_FALSE(identical(of_box(3, 6, 2), of_box(3, 6, 2.001)));
  EXPECT_FALSE(identical(of_box(3, 6, 2), of_box(6, 12, 4)));
  EXPECT_TRUE(identical(of_box(3, 6, 2), of_box(3 + 1e-9, 6, 2)));
  EXPECT_FALSE(identical(of_box(10, 10, 10),
                         fingerprint_of(solid_in(BRepPrimAPI_MakeCylinder(10, 10).Shape()))));
}

TEST(Identical, ComparesEveryNumber) {
  const Fingerprint one = of_box(3, 6, 2);
  for (size_t i = 0; i < one.counts.size(); ++i) {
    Fingerprint other = one;
    ++other.counts[i];
    EXPECT_FALSE(identical(one, other));
  }
  for (size_t i = 0; i < one.moments.size(); ++i)
    for (const double change : {1e-3, -1e-3}) {
      Fingerprint other = one;
      other.moments[i] += change;
      EXPECT_FALSE(identical(one, other)) << i;
      other.moments[i] = one.moments[i] + 1e-6 * change;
      EXPECT_TRUE(identical(one, other)) << i;
    }
}

}  // namespace
}  // namespace planish::brep
