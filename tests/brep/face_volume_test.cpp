#include "face_volume.hpp"

#include "solid_reader.hpp"

#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <GProp_GProps.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Ax2.hxx>
#include <gtest/gtest.h>

#include <numbers>

// Volumes from borders against closed forms, and against the kernel's own integration over the
// faces.

namespace planish::brep {
namespace {

using std::numbers::pi;

double by_borders(const TopoDS_Shape& shape) {
  const TopExp_Explorer solids(shape, TopAbs_SOLID);
  return volume_of(read_solid(TopoDS::Solid(solids.Current()), 0.01));
}

double by_kernel(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties, 1e-10);
  return properties.Mass();
}

gp_Ax2 slanted() { return gp_Ax2(gp_Pnt(11, -7, 4), gp_Dir(1, 2, 5)); }

TEST(FaceVolume, OfCylindersAndConesAnywhere) {
  EXPECT_NEAR(by_borders(BRepPrimAPI_MakeCylinder(slanted(), 6, 20).Shape()), pi * 36 * 20,
              1e-9 * pi * 720);
  EXPECT_NEAR(by_borders(BRepPrimAPI_MakeCone(slanted(), 8, 5, 12).Shape()),
              pi / 3 * 12 * (64 + 40 + 25), 1e-9 * 1621);
  EXPECT_NEAR(by_borders(BRepPrimAPI_MakeCone(slanted(), 8, 0, 12).Shape()), pi / 3 * 12 * 64,
              1e-9 * 804);
}

TEST(FaceVolume, OfAPieceOfPipeBetweenTwoAngles) {
  const TopoDS_Shape outer = BRepPrimAPI_MakeCylinder(slanted(), 10, 30, 4.2).Shape();
  const TopoDS_Shape inner = BRepPrimAPI_MakeCylinder(slanted(), 8, 30).Shape();
  const double expected = 4.2 / 2 * (100 - 64) * 30;
  EXPECT_NEAR(by_borders(BRepAlgoAPI_Cut(outer, inner).Shape()), expected, 1e-9 * expected);
}

TEST(FaceVolume, OfEdgesThatDoNotMeetDoesNotDependOnWhereThePlaneBegins) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(slanted(), 20, 30, 5).Shape();
  const TopExp_Explorer solids(box, TopAbs_SOLID);
  SolidModel model = read_solid(TopoDS::Solid(solids.Current()), 0.01);
  // Ends miss their vertices by up to 0.01 mm, along the edges: the faces stay plane.
  constexpr double kGap = 0.01;
  for (std::size_t e = 0; e < model.edges.size(); ++e) {
    SpaceCurve& curve = model.edges[e].curve;
    curve.end -= kGap * static_cast<double>(e % 3) / 2 * (curve.end - curve.start).normalized();
  }
  double volume = 0.0;
  for (SolidFace face : model.faces) {
    const double near = volume_under(face, model);
    Frame& plane = std::get<Frame>(face.surface);
    plane.origin += 1e4 * plane.x;
    EXPECT_NEAR(volume_under(face, model), near, 1e-7);
    volume += near;
  }
  EXPECT_NEAR(volume, 20 * 30 * 5, 3 * kGap * kGap * 30);  // corners are cut off, of gap² each
}

TEST(PatchVolume, OfSpheresTorusesAndSplines) {
  const auto near = [](const TopoDS_Shape& shape, double expected) {
    EXPECT_NEAR(by_borders(shape), expected, 1e-8 * expected);
  };
  near(BRepPrimAPI_MakeSphere(slanted(), 9).Shape(), 4.0 / 3 * pi * 729);
  near(BRepPrimAPI_MakeTorus(slanted(), 12, 3).Shape(), 2 * pi * pi * 12 * 9);
  const TopoDS_Shape cone = BRepPrimAPI_MakeCone(slanted(), 8, 5, 12).Shape();
  near(BRepBuilderAPI_NurbsConvert(cone, true).Shape(), pi / 3 * 12 * (64 + 40 + 25));
}

TEST(FaceVolume, AgreesWithTheKernelWhereCutsRunAcross) {
  const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(10, 40).Shape();
  const TopoDS_Shape cone = BRepPrimAPI_MakeCone(12, 6, 40).Shape();
  const TopoDS_Shape
      tool = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(-30, 2, 15), gp_Dir(1, 0, 0.3)), 4, 60).Shape();
  const TopoDS_Shape wedge = BRepPrimAPI_MakeBox(gp_Ax2(gp_Pnt(-50, -50, 20), gp_Dir(1, 0.2, 3)),
                                                 100, 100, 100)
                                 .Shape();
  for (const TopoDS_Shape& whole : {cylinder, cone})
    for (const TopoDS_Shape& part :
         {BRepAlgoAPI_Cut(whole, tool).Shape(), BRepAlgoAPI_Cut(whole, wedge).Shape(),
          BRepAlgoAPI_Common(whole, wedge).Shape()}) {
      const double kernel = by_kernel(part);
      EXPECT_NEAR(by_borders(part), kernel, 1e-6 * kernel)
          << "as closely as the kernel's intersection curves lie on both";
    }
}

}  // namespace
}  // namespace planish::brep
