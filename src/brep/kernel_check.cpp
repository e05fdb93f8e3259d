#include "kernel_check.hpp"

#include <BRepAdaptor_Surface.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepCheck_Shell.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_DataMapIteratorOfDataMapOfShapeInteger.hxx>
#include <TopTools_DataMapOfShapeInteger.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Wire.hxx>

// The kernel's check of a shell, made fast for faces with many contours, of which the kernel
// compares all edges with each other. Such a plane face is checked as one face within each contour,
// and the sense of the faces by a count of how often they run along each edge either way. Contours
// that cross each other show in the flat pattern.

namespace planish::brep {
namespace {

/// Faces with fewer contours are checked as a whole.
constexpr int kManyContours = 8;

bool has_many_contours(const TopoDS_Face& face) {
  if (BRepAdaptor_Surface(face, false).GetType() != GeomAbs_Plane) return false;
  int count = 0;
  for (TopoDS_Iterator each(face, false, false); each.More(); each.Next())
    ++count;
  return count >= kManyContours;
}

/// The face within each of its contours.
void add_contours(const TopoDS_Face& face, TopoDS_Compound& to) {
  const BRep_Builder builder;
  const TopoDS_Wire outer = BRepTools::OuterWire(face);
  for (TopoDS_Iterator each(face, false, false); each.More(); each.Next()) {
    const bool is_outer = each.Value().IsSame(outer);
    TopoDS_Shape within = face.EmptyCopied().Oriented(TopAbs_FORWARD);  // else what is added turns
    builder.Add(within, is_outer ? each.Value() : each.Value().Reversed());
    builder.Add(to, within);
  }
}

// Whether the faces run along each edge as often one way as the other.
bool is_oriented(const TopoDS_Shell& shell) {
  TopTools_DataMapOfShapeInteger balance;
  for (TopExp_Explorer edges(shell, TopAbs_EDGE); edges.More(); edges.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(edges.Current());
    if (BRep_Tool::Degenerated(edge)) continue;
    if (edge.Orientation() != TopAbs_FORWARD && edge.Orientation() != TopAbs_REVERSED) return false;
    const int way = edge.Orientation() == TopAbs_FORWARD ? 1 : -1;
    const TopoDS_Shape key = edge.Oriented(TopAbs_FORWARD);
    balance.Bind(key, way + (balance.IsBound(key) ? balance.Find(key) : 0));
  }
  for (TopTools_DataMapIteratorOfDataMapOfShapeInteger it(balance); it.More(); it.Next())
    if (it.Value() != 0) return false;
  return true;
}

}  // namespace

bool is_sound(const TopoDS_Shell& shell) {
  const BRep_Builder builder;
  TopoDS_Compound parts;
  builder.MakeCompound(parts);
  for (TopExp_Explorer faces(shell, TopAbs_FACE); faces.More(); faces.Next()) {
    const TopoDS_Face& face = TopoDS::Face(faces.Current());
    if (has_many_contours(face))
      add_contours(face, parts);
    else
      builder.Add(parts, face);
  }
  if (!BRepCheck_Analyzer(parts).IsValid()) return false;
  return BRepCheck_Shell(shell).Closed() == BRepCheck_NoError && is_oriented(shell);
}

}  // namespace planish::brep
