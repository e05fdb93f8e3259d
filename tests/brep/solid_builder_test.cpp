#include "solid_builder.hpp"

#include "fitted_curve.hpp"
#include "kernel_points.hpp"

#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_Circle.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Solid.hxx>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

namespace planish::brep {
namespace {

using std::numbers::pi;

Handle(Geom_Surface) plane_through(const Vec3& p, const Vec3& normal) {
  return new Geom_Plane(kernel_point(p), kernel_direction(normal));
}

double volume_in(const TopoDS_Shell& shell) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shell, properties);
  return properties.Mass();
}

/// A tetrahedron with three right angles at the origin; `turned` faces look along the opposite of
/// their plane's normal.
TopoDS_Shell tetrahedron(bool turned, double a, double b, double c) {
  SolidBuilder builder;
  const std::array<Vec3, 4> corners{Vec3{0, 0, 0}, {a, 0, 0}, {0, b, 0}, {0, 0, c}};
  std::vector<TopoDS_Vertex> vertices;
  for (const Vec3& p : corners)
    vertices.push_back(builder.vertex(p));
  std::map<std::pair<int, int>, BuiltEdge> edges;
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j)
      edges.emplace(std::pair{i, j}, builder.straight_edge(vertices[i], vertices[j]));
  for (const auto& f : {std::array{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}) {
    std::vector<EdgeUse> loop;
    for (int k = 0; k < 3; ++k) {
      const int i = f[k], j = f[(k + 1) % 3];
      loop.push_back({&edges.at(std::minmax(i, j)), {}, i < j});
    }
    const Vec3 normal = (corners[f[1]] - corners[f[0]]).cross(corners[f[2]] - corners[f[0]]);
    builder.face(plane_through(corners[f[0]], turned ? Vec3(-normal) : normal), turned ? -1 : 1,
                 {loop});
  }
  return builder.shell();
}

TEST(SolidBuilder, MakesATetrahedronWhicheverWayItsPlanesLook) {
  for (const bool turned : {false, true}) {
    const TopoDS_Shell shell = tetrahedron(turned, 3, 4, 5);
    EXPECT_TRUE(BRepCheck_Analyzer(shell).IsValid());
    EXPECT_TRUE(shell.Closed());
    EXPECT_NEAR(volume_in(shell), 10, 1e-9);
  }
}

TEST(SolidBuilder, MakesStraightEdgesOfTheirLength) {
  SolidBuilder builder;
  const BuiltEdge edge = builder.straight_edge(builder.vertex({1, 2, 3}),
                                               builder.vertex({4, 6, 3}));
  EXPECT_NEAR(edge.length, 5, 1e-12);
  EXPECT_NEAR(edge.curve->Value(2.5).Distance(gp_Pnt(2.5, 4, 3)), 0.0, 1e-12);
  double from = -1, to = -1;
  BRep_Tool::Range(edge.edge, from, to);
  EXPECT_EQ(from, 0.0);
  EXPECT_NEAR(to, 5, 1e-12);
}

TEST(SolidBuilder, MakesAWallWithASeam) {
  SolidBuilder builder;
  const double r = 5, h = 8;
  const TopoDS_Vertex low = builder.vertex({r, 0, 0}), high = builder.vertex({r, 0, h});
  const auto ring = [&](double z) -> Handle(Geom_Curve) {
    return new Geom_Circle(kernel_axes({0, 0, z}, Vec3::UnitZ(), Vec3::UnitX()), r);
  };
  const BuiltEdge bottom = builder.edge(ring(0), 2 * pi, low, low);
  const BuiltEdge top = builder.edge(ring(h), 2 * pi, high, high);
  const BuiltEdge seam = builder.straight_edge(low, high);
  const auto uv = [](double u, double v, double du, double dv) -> Handle(Geom2d_Curve) {
    return new Geom2d_Line(gp_Pnt2d(u, v), gp_Dir2d(du, dv));
  };
  builder.face(new Geom_CylindricalSurface(kernel_frame(Frame{}), r), 1,
               {{{&bottom, uv(0, 0, 1, 0), true},
                 {&seam, uv(2 * pi, 0, 0, 1), true},
                 {&top, uv(0, h, 1, 0), false},
                 {&seam, uv(0, 0, 0, 1), false}}});
  builder.face(plane_through(Vec3::Zero(), Vec3::UnitZ()), -1, {{{&bottom, {}, false}}});
  builder.face(plane_through({0, 0, h}, Vec3::UnitZ()), 1, {{{&top, {}, true}}});
  const TopoDS_Shell shell = builder.shell();
  EXPECT_TRUE(BRepCheck_Analyzer(shell).IsValid());
  EXPECT_NEAR(volume_in(shell), 25 * pi * h, 1e-6);
  for (TopExp_Explorer wires(shell, TopAbs_WIRE); wires.More(); wires.Next())
    EXPECT_TRUE(wires.Current().Closed());
}

TEST(SolidBuilder, CoversWithTolerancesHowFarCurvesAreFromSurfaces) {
  // A line 0.002 above its plane at one end, and a vertex 0.01 from the line's end.
  SolidBuilder builder;
  const TopoDS_Vertex a = builder.vertex({0, 0, 0}), b = builder.vertex({10, 0.01, 0}),
                      c = builder.vertex({0, 10, 0});
  const Vec3 along = Vec3(10, 0, 0.002);
  const BuiltEdge edge = builder.edge(new Geom_Line(gp_Pnt(0, 0, 0), kernel_direction(along)),
                                      along.norm(), a, b);
  EXPECT_NEAR(BRep_Tool::Tolerance(a), 1e-7, 1e-12);
  const double gap = std::hypot(0.01, 0.002);
  EXPECT_NEAR(BRep_Tool::Tolerance(b), 1.5 * gap, 1e-9);
  const BuiltEdge back = builder.straight_edge(b, c), close = builder.straight_edge(c, a);
  builder.face(plane_through(Vec3::Zero(), Vec3::UnitZ()), 1,
               {{{&edge, {}, true}, {&back, {}, true}, {&close, {}, true}}});
  EXPECT_NEAR(BRep_Tool::Tolerance(edge.edge), 1.5 * 0.002, 1e-9);
  EXPECT_GE(BRep_Tool::Tolerance(a), BRep_Tool::Tolerance(edge.edge));
}

/// The tolerance of an edge that leaves the plane of its face by 0.01, in the middle of both of its
/// spans or of the first alone.
double tolerance_of_bumpy_edge(double knot, bool twice) {
  SolidBuilder builder;
  const auto bumpy = [&](double t) -> Eigen::VectorXd {
    const double s = t < knot ? t / knot : twice ? (t - knot) / (2 - knot) : 0.0;
    return Vec3(10 * t, 0, 0.04 * s * (1 - s));
  };
  const auto curve = space_curve(fit_path(bumpy, {0.0, knot, 2.0}, 1e-4), 0);
  const TopoDS_Vertex a = builder.vertex({0, 0, 0}), b = builder.vertex({20, 0, 0}),
                      c = builder.vertex({0, 10, 0});
  const BuiltEdge edge = builder.edge(curve, 2.0, a, b);
  const BuiltEdge back = builder.straight_edge(b, c), close = builder.straight_edge(c, a);
  builder.face(plane_through(Vec3::Zero(), Vec3::UnitZ()), 1,
               {{{&edge, {}, true}, {&back, {}, true}, {&close, {}, true}}});
  return BRep_Tool::Tolerance(edge.edge);
}

TEST(SolidBuilder, LooksForDeviationsBetweenKnots) {
  for (const double tolerance :
       {tolerance_of_bumpy_edge(1.0, true), tolerance_of_bumpy_edge(0.01, false)}) {
    EXPECT_GE(tolerance, 0.0099);
    EXPECT_LE(tolerance, 1.5 * 0.0102);
  }
}

TEST(SolidBuilder, PutsSomeFacesIntoAnOpenShell) {
  SolidBuilder builder;
  std::vector<BuiltEdge> edges;
  for (int i = 0; i < 3; ++i) {
    const double z = i;
    const TopoDS_Vertex a = builder.vertex({0, 0, z}), b = builder.vertex({1, 0, z}),
                        c = builder.vertex({0, 1, z});
    edges = {builder.straight_edge(a, b), builder.straight_edge(b, c), builder.straight_edge(c, a)};
    builder.face(plane_through({0, 0, z}, Vec3::UnitZ()), 1,
                 {{{&edges[0], {}, true}, {&edges[1], {}, true}, {&edges[2], {}, true}}});
  }
  const TopoDS_Shell shell = builder.open_shell({2, 0});
  EXPECT_FALSE(shell.Closed());
  std::vector<double> heights;
  for (TopExp_Explorer faces(shell, TopAbs_FACE); faces.More(); faces.Next()) {
    GProp_GProps area;
    BRepGProp::SurfaceProperties(faces.Current(), area);
    EXPECT_NEAR(area.Mass(), 0.5, 1e-9);
    heights.push_back(area.CentreOfMass().Z());
  }
  ASSERT_EQ(heights.size(), 2u);
  EXPECT_NEAR(heights[0], 2, 1e-9);
  EXPECT_NEAR(heights[1], 0, 1e-9);
}

}  // namespace
}  // namespace planish::brep
