#pragma once

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <GC_MakeArcOfCircle.hxx>

#include <cmath>
#include <numbers>

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

/// A sheet of 2 mm, bent by 20° round the radius 2, symmetric about x = 0, its outside at z = 0.
inline TopoDS_Shape gently_bent() {
  const double half = std::numbers::pi / 18;
  const auto at = [&](double radius, double turn, double along) {
    return gp_Pnt(radius * std::sin(turn) + std::copysign(along, turn) * std::cos(turn), 0,
                  4 - radius * std::cos(turn) + along * std::sin(std::abs(turn)));
  };
  BRepBuilderAPI_MakeWire wire;
  const auto line = [&](const gp_Pnt& a, const gp_Pnt& b) {
    wire.Add(BRepBuilderAPI_MakeEdge(a, b).Edge());
  };
  const auto bend = [&](double radius, double from) {
    const auto arc = GC_MakeArcOfCircle(at(radius, from, 0), at(radius, 0, 0),
                                        at(radius, -from, 0));
    wire.Add(BRepBuilderAPI_MakeEdge(arc.Value()).Edge());
  };
  line(at(4, -half, 40), at(4, -half, 0));
  bend(4, -half);
  line(at(4, half, 0), at(4, half, 40));
  line(at(4, half, 40), at(2, half, 40));
  line(at(2, half, 40), at(2, half, 0));
  bend(2, half);
  line(at(2, -half, 0), at(2, -half, 40));
  line(at(2, -half, 40), at(4, -half, 40));
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(wire.Wire()).Face(), gp_Vec(0, 50, 0))
      .Shape();
}

}  // namespace planish::test
