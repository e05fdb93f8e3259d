#pragma once

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <GC_MakeArcOfCircle.hxx>

#include <cmath>

namespace planish::test {

/// Sizes in mm; `first` and `second` are the flanges beside the bend.
struct BentBracket {
  double thickness, inside_radius, first, second, width;
};

/// A solid bent up by 90°: its first flange lies on z = 0 from x = 0 on, its width is along y.
inline TopoDS_Shape bent_bracket(const BentBracket& of) {
  const double t = of.thickness, r = of.inside_radius;
  const double x = of.first + r + t, z = t + r, root = std::sqrt(0.5);
  const auto at = [](double px, double pz) { return gp_Pnt(px, 0.0, pz); };
  BRepBuilderAPI_MakeWire wire;
  const auto line = [&](const gp_Pnt& a, const gp_Pnt& b) {
    wire.Add(BRepBuilderAPI_MakeEdge(a, b).Edge());
  };
  const auto bend = [&](const gp_Pnt& a, double radius, const gp_Pnt& b) {
    const gp_Pnt middle = at(of.first + radius * root, z - radius * root);
    wire.Add(BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(a, middle, b).Value()).Edge());
  };
  line(at(0, 0), at(of.first, 0));
  bend(at(of.first, 0), r + t, at(x, z));
  line(at(x, z), at(x, z + of.second));
  line(at(x, z + of.second), at(x - t, z + of.second));
  line(at(x - t, z + of.second), at(x - t, z));
  bend(at(x - t, z), r, at(of.first, t));
  line(at(of.first, t), at(0, t));
  line(at(0, t), at(0, 0));
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(wire.Wire()).Face(), gp_Vec(0, of.width, 0))
      .Shape();
}

}  // namespace planish::test
