#include "soundness.hpp"

#include "kernel_points.hpp"

#include <planish/base/union_find.hpp>

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Geom_Surface.hxx>
#include <NCollection_DataMap.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Vertex.hxx>
#include <gp_Cone.hxx>
#include <gp_Cylinder.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

// Whether a face as written is read rightly (docs/decisions/0010): edges have curves in space and
// follow each other, and no loop runs round a cylinder or cone without a seam. Turns round an axis
// are counted from ends and middles of edges, none of which turns by more than half a turn a step.
// The same in parameters, for meshing: curves of a loop must not be a period apart.

namespace planish::brep {
namespace {

using Edges = std::vector<TopoDS_Edge>;  // of a wire, in the order of the file

Edges edges_of(const TopoDS_Shape& wire) {
  Edges edges;
  for (TopoDS_Iterator edge(wire); edge.More(); edge.Next())
    edges.push_back(TopoDS::Edge(edge.Value()));
  return edges;
}

bool has_curve(const TopoDS_Edge& edge) {
  double t0 = 0.0, t1 = 0.0;
  return BRep_Tool::Degenerated(edge) || !BRep_Tool::Curve(edge, t0, t1).IsNull();
}

/// Whether each edge starts at the vertex where the one before ends, all round.
bool follow_each_other(const Edges& edges) {
  for (size_t i = 0; i < edges.size(); ++i) {
    const TopoDS_Vertex end = TopExp::LastVertex(edges[i], true);
    const TopoDS_Vertex start = TopExp::FirstVertex(edges[(i + 1) % edges.size()], true);
    if (end.IsNull() || start.IsNull() || !end.IsSame(start)) return false;
  }
  return true;
}

/// As the file has them, or the other way round: empty when they do not follow each other.
Edges in_order(Edges edges) {
  if (follow_each_other(edges)) return edges;
  std::ranges::reverse(edges);
  return follow_each_other(edges) ? edges : Edges{};
}

/// How often the loop runs round the axis.
int turns_about(const gp_Ax1& axis, const Edges& loop) {
  const Vec3 origin = vector_of(axis.Location());
  const Vec3 z = vector_of(axis.Direction().XYZ());
  double turned = 0.0;
  for (const TopoDS_Edge& edge : loop) {
    if (BRep_Tool::Degenerated(edge)) continue;
    const BRepAdaptor_Curve curve(edge);
    const double t0 = curve.FirstParameter(), t1 = curve.LastParameter();
    const auto radial = [&](double t) -> Vec3 {
      const Vec3 d = vector_of(curve.Value(t)) - origin;
      return d - d.dot(z) * z;
    };
    // A straight line on such a surface is a ruling; others turn by less than half a turn a step.
    const int steps = curve.GetType() == GeomAbs_Line ? 1 : 8;
    double along = 0.0;
    for (int i = 0; i < steps; ++i) {
      const Vec3 a = radial(t0 + (t1 - t0) * i / steps);
      const Vec3 b = radial(t0 + (t1 - t0) * (i + 1) / steps);
      along += std::atan2(a.cross(b).dot(z), a.dot(b));
    }
    turned += edge.Orientation() == TopAbs_REVERSED ? -along : along;
  }
  return static_cast<int>(std::lround(turned / (2 * std::numbers::pi)));
}

/// Whether no loop runs round the axis: over a seam it comes back.
bool comes_back(const gp_Ax1& axis, const std::vector<Edges>& loops) {
  return std::ranges::all_of(loops,
                             [&](const Edges& loop) { return turns_about(axis, loop) == 0; });
}

/// Ends of an edge's curve in the parameters of the face, as the loop runs.
std::array<gp_Pnt2d, 2> parameters_at_ends(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  double t0 = 0.0, t1 = 0.0;
  const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, t0, t1);
  if (edge.Orientation() == TopAbs_REVERSED) std::swap(t0, t1);
  return {curve->Value(t0), curve->Value(t1)};
}

/// Whether the curves of a loop follow each other in the parameters, not a period apart.
bool closes_in_parameters(const GeomAdaptor_Surface& surface, const TopoDS_Face& face,
                          const Edges& loop) {
  constexpr double kApart = 0.1;  // of a period
  const double u = surface.IsUClosed() ? surface.LastUParameter() - surface.FirstUParameter() : 0.0;
  const double v = surface.IsVClosed() ? surface.LastVParameter() - surface.FirstVParameter() : 0.0;
  if (u == 0.0 && v == 0.0) return true;
  for (size_t i = 0; i < loop.size(); ++i) {
    const gp_Pnt2d end = parameters_at_ends(loop[i], face)[1];
    const gp_Pnt2d start = parameters_at_ends(loop[(i + 1) % loop.size()], face)[0];
    if (u > 0.0 && std::abs(end.X() - start.X()) > kApart * u) return false;
    if (v > 0.0 && std::abs(end.Y() - start.Y()) > kApart * v) return false;
  }
  return true;
}

/// How the faces of a shell run along an edge.
struct Runs {
  int forward = 0, backward = 0;
  int face = 0;  // one of them
};

}  // namespace

bool has_parameter_curves(const TopoDS_Face& face) {
  const TopoDS_Face forward = TopoDS::Face(face.Oriented(TopAbs_FORWARD));
  if (GeomAdaptor_Surface(BRep_Tool::Surface(face)).GetType() == GeomAbs_Plane) return true;
  for (TopExp_Explorer edges(forward, TopAbs_EDGE); edges.More(); edges.Next()) {
    double t0 = 0.0, t1 = 0.0;
    if (BRep_Tool::CurveOnSurface(TopoDS::Edge(edges.Current()), forward, t0, t1).IsNull())
      return false;
  }
  return true;
}

bool follows_in_parameters(const TopoDS_Face& face) {
  const GeomAdaptor_Surface surface(BRep_Tool::Surface(face));
  if (surface.GetType() == GeomAbs_Plane) return true;
  if (!has_parameter_curves(face)) return false;
  const TopoDS_Face forward = TopoDS::Face(face.Oriented(TopAbs_FORWARD));
  for (TopoDS_Iterator wires(forward); wires.More(); wires.Next()) {
    if (wires.Value().ShapeType() != TopAbs_WIRE) continue;
    const Edges loop = in_order(edges_of(wires.Value()));
    if (loop.empty() || !closes_in_parameters(surface, forward, loop)) return false;
  }
  return true;
}

bool is_readable(const TopoDS_Face& face) {
  const Handle(Geom_Surface) geometry = BRep_Tool::Surface(face);
  if (geometry.IsNull()) return false;
  const TopoDS_Face forward = TopoDS::Face(face.Oriented(TopAbs_FORWARD));
  std::vector<Edges> loops;
  for (TopoDS_Iterator wires(forward); wires.More(); wires.Next()) {
    if (wires.Value().ShapeType() != TopAbs_WIRE) return false;
    Edges edges = edges_of(wires.Value());
    if (!std::ranges::all_of(edges, has_curve)) return false;
    loops.push_back(in_order(std::move(edges)));
    if (loops.back().empty()) return false;
  }
  if (loops.empty()) return false;
  const GeomAdaptor_Surface surface(geometry);
  switch (surface.GetType()) {
    case GeomAbs_Plane:
      return true;
    case GeomAbs_Cylinder:
      return comes_back(surface.Cylinder().Axis(), loops);
    case GeomAbs_Cone:
      return comes_back(surface.Cone().Axis(), loops);
    default:
      return has_parameter_curves(face) && std::ranges::all_of(loops, [&](const Edges& loop) {
               return closes_in_parameters(surface, forward, loop);
             });
  }
}

bool is_closed_solid(const TopoDS_Shape& shape) {
  if (shape.ShapeType() != TopAbs_SOLID || shape.NbChildren() != 1) return false;
  NCollection_DataMap<TopoDS_Shape, Runs, TopTools_ShapeMapHasher> runs;
  std::vector<std::pair<int, int>> neighbours;
  int count = 0;
  for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next(), ++count)
    for (TopExp_Explorer edges(faces.Current(), TopAbs_EDGE); edges.More(); edges.Next()) {
      if (BRep_Tool::Degenerated(TopoDS::Edge(edges.Current()))) continue;
      Runs* known = runs.ChangeSeek(edges.Current());
      if (known == nullptr) known = runs.Bound(edges.Current(), Runs{0, 0, count});
      ++(edges.Current().Orientation() == TopAbs_REVERSED ? known->backward : known->forward);
      if (known->face != count) neighbours.emplace_back(known->face, count);
    }
  for (decltype(runs)::Iterator at(runs); at.More(); at.Next())
    if (at.Value().forward != 1 || at.Value().backward != 1) return false;
  UnionFind parts(count);
  for (const auto& [a, b] : neighbours)
    parts.unite(a, b);
  return count > 0 && parts.count() == 1;
}

}  // namespace planish::brep
