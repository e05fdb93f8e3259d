#include "body.hpp"
#include "guarded.hpp"
#include "mend.hpp"
#include "refusals.hpp"
#include "thicken.hpp"
#include "triangulate.hpp"

#include <planish/base/union_find.hpp>
#include <planish/brep/step.hpp>
#include <planish/geometry/mesh_volume.hpp>

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

// A mesh of a solid from the kernel's triangles. The kernel meshes each face for itself; nodes
// along common edges and vertices are united by what the kernel says they are, never by distance.
// It does not mesh all faces rightly: a face counts only if its nodes lie where its edges are, and
// the whole only if it is closed and has the solid's volume but for a layer as thick as the chord.

namespace planish {
namespace {

using Triangle = std::array<int, 3>;

int node_count(const TopoDS_Shape& solid) {
  int count = 0;
  for (TopExp_Explorer faces(solid, TopAbs_FACE); faces.More(); faces.Next()) {
    TopLoc_Location place;
    const Handle(Poly_Triangulation)
        own = BRep_Tool::Triangulation(TopoDS::Face(faces.Current()), place);
    if (!own.IsNull()) count += own->NbNodes();
  }
  return count;
}

/// Whether the nodes of a face along an edge lie on the edge's curve where they ought to. On faces
/// that it does not understand the kernel puts them elsewhere.
bool lies_on(const TopoDS_Edge& edge, const Poly_Triangulation& nodes,
             const Poly_PolygonOnTriangulation& row, const TopLoc_Location& place, double chord) {
  constexpr double kChords = 2.0;  // what the kernel misplaces is far off
  if (BRep_Tool::Degenerated(edge) || !row.HasParameters()) return true;
  const BRepAdaptor_Curve curve(edge);
  const double most = std::max(2.0 * BRep_Tool::Tolerance(edge), kChords * chord);
  for (int i = 1; i <= row.NbNodes(); ++i) {
    const gp_Pnt node = nodes.Node(row.Node(i)).Transformed(place);
    if (node.Distance(curve.Value(row.Parameters()->Value(i))) > most) return false;
  }
  return true;
}

/// Whether the kernel has triangles of the face whose border is that of the face.
bool is_meshed(const TopoDS_Face& face, double chord) {
  TopLoc_Location place;
  const Handle(Poly_Triangulation) own = BRep_Tool::Triangulation(face, place);
  if (own.IsNull()) return false;
  for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(edges.Current());
    const Handle(Poly_PolygonOnTriangulation)
        row = BRep_Tool::PolygonOnTriangulation(edge, own, place);
    if (row.IsNull() ? !BRep_Tool::Degenerated(edge) : !lies_on(edge, *own, *row, place, chord))
      return false;
  }
  return true;
}

/// Joins the kernel's triangles along edges and vertices: the kernel gives every face its own
/// nodes. Leaves out faces that the kernel has not meshed rightly.
class Welder {
 public:
  Welder(const TopoDS_Shape& solid, double chord) : same_(node_count(solid)) {
    for (TopExp_Explorer faces(solid, TopAbs_FACE); faces.More(); faces.Next(), ++face_count_)
      if (is_meshed(TopoDS::Face(faces.Current()), chord))
        add(TopoDS::Face(faces.Current()), face_count_);
  }

  /// The triangles over the remaining points, without those that have two corners at one point.
  MeshOfFaces mesh() {
    MeshOfFaces result;
    std::vector<int> number(raw_.mesh.points.size(), -1);
    const auto numbered = [&](int node) {
      int& n = number[same_.root(node)];
      if (n < 0) {
        n = static_cast<int>(result.mesh.points.size());
        result.mesh.points.push_back(raw_.mesh.points[same_.root(node)]);
      }
      return n;
    };
    for (std::size_t i = 0; i < raw_.face.size(); ++i) {
      const Triangle& t = raw_.mesh.triangles[i];
      const Triangle roots{same_.root(t[0]), same_.root(t[1]), same_.root(t[2])};
      if (roots[0] == roots[1] || roots[1] == roots[2] || roots[2] == roots[0]) continue;
      result.mesh.triangles.push_back({numbered(t[0]), numbered(t[1]), numbered(t[2])});
      result.face.push_back(raw_.face[i]);
    }
    return result;
  }

 private:
  void add(const TopoDS_Face& face, int number) {
    TopLoc_Location place;
    const Handle(Poly_Triangulation) own = BRep_Tool::Triangulation(face, place);
    const int first = static_cast<int>(raw_.mesh.points.size());
    brep::append_triangles(raw_, face, number);
    for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next())
      join(TopoDS::Edge(edges.Current()), own, place, first);
  }

  /// Unites the nodes of a face along an edge with those that other faces have there.
  void join(const TopoDS_Edge& edge, const Handle(Poly_Triangulation) & own,
            const TopLoc_Location& place, int first) {
    const Handle(Poly_PolygonOnTriangulation)
        polygon = BRep_Tool::PolygonOnTriangulation(edge, own, place);
    if (polygon.IsNull()) return;
    std::vector<int> row;
    for (int i = 1; i <= polygon->NbNodes(); ++i)
      row.push_back(first + polygon->Node(i) - 1);
    const auto& known = rows_.emplace(edges_.Add(edge), row).first->second;
    if (known.size() == row.size())
      for (std::size_t i = 0; i < row.size(); ++i)
        same_.unite(known[i], row[i]);
    join(TopExp::FirstVertex(edge), row.front());
    join(TopExp::LastVertex(edge), row.back());
  }

  void join(const TopoDS_Vertex& vertex, int node) {
    same_.unite(node_at_.emplace(vertices_.Add(vertex), node).first->second, node);
  }

  UnionFind same_;  ///< nodes at one point
  MeshOfFaces raw_;
  int face_count_ = 0;
  TopTools_IndexedMapOfShape edges_, vertices_;
  std::map<int, std::vector<int>> rows_;  ///< nodes along an edge, as the first face has them
  std::map<int, int> node_at_;            ///< a node at a vertex
};

Result<void> check_chord(double chord) {
  if (chord > 0.0) return {};
  return fail(refuse::chord_not_positive, {{"chord", chord, unit::mm}});
}

double area_of(const Mesh& mesh) {
  double sum = 0.0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3& a = mesh.points[t[0]];
    sum += 0.5 * (mesh.points[t[1]] - a).cross(mesh.points[t[2]] - a).norm();
  }
  return sum;
}

MeshOfFaces triangulated(const TopoDS_Shape& solid, double chord) {
  brep::triangulate(solid, chord);
  return Welder(solid, chord).mesh();
}

/// Of the body's solid as a whole. The kernel makes nothing of some full cones unless they may turn
/// by more.
MeshOfFaces surface_of(const Body& body, double chord) {
  MeshOfFaces first;
  for (const Angle turn : {Angle::degrees(10), Angle::degrees(17), Angle::degrees(25)}) {
    const TopoDS_Shape solid = brep::meshable(body.shape().solid);
    brep::triangulate(solid, chord, turn);
    MeshOfFaces surface = Welder(solid, chord).mesh();
    if (open_sides(surface.mesh).empty() && !surface.face.empty()) return surface;
    if (first.face.empty()) first = std::move(surface);
  }
  return first;
}

/// Closed, and of the body's volume but for a layer as thick as the chord.
Result<void> check_whole(const MeshOfFaces& surface, const Body& body, double chord) {
  if (const std::size_t open = open_sides(surface.mesh).size(); open > 0)
    return fail(refuse::mesh_open, {{"what", "body"}, {"count", open}});
  const double found = volume_of(surface.mesh), volume = body.volume();
  if (std::abs(found - volume) <= chord * area_of(surface.mesh)) return {};
  return fail(refuse::mesh_volume, {{"found", found, unit::mm3}, {"volume", volume, unit::mm3}});
}

}  // namespace

Result<MeshOfFaces> body_mesh(const Body& body, double chord) {
  auto surface = body_mesh_in_part(body, chord);
  if (!surface) return surface;
  return brep::guarded([&]() -> Result<MeshOfFaces> {
    if (auto whole = check_whole(*surface, body, chord); !whole) return pass_on(whole);
    return std::move(*surface);
  });
}

Result<MeshOfFaces> body_mesh_in_part(const Body& body, double chord) {
  if (auto sound = check_chord(chord); !sound) return pass_on(sound);
  return brep::guarded([&]() -> Result<MeshOfFaces> {
    MeshOfFaces surface = surface_of(body, chord);
    if (surface.face.empty()) return fail(refuse::mesh_empty);
    return surface;
  });
}

Result<Mesh> folded_mesh(const Sheet& sheet, double chord) {
  if (auto sound = check_chord(chord); !sound) return pass_on(sound);
  return brep::guarded([&]() -> Result<Mesh> {
    const auto solid = brep::thicken(sheet);
    if (!solid) return pass_on(solid);
    Mesh mesh = triangulated(*solid, chord).mesh;
    if (const std::size_t open = open_sides(mesh).size(); open > 0 || mesh.triangles.empty())
      return fail(refuse::mesh_open, {{"what", "folded solid"}, {"count", open}});
    return mesh;
  });
}

}  // namespace planish
