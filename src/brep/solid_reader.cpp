#include "solid_reader.hpp"

#include "face_volume.hpp"
#include "heal.hpp"
#include "patch_volume.hpp"
#include "surface_reader.hpp"

#include <BRepAdaptor_Curve.hxx>
#include <BRepBndLib.hxx>
#include <BRepTools_WireExplorer.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Circ.hxx>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

namespace planish::brep {
namespace {

Vec3 vec(const gp_XYZ& v) { return {v.X(), v.Y(), v.Z()}; }

/// Many systems write straight lines and circles as splines. What lies on one within this share of
/// the solid's size is one: STEP files carry about ten digits.
constexpr double kExactShare = 1e-9;
constexpr int kProbes = 12;
/// A face's volume is measured this closely, of the cubed size.
constexpr double kVolume = 1e-11;

bool is_straight(const SpaceCurve& curve, double tolerance) {
  const Vec3 chord = curve.end - curve.start;
  if (chord.norm() <= tolerance) return false;
  const Vec3 along = chord.normalized();
  double reached = 0.0;
  for (int i = 1; i < kProbes; ++i) {
    const Vec3 d = curve.point(curve.t0 + (curve.t1 - curve.t0) * i / kProbes) - curve.start;
    if ((d - d.dot(along) * along).norm() > tolerance || d.dot(along) < reached) return false;
    reached = d.dot(along);
  }
  return true;
}

/// The circle through three points of the curve, when the others lie on it and turn one way.
std::optional<SpaceCurve> as_circle(const SpaceCurve& curve, double tolerance) {
  const auto at = [&](double share) {
    return curve.point(curve.t0 + (curve.t1 - curve.t0) * share);
  };
  const Vec3 a = at(0.0);
  const Vec3 u = at(1.0 / 3) - a;
  const Vec3 v = at(2.0 / 3) - a;
  const Vec3 n = u.cross(v);
  if (n.norm() <= tolerance * std::max(u.norm(), v.norm())) return {};
  const Vec3 centre = a + (v.squaredNorm() * n.cross(u) - u.squaredNorm() * n.cross(v)) /
                              (2 * n.squaredNorm());
  SpaceCurve circle = curve;
  circle.kind = SpaceCurve::Kind::circle;
  circle.circle = frame_from_axes(centre, n.normalized(), a - centre);
  circle.radius = (a - centre).norm();
  circle.t0 = 0.0;
  double angle = 0.0;
  for (int i = 1; i <= kProbes; ++i) {
    const Vec3 local = circle.circle.local(at(static_cast<double>(i) / kProbes));
    if (std::hypot(local.head<2>().norm() - circle.radius, local.z()) > tolerance) return {};
    double next = std::atan2(local.y(), local.x());
    while (next < angle)
      next += 2 * std::numbers::pi;
    if (next - angle > std::numbers::pi) return {};
    angle = next;
  }
  circle.t1 = (curve.end - curve.start).norm() <= tolerance ? 2 * std::numbers::pi : angle;
  return circle;
}

SpaceCurve read_curve(const TopoDS_Edge& edge, double size) {
  const auto adaptor = std::make_shared<BRepAdaptor_Curve>(edge);
  SpaceCurve curve;
  curve.t0 = adaptor->FirstParameter();
  curve.t1 = adaptor->LastParameter();
  curve.start = vec(adaptor->Value(curve.t0).XYZ());
  curve.end = vec(adaptor->Value(curve.t1).XYZ());
  curve.evaluate = [adaptor](double t, Vec3& point, Vec3& derivative) {
    gp_Pnt p;
    gp_Vec d;
    adaptor->D1(t, p, d);
    point = vec(p.XYZ());
    derivative = vec(d.XYZ());
  };
  if (adaptor->GetType() == GeomAbs_Line) {
    curve.kind = SpaceCurve::Kind::line;
  } else if (adaptor->GetType() == GeomAbs_Circle) {
    const gp_Circ circle = adaptor->Circle();
    curve.kind = SpaceCurve::Kind::circle;
    const gp_Ax2& axes = circle.Position();
    curve.circle = frame_from_axes(vec(axes.Location().XYZ()), vec(axes.Direction().XYZ()),
                                   vec(axes.XDirection().XYZ()));
    curve.radius = circle.Radius();
  } else if (is_straight(curve, kExactShare * size)) {
    curve.kind = SpaceCurve::Kind::line;
  } else if (auto circle = as_circle(curve, kExactShare * size)) {
    return *circle;
  }
  return curve;
}

class Reader {
 public:
  Reader(const TopoDS_Solid& solid, double tolerance) : tolerance_(tolerance) {
    TopExp::MapShapes(solid, TopAbs_FACE, faces_);
    TopExp::MapShapes(solid, TopAbs_EDGE, edges_);
    TopExp::MapShapes(solid, TopAbs_VERTEX, vertices_);
    Bnd_Box box;
    BRepBndLib::AddClose(solid, box);
    if (!box.IsVoid()) {
      model_.centre = vec((box.CornerMin().XYZ() + box.CornerMax().XYZ()) / 2);
      model_.size = box.CornerMin().Distance(box.CornerMax());
    }
  }

  SolidModel run() {
    for (int i = 1; i <= edges_.Extent(); ++i) {
      const TopoDS_Edge& edge = TopoDS::Edge(edges_(i));
      SolidEdge& row = model_.edges.emplace_back();
      if (BRep_Tool::Degenerated(edge)) continue;
      row.curve = read_curve(edge, model_.size);
      row.vertices = {vertices_.FindIndex(TopExp::FirstVertex(edge)) - 1,
                      vertices_.FindIndex(TopExp::LastVertex(edge)) - 1};
    }
    for (int i = 1; i <= faces_.Extent(); ++i) {
      const TopoDS_Face& face = TopoDS::Face(faces_(i));
      SolidFace row = read_surface(face, tolerance_);
      read_loops(face, row, i - 1);
      if (!has_border_volume(row))
        row.volume = patch_volume(face, model_.centre, kVolume * std::pow(model_.size, 3));
      model_.faces.push_back(std::move(row));
    }
    for (SolidFace& face : model_.faces)
      if (has_border_volume(face)) face.volume = volume_under(face, model_);
    heal(model_);
    return std::move(model_);
  }

 private:
  void read_loops(const TopoDS_Face& face, SolidFace& row, int index) {
    const TopoDS_Face forward = TopoDS::Face(face.Oriented(TopAbs_FORWARD));
    for (TopoDS_Iterator wires(forward); wires.More(); wires.Next()) {
      if (wires.Value().ShapeType() != TopAbs_WIRE) continue;
      std::vector<CoEdge> loop = read_wire(TopoDS::Wire(wires.Value()), forward);
      if (loop.empty()) continue;
      if (face.Orientation() == TopAbs_REVERSED) {
        std::reverse(loop.begin(), loop.end());
        for (CoEdge& use : loop)
          use.forward = !use.forward;
      }
      for (const CoEdge& use : loop)
        note_use(use, index);
      row.loops.push_back(std::move(loop));
    }
  }

  void note_use(const CoEdge& use, int face) {
    SolidEdge& row = model_.edges[use.edge];
    if (row.uses < 2) {
      row.faces[row.uses] = face;
      row.forward[row.uses] = use.forward;
    }
    ++row.uses;
  }

  /// Wires of files are mostly in order already; the kernel's explorer, which sorts them through
  /// their parameter curves, costs more than all else here and is asked only for the others.
  std::vector<CoEdge> read_wire(const TopoDS_Wire& wire, const TopoDS_Face& face) const {
    std::vector<CoEdge> loop;
    int expected = 0;
    for (TopoDS_Iterator edges(wire); edges.More(); edges.Next(), ++expected)
      add_use(TopoDS::Edge(edges.Value()), loop);
    if (in_order(loop)) return loop;
    std::reverse(loop.begin(), loop.end());
    if (in_order(loop)) return loop;
    loop.clear();
    int met = 0;
    for (BRepTools_WireExplorer explorer(wire, face); explorer.More(); explorer.Next(), ++met)
      add_use(explorer.Current(), loop);
    if (met == expected) return loop;
    return chained(wire);
  }

  /// Every use starts at the vertex where the one before ends.
  bool in_order(const std::vector<CoEdge>& loop) const {
    const auto vertex = [&](const CoEdge& use, bool last) {
      return model_.edges[use.edge].vertices[use.forward == last ? 1 : 0];
    };
    for (size_t i = 0; i < loop.size(); ++i)
      if (vertex(loop[i], true) != vertex(loop[(i + 1) % loop.size()], false)) return false;
    return true;
  }

  void add_use(const TopoDS_Edge& edge, std::vector<CoEdge>& loop) const {
    if (BRep_Tool::Degenerated(edge)) return;
    loop.push_back({edges_.FindIndex(edge) - 1, edge.Orientation() == TopAbs_FORWARD});
  }

  /// For wires that the kernel's explorer cannot follow: the next edge starts nearest to the end.
  std::vector<CoEdge> chained(const TopoDS_Wire& wire) const {
    std::vector<CoEdge> rest;
    for (TopoDS_Iterator edges(wire); edges.More(); edges.Next())
      add_use(TopoDS::Edge(edges.Value()), rest);
    const auto end_point = [&](const CoEdge& use, bool last) {
      const SpaceCurve& curve = model_.edges[use.edge].curve;
      return use.forward == last ? curve.end : curve.start;
    };
    std::vector<CoEdge> loop;
    while (!rest.empty()) {
      auto next = rest.begin();
      if (!loop.empty()) {
        const Vec3 end = end_point(loop.back(), true);
        next = std::min_element(rest.begin(), rest.end(), [&](const CoEdge& a, const CoEdge& b) {
          return (end_point(a, false) - end).squaredNorm() <
                 (end_point(b, false) - end).squaredNorm();
        });
      }
      loop.push_back(*next);
      rest.erase(next);
    }
    return loop;
  }

  double tolerance_;
  TopTools_IndexedMapOfShape faces_, edges_, vertices_;
  SolidModel model_;
};

}  // namespace

SolidModel read_solid(const TopoDS_Solid& solid, double surface_tolerance) {
  SolidModel model = Reader(solid, surface_tolerance).run();
  if (volume_of(model) >= 0.0) return model;
  // Some systems write solids inside out.
  return Reader(TopoDS::Solid(solid.Reversed()), surface_tolerance).run();
}

}  // namespace planish::brep
