#include "threads.hpp"

#include "support/unfolded_shape.hpp"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepLib.hxx>
#include <BRepOffsetAPI_MakePipeShell.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <GCE2d_MakeSegment.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

// Threads as a designer models them: a profile along a helix, cut out of a bore. They are called
// threads, and what is cut is the core, into which they are tapped.

namespace planish::test {
namespace {

using std::numbers::pi;

struct Metric {
  double nominal, pitch;
  double core() const { return nominal - 1.0825 * pitch; }
};

gp_Ax2 upright(double z) { return {gp_Pnt(30, 20, z), gp_Dir(0, 0, 1)}; }

/// What a tap removes about (30, 20), from below a sheet to above it.
TopoDS_Shape tapped(const Metric& of, double thickness) {
  const double inner = of.core() / 2 - 0.02, outer = of.nominal / 2, low = -1.5 * of.pitch;
  const double turns = std::ceil((thickness + 3 * of.pitch) / of.pitch);
  const Handle(Geom_CylindricalSurface)
      about = new Geom_CylindricalSurface(gp_Ax3(gp::XOY()), inner);
  const Handle(Geom2d_TrimmedCurve)
      line = GCE2d_MakeSegment(gp_Pnt2d(0, 0), gp_Pnt2d(2 * pi * turns, of.pitch * turns));
  TopoDS_Edge helix = BRepBuilderAPI_MakeEdge(line, about).Edge();
  BRepLib::BuildCurves3d(helix);
  const double root = 0.43 * of.pitch, crest = of.pitch / 16;
  BRepBuilderAPI_MakePolygon profile(gp_Pnt(inner, 0, -root), gp_Pnt(outer, 0, -crest),
                                     gp_Pnt(outer, 0, crest), gp_Pnt(inner, 0, root), true);
  BRepOffsetAPI_MakePipeShell pipe(BRepBuilderAPI_MakeWire(helix).Wire());
  pipe.SetMode(true);
  pipe.Add(profile.Wire());
  pipe.Build();
  pipe.MakeSolid();
  gp_Trsf moved;
  moved.SetTranslation(gp_Vec(30, 20, low));
  TopoDS_Shape groove = BRepBuilderAPI_Transform(pipe.Shape(), moved).Shape();
  return BRepAlgoAPI_Fuse(
      BRepPrimAPI_MakeCylinder(upright(-4), of.core() / 2, thickness + 8).Shape(), groove);
}

TEST(Threads, AreDrawnAsTheirNominalCircleAndCutAsTheirCore) {
  for (const auto& [metric, thickness] : {std::pair{Metric{6, 1}, 3.0}, {Metric{8, 1.25}, 2.0}})
    for (const bool sunk : {false, true}) {
      TopoDS_Shape part = BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(60, 40, thickness).Shape(),
                                          tapped(metric, thickness));
      const double r = metric.nominal / 2 + 0.8;
      if (sunk)
        part = BRepAlgoAPI_Cut(
            part, BRepPrimAPI_MakeCone(upright(thickness - 1.2), r - 1.2, r, 1.2).Shape());
      const auto seen = unfolded_shape(part);
      ASSERT_TRUE(seen) << seen.error().message;
      EXPECT_NEAR(seen->flat.area, 2400 - pi / 4 * metric.core() * metric.core(), 1e-6);
      const auto& features = seen->flat.features;
      ASSERT_EQ(features.size(), sunk ? 2u : 1u);
      EXPECT_EQ(features.back().kind, "thread");
      ASSERT_EQ(features.back().outlines.size(), 1u);
      EXPECT_NEAR(length(features.back().outlines.front()), pi * metric.nominal, 1e-2);
      if (!sunk) continue;
      EXPECT_EQ(features.front().kind, "countersink");
      EXPECT_NEAR(length(features.front().outlines.front()), 2 * pi * r, 1e-6);
    }
}

/// Cones one above the other, as wide as the nominal diameter every pitch.
TopoDS_Shape ringed(const Metric& of, double thickness) {
  TopoDS_Shape tool = BRepPrimAPI_MakeCylinder(upright(-4), of.core() / 2, thickness + 8).Shape();
  const double depth = (of.nominal - of.core()) / 2, r = of.nominal / 2, high = 0.45 * of.pitch;
  for (double z = of.pitch / 2; z < thickness; z += of.pitch)
    for (const double up : {-1.0, 1.0})
      tool = BRepAlgoAPI_Fuse(
          tool,
          BRepPrimAPI_MakeCone(gp_Ax2(gp_Pnt(30, 20, z), gp_Dir(0, 0, up)), r, r - depth, high)
              .Shape());
  return tool;
}

TEST(Threads, MayBeModelledAsRings) {
  for (const auto& [metric, thickness] : {std::pair{Metric{6, 1}, 3.0}, {Metric{8, 1.25}, 2.5}})
    for (const double sunk : {0.0, 0.8}) {
      TopoDS_Shape part = BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(60, 40, thickness).Shape(),
                                          ringed(metric, thickness));
      const double r = metric.nominal / 2 + sunk;
      if (sunk > 0.0)
        part = BRepAlgoAPI_Cut(
            part, BRepPrimAPI_MakeCone(upright(thickness - 0.4), r - 0.4, r, 0.4).Shape());
      const auto seen = unfolded_shape(part);
      ASSERT_TRUE(seen) << seen.error().message;
      EXPECT_NEAR(seen->flat.area, 60 * 40 - pi / 4 * metric.core() * metric.core(), 1e-6);
      const auto& features = seen->flat.features;
      ASSERT_EQ(features.size(), sunk > 0.0 ? 2u : 1u);
      EXPECT_EQ(features.back().kind, "thread");
      EXPECT_NEAR(length(features.back().outlines.front()), pi * metric.nominal, 1e-9);
    }
}

TEST(Threads, AreNotSeenInTurnedHoles) {
  TopoDS_Shape part = BRepPrimAPI_MakeBox(60, 40, 3).Shape();
  for (const auto& [z, radius] : {std::pair{-1.0, 2.5}, {0.6, 3.0}, {1.6, 3.0}})
    part = BRepAlgoAPI_Cut(part,
                           BRepPrimAPI_MakeCylinder(upright(z), radius, z < 0 ? 9 : 0.6).Shape());
  const auto seen = unfolded_shape(part);
  ASSERT_TRUE(seen) << seen.error().message;
  EXPECT_NEAR(seen->flat.area, 2400 - pi * 6.25, 1e-9);
  for (const auto& feature : seen->flat.features)
    EXPECT_NE(feature.kind, "thread");
}

}  // namespace
}  // namespace planish::test
