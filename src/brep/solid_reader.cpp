#include "solid_reader.hpp"

#include "exact_curve.hpp"
#include "face_volume.hpp"
#include "genus.hpp"
#include "heal.hpp"
#include "kernel_points.hpp"
#include "loop_order.hpp"
#include "patch_volume.hpp"
#include "surface_reader.hpp"

#include <planish/base/tolerance.hpp>

#include <BRepAdaptor_Curve.hxx>
#include <BRepBndLib.hxx>
#include <BRepTools_WireExplorer.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Circ.hxx>

#include <algorithm>
#include <cmath>
#include <memory>

// A kernel's solid as a SolidModel, after which no kernel is needed to recognise it. Edges become
// curves of a closed form where they are lines or circles (exact_curve.cpp), faces what
// surface_reader.cpp finds, loops the uses of the wires: as the file has them where these follow
// each other, since sorting by the kernel costs more than all else. A volume that is negative tells
// a solid written inside out.

namespace planish::brep {
namespace {

/// A spline within this share of the solid's size of a line or circle counts as one.
constexpr double kExactShare = tolerance::kComputed;
/// Accuracy of a curved face's area, as a share of the squared size.
constexpr double kAreaShare = 1e-6;

/// Accuracy of a face's volume, as a share of the cubed size.
constexpr double kVolumeShare = 1e-11;

/// The kernel's faces, edges and vertices by their numbers from 1.
struct Numbered {
  TopTools_IndexedMapOfShape faces, edges, vertices;
};
Numbered numbered(const TopoDS_Solid& solid) {
  Numbered shapes;
  TopExp::MapShapes(solid, TopAbs_FACE, shapes.faces);
  TopExp::MapShapes(solid, TopAbs_EDGE, shapes.edges);
  TopExp::MapShapes(solid, TopAbs_VERTEX, shapes.vertices);
  return shapes;
}

SpaceCurve read_curve(const TopoDS_Edge& edge, double size) {
  const auto adaptor = std::make_shared<BRepAdaptor_Curve>(edge);
  SpaceCurve curve;
  curve.t0 = adaptor->FirstParameter();
  curve.t1 = adaptor->LastParameter();
  curve.start = vector_of(adaptor->Value(curve.t0));
  curve.end = vector_of(adaptor->Value(curve.t1));
  curve.evaluate = [adaptor](double t, Vec3& point, Vec3& derivative) {
    gp_Pnt p;
    gp_Vec d;
    adaptor->D1(t, p, d);
    point = vector_of(p);
    derivative = vector_of(d);
  };
  if (adaptor->GetType() == GeomAbs_Line) {
    curve.kind = SpaceCurve::Kind::line;
  } else if (adaptor->GetType() == GeomAbs_Circle) {
    const gp_Circ circle = adaptor->Circle();
    const gp_Ax2& axes = circle.Position();
    curve.kind = SpaceCurve::Kind::circle;
    curve.circle = frame_from_axes(vector_of(axes.Location()), vector_of(axes.Direction().XYZ()),
                                   vector_of(axes.XDirection().XYZ()));
    curve.radius = circle.Radius();
  }
  return exact_curve(std::move(curve), kExactShare * size);
}

std::vector<SolidEdge> read_edges(const Numbered& shapes, double size) {
  std::vector<SolidEdge> edges;
  for (int i = 1; i <= shapes.edges.Extent(); ++i) {
    const TopoDS_Edge& edge = TopoDS::Edge(shapes.edges(i));
    SolidEdge& row = edges.emplace_back();
    if (BRep_Tool::Degenerated(edge)) continue;
    row.curve = read_curve(edge, size);
    row.vertices = {shapes.vertices.FindIndex(TopExp::FirstVertex(edge)) - 1,
                    shapes.vertices.FindIndex(TopExp::LastVertex(edge)) - 1};
  }
  return edges;
}

/// Uses of the wire's edges in the file's order; degenerate edges have none.
std::vector<CoEdge> uses_in(const TopoDS_Wire& wire, const Numbered& shapes) {
  std::vector<CoEdge> uses;
  for (TopoDS_Iterator edges(wire); edges.More(); edges.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(edges.Value());
    if (!BRep_Tool::Degenerated(edge))
      uses.push_back({shapes.edges.FindIndex(edge) - 1, edge.Orientation() == TopAbs_FORWARD});
  }
  return uses;
}

/// The same in the order of the kernel's explorer; empty if it misses some.
std::optional<std::vector<CoEdge>> uses_explored(const TopoDS_Wire& wire, const TopoDS_Face& face,
                                                 const Numbered& shapes) {
  std::vector<CoEdge> uses;
  int met = 0;
  for (BRepTools_WireExplorer explorer(wire, face); explorer.More(); explorer.Next(), ++met)
    if (!BRep_Tool::Degenerated(explorer.Current()))
      uses.push_back({shapes.edges.FindIndex(explorer.Current()) - 1,
                      explorer.Current().Orientation() == TopAbs_FORWARD});
  if (met != wire.NbChildren()) return {};
  return uses;
}

/// Wires in files are mostly in order already; the kernel's explorer, which sorts them by their
/// parameter curves, costs more than everything else here, so it only gets the others.
std::vector<CoEdge> read_wire(const TopoDS_Wire& wire, const TopoDS_Face& face,
                              const Numbered& shapes, const std::vector<SolidEdge>& edges) {
  std::vector<CoEdge> uses = uses_in(wire, shapes);
  if (in_order(edges, uses)) return uses;
  std::vector<CoEdge> backwards(uses.rbegin(), uses.rend());
  if (in_order(edges, backwards)) return backwards;
  if (auto explored = uses_explored(wire, face, shapes)) return *explored;
  return chained(edges, std::move(uses));
}

std::vector<std::vector<CoEdge>> read_loops(const TopoDS_Face& face, const Numbered& shapes,
                                            const std::vector<SolidEdge>& edges) {
  const TopoDS_Face forward = TopoDS::Face(face.Oriented(TopAbs_FORWARD));
  std::vector<std::vector<CoEdge>> loops;
  for (TopoDS_Iterator wires(forward); wires.More(); wires.Next()) {
    if (wires.Value().ShapeType() != TopAbs_WIRE) continue;
    std::vector<CoEdge> loop = read_wire(TopoDS::Wire(wires.Value()), forward, shapes, edges);
    if (loop.empty()) continue;
    if (face.Orientation() == TopAbs_REVERSED) {
      std::ranges::reverse(loop);
      for (CoEdge& use : loop)
        use.forward = !use.forward;
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

/// The edges with the faces that use them.
std::vector<SolidEdge> with_neighbours(std::vector<SolidEdge> edges,
                                       const std::vector<SolidFace>& faces) {
  for (int f = 0; f < std::ssize(faces); ++f)
    for (const auto& loop : faces[f].loops)
      for (const CoEdge& use : loop) {
        SolidEdge& edge = edges[use.edge];
        if (edge.uses < 2) {
          edge.faces[edge.uses] = f;
          edge.forward[edge.uses] = use.forward;
        }
        ++edge.uses;
      }
  return edges;
}

SolidModel read_model(const TopoDS_Solid& solid, double surface_tolerance) {
  const Numbered shapes = numbered(solid);
  SolidModel model;
  Bnd_Box box;
  BRepBndLib::AddClose(solid, box);
  if (!box.IsVoid()) {
    model.centre = vector_of((box.CornerMin().XYZ() + box.CornerMax().XYZ()) / 2);
    model.size = box.CornerMin().Distance(box.CornerMax());
  }
  model.edges = read_edges(shapes, model.size);
  for (int i = 1; i <= shapes.faces.Extent(); ++i) {
    const TopoDS_Face& face = TopoDS::Face(shapes.faces(i));
    SolidFace& row = model.faces.emplace_back(read_surface(face, surface_tolerance));
    row.loops = read_loops(face, shapes, model.edges);
    if (!has_border_volume(row))
      row.volume = patch_volume(face, model.centre, kVolumeShare * std::pow(model.size, 3));
    if (std::holds_alternative<DoublyCurved>(row.surface))
      row.curved_area = patch_area(face, kAreaShare * model.size * model.size);
  }
  model.edges = with_neighbours(std::move(model.edges), model.faces);
  for (SolidFace& face : model.faces)
    if (has_border_volume(face)) face.volume = volume_under(face, model);
  model.genus = genus_of(model);
  return healed(std::move(model));
}

}  // namespace

SolidModel read_solid(const TopoDS_Solid& solid, double surface_tolerance) {
  SolidModel model = read_model(solid, surface_tolerance);
  if (volume_of(model) >= 0.0) return model;
  // Some systems write solids inside out.
  return read_model(TopoDS::Solid(solid.Reversed()), surface_tolerance);
}

}  // namespace planish::brep
