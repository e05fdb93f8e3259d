#include "sections.hpp"

#include <planish/geometry/quadrature.hpp>

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Common.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepTools.hxx>
#include <Bnd_Box.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Pln.hxx>

#include <algorithm>
#include <cmath>

// Sections by the kernel's common part of a solid and faces, measured by Gauss rules along their
// edges: nothing of the program under test has a part in it but the quadrature.

namespace planish::openings {
namespace {

struct Local {
  double x, y, dx, dy;
};

SectionWire measured(const TopoDS_Wire& wire, const gp_Ax3& axes, bool outer) {
  SectionWire result;
  result.outer = outer;
  double lo_x = HUGE_VAL, lo_y = HUGE_VAL, hi_x = -HUGE_VAL, hi_y = -HUGE_VAL;
  for (TopExp_Explorer edges(wire, TopAbs_EDGE); edges.More(); edges.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(edges.Current());
    const BRepAdaptor_Curve curve(edge);
    const auto at = [&](double t) {
      gp_Pnt p;
      gp_Vec d;
      curve.D1(t, p, d);
      const gp_Vec from(axes.Location(), p);
      const gp_Vec x(axes.XDirection()), y(axes.YDirection());
      return Local{from.Dot(x), from.Dot(y), d.Dot(x), d.Dot(y)};
    };
    constexpr int kPieces = 16;
    const double step = (curve.LastParameter() - curve.FirstParameter()) / kPieces;
    const double sign = edge.Orientation() == TopAbs_REVERSED ? -1.0 : 1.0;
    for (int i = 0; i < kPieces; ++i) {
      const double a = curve.FirstParameter() + i * step;
      const auto swept = [&](double t) {
        const Local p = at(t);
        return (p.x * p.dy - p.y * p.dx) / 2;
      };
      result.area += sign * gauss(swept, a, a + step);
      for (const double t : {a, a + step / 2}) {
        const Local p = at(t);
        lo_x = std::min(lo_x, p.x);
        lo_y = std::min(lo_y, p.y);
        hi_x = std::max(hi_x, p.x);
        hi_y = std::max(hi_y, p.y);
      }
    }
  }
  result.area = std::abs(result.area);
  result.x = (lo_x + hi_x) / 2;
  result.y = (lo_y + hi_y) / 2;
  return result;
}

}  // namespace

std::vector<SectionWire> sections(const TopoDS_Shape& solid, const Flange& flange,
                                  const std::vector<double>& heights) {
  const gp_Vec up(flange.axes.Direction());
  constexpr double kMargin = 20.0;  // mm, beyond the flange
  TopTools_ListOfShape planes, solids;
  for (const double height : heights) {
    const gp_Pln plane(gp_Ax3(flange.axes).Translated(height * up));
    planes.Append(BRepBuilderAPI_MakeFace(plane, -kMargin, flange.size[0] + kMargin, -kMargin,
                                          flange.size[1] + kMargin)
                      .Shape());
  }
  solids.Append(solid);
  BRepAlgoAPI_Common common;
  common.SetArguments(planes);
  common.SetTools(solids);
  common.Build();
  std::vector<SectionWire> wires;
  for (TopExp_Explorer faces(common.Shape(), TopAbs_FACE); faces.More(); faces.Next()) {
    const TopoDS_Face& one = TopoDS::Face(faces.Current());
    const gp_Pnt at = BRepAdaptor_Surface(one).Value(0.0, 0.0);
    const double height = gp_Vec(flange.axes.Location(), at).Dot(up);
    const TopoDS_Wire outer = BRepTools::OuterWire(one);
    for (TopExp_Explorer wire(one, TopAbs_WIRE); wire.More(); wire.Next()) {
      wires.push_back(
          measured(TopoDS::Wire(wire.Current()), flange.axes, wire.Current().IsSame(outer)));
      wires.back().height = height;
    }
  }
  return wires;
}

}  // namespace planish::openings
