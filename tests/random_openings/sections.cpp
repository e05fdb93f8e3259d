#include "sections.hpp"

#include <planish/geometry/quadrature.hpp>

#include <BRepAdaptor_Curve.hxx>
#include <BRepAlgoAPI_Common.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepTools.hxx>
#include <Bnd_Box.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Pln.hxx>

#include <algorithm>
#include <cmath>

// Sections by the kernel's common part of a solid and a face, measured by Gauss rules along their
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
      const auto speed = [&](double t) {
        const Local p = at(t);
        return std::hypot(p.dx, p.dy);
      };
      result.area += sign * gauss(swept, a, a + step);
      result.perimeter += gauss(speed, a, a + step);
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

std::vector<SectionWire> section_at(const TopoDS_Shape& solid, const Flange& flange,
                                    double height) {
  const gp_Vec up(flange.axes.Direction());
  const gp_Pln plane(gp_Ax3(flange.axes).Translated(height * up));
  constexpr double kFar = 1000.0;
  const TopoDS_Shape face = BRepBuilderAPI_MakeFace(plane, -kFar, kFar, -kFar, kFar).Shape();
  const TopoDS_Shape common = BRepAlgoAPI_Common(face, solid).Shape();
  std::vector<SectionWire> wires;
  for (TopExp_Explorer faces(common, TopAbs_FACE); faces.More(); faces.Next()) {
    const TopoDS_Face& one = TopoDS::Face(faces.Current());
    const TopoDS_Wire outer = BRepTools::OuterWire(one);
    for (TopExp_Explorer at(one, TopAbs_WIRE); at.More(); at.Next()) {
      const TopoDS_Wire& wire = TopoDS::Wire(at.Current());
      wires.push_back(measured(wire, flange.axes, wire.IsSame(outer)));
    }
  }
  return wires;
}

}  // namespace planish::openings
