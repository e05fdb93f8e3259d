#pragma once

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>

#include <vector>

namespace planish::brep::test {

/// A face of the same surface, its edges in loops of the caller's making.
inline TopoDS_Face with_loops(const TopoDS_Face& face,
                              const std::vector<std::vector<TopoDS_Edge>>& loops) {
  BRep_Builder builder;
  TopoDS_Face made;
  builder.MakeFace(made, BRep_Tool::Surface(face), 1e-7);
  for (const auto& edges : loops) {
    TopoDS_Wire wire;
    builder.MakeWire(wire);
    for (const TopoDS_Edge& edge : edges)
      builder.Add(wire, edge);
    builder.Add(made, wire);
  }
  return TopoDS::Face(made.Oriented(face.Orientation()));
}

inline std::vector<TopoDS_Edge> edges_of(const TopoDS_Face& face) {
  std::vector<TopoDS_Edge> edges;
  for (TopExp_Explorer at(face.Oriented(TopAbs_FORWARD), TopAbs_EDGE); at.More(); at.Next())
    edges.push_back(TopoDS::Edge(at.Current()));
  return edges;
}

}  // namespace planish::brep::test
