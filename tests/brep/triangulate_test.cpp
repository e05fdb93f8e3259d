#include "triangulate.hpp"

#include "kernel_points.hpp"

#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Tool.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

namespace planish::brep {
namespace {

/// How many corners the circle of a cylinder is given.
size_t corners_round(double radius, double chord, Angle turn) {
  const TopoDS_Shape shape = BRepPrimAPI_MakeCylinder(radius, 10).Shape();
  triangulate(shape, chord, turn);
  std::set<long> angles;
  for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next()) {
    TopLoc_Location place;
    const auto mesh = BRep_Tool::Triangulation(TopoDS::Face(faces.Current()), place);
    EXPECT_FALSE(mesh.IsNull());
    for (int i = 1; !mesh.IsNull() && i <= mesh->NbNodes(); ++i) {
      const Vec3 p = vector_of(mesh->Node(i));
      if (std::abs(p.z()) < 1e-9) angles.insert(std::lround(1e6 * std::atan2(p.y(), p.x())));
    }
  }
  return angles.size();
}

TEST(Triangulate, TurnsAtMostSoMuchFromChordToChord) {
  EXPECT_GE(corners_round(10, 5.0, Angle::degrees(10)), 36u);
  EXPECT_LE(corners_round(10, 5.0, Angle::degrees(10)), 76u);
  EXPECT_GE(corners_round(0.05, 5.0, Angle::degrees(30)), 12u);
  EXPECT_LE(corners_round(0.05, 5.0, Angle::degrees(30)), 28u);
}

TEST(Triangulate, StaysWithinTheChord) {
  // The sagitta of n chords is r (1 − cos(π/n)).
  for (const double chord : {0.1, 0.01}) {
    const double n = std::numbers::pi / std::acos(1 - chord / 100);
    const auto corners = static_cast<double>(corners_round(100, chord, Angle::degrees(60)));
    EXPECT_GE(corners, std::floor(n));
    EXPECT_LE(corners, 2 * n);
  }
}

}  // namespace
}  // namespace planish::brep
