#include "reference_shell.hpp"

#include "border_curve.hpp"
#include "refusals.hpp"
#include "sheet_corners.hpp"
#include "solid_builder.hpp"
#include "valid_input.hpp"

#include <planish/base/union_find.hpp>
#include <planish/sheet/places.hpp>

#include <BRepCheck_Analyzer.hxx>
#include <BRep_Builder.hxx>
#include <Precision.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shell.hxx>

#include <algorithm>
#include <utility>
#include <vector>

// The reference surface of a sheet as an open shell. Corners that joints unite become one vertex in
// the middle of theirs, a joint one edge, led by one of its borders; nothing is sewn. Joints whose
// ends gape by more than the tolerance are left open before, as they would tear the surface. Parts
// that no joint connects are shells of their own.

namespace planish::brep {
namespace {

Result<void> check_reference_radii(const Sheet& sheet) {
  if (auto right = valid_input(sheet); !right) return right;
  for (const FaceId id : sheet.faces.ids())
    if (const double r = smallest_radius(sheet[id], 0.0); r < Precision::Confusion())
      return fail(refuse::no_reference_radius,
                  {{"bend", place_of(sheet, std::get<BendId>(sheet[id].part_of))},
                   {"face", place::pointer(pointer_to(id))},
                   {"radius", r, unit::mm}},
                  "face " + std::to_string(index_of(id)));
  return {};
}

/// The larger distance between the ends of a joint's two borders.
double gap_of(const Sheet& sheet, const Joint& joint) {
  const auto end = [&](const BorderRef& ref, bool last) {
    const Curve2& curve = sheet[ref].curve;
    return skin_point(sheet[ref.face], last ? end_of(curve) : start_of(curve));
  };
  return std::max((end(joint.a, false) - end(joint.b, true)).norm(),
                  (end(joint.a, true) - end(joint.b, false)).norm());
}

Sheet without_gaping_joints(Sheet sheet, double tolerance) {
  std::erase_if(sheet.joints, [&](const Joint& joint) { return gap_of(sheet, joint) > tolerance; });
  return sheet;
}

/// Faces that joints connect, in the sheet's order.
std::vector<std::vector<int>> connected_faces(const Sheet& sheet) {
  UnionFind sets(static_cast<int>(sheet.faces.size()));
  for (const Joint& joint : sheet.joints)
    sets.unite(index_of(joint.a.face), index_of(joint.b.face));
  std::vector<std::vector<int>> parts;
  std::vector<int> part_of(sheet.faces.size(), -1);  // by the smallest face of the set
  for (const FaceId face : sheet.faces.ids()) {
    int& part = part_of[sets.root(index_of(face))];
    if (part < 0) {
      part = static_cast<int>(parts.size());
      parts.emplace_back();
    }
    parts[part].push_back(index_of(face));
  }
  return parts;
}

class ShellMaker {
 public:
  ShellMaker(const Sheet& sheet, const ReferenceShellOptions& options)
      : sheet_(sheet), options_(options), corners_(sheet) {}

  /// One shell for each set of connected faces.
  std::vector<TopoDS_Shell> shells() {
    make_vertices();
    edges_.resize(topology().border_count());
    for (const BorderId border : topology().borders())
      if (corners_.leads(border)) make_edge(border);
    for (const FaceId face : sheet_.faces.ids())
      make_face(face);
    return mapped(connected_faces(sheet_),
                  [&](const std::vector<int>& faces) { return builder_.open_shell(faces); });
  }

 private:
  struct BorderEdge {
    BorderCurve border;
    BuiltEdge edge;
  };

  const Topology& topology() const { return corners_.topology(); }
  const Face& face_at(BorderId border) const { return sheet_[topology()[border].face]; }
  const Curve2& curve_at(BorderId border) const { return sheet_[topology()[border]].curve; }

  void make_vertices() {
    std::vector<Vec3> sum(corners_.count(), Vec3::Zero());
    std::vector<int> count(corners_.count(), 0);
    for (const BorderId border : topology().borders()) {
      const int corner = corners_.at_start(border);
      sum[corner] += skin_point(face_at(border), start_of(curve_at(border)));
      ++count[corner];
    }
    for (int corner = 0; corner < corners_.count(); ++corner)
      vertices_.push_back(builder_.vertex(sum[corner] / count[corner]));
  }

  void make_edge(BorderId border) {
    BorderEdge& made = edges_[border];
    const TopoDS_Vertex &start = vertices_[corners_.at_start(border)],
                        &end = vertices_[corners_.at_end(border)];
    made.border = border_curve(face_at(border), curve_at(border), options_.shape_tolerance);
    made.edge = made.border.shape == BorderCurve::Shape::line
                    ? builder_.straight_edge(start, end)
                    : builder_.edge(space_curve_below(face_at(border), made.border, 0.0,
                                                      options_.fit_tolerance),
                                    made.border.length, start, end);
  }

  /// The edge of a border as used by its own face; its curve is still in the face's (u, v).
  EdgeUse use_of(BorderId border) const {
    const BorderEdge& made = edges_[corners_.leader(border)];
    return {&made.edge,
            curve_in_own_face(sheet_, corners_, border, made.border, options_.shape_tolerance),
            corners_.leads(border)};
  }

  void make_face(FaceId id) {
    const Face& face = sheet_[id];
    const SkinSurface skin = skin_surface(face, 0.0, options_.fit_tolerance);
    std::vector<std::vector<EdgeUse>> loops;
    for (int l = 0; l < std::ssize(face.loops); ++l) {
      std::vector<EdgeUse>& loop = loops.emplace_back();
      for (int b = 0; b < std::ssize(face.loops[l]); ++b) {
        loop.push_back(use_of(topology().id_of({id, l, b})));
        if (EdgeUse& use = loop.back(); !use.curve.IsNull())
          use.curve = skin.carried(use.curve, use.edge->length);
      }
    }
    builder_.face(skin.surface, face.sense, loops);
  }

  const Sheet& sheet_;
  const ReferenceShellOptions& options_;
  SheetCorners corners_;
  SolidBuilder builder_;
  std::vector<TopoDS_Vertex> vertices_;
  IdVector<BorderId, BorderEdge> edges_;
};

}  // namespace

Result<TopoDS_Shape> reference_shell(const Sheet& given, const ReferenceShellOptions& options) {
  if (auto sound = check_reference_radii(given); !sound) return pass_on(sound);
  const Sheet sheet = without_gaping_joints(given, options.joint_tolerance);
  const std::vector<TopoDS_Shell> shells = ShellMaker(sheet, options).shells();
  for (const TopoDS_Shell& shell : shells)
    if (!BRepCheck_Analyzer(shell).IsValid()) return fail(refuse::surface_invalid);
  if (shells.size() == 1) return TopoDS_Shape(shells.front());
  TopoDS_Compound all;
  BRep_Builder builder;
  builder.MakeCompound(all);
  for (const TopoDS_Shell& shell : shells)
    builder.Add(all, shell);
  return TopoDS_Shape(all);
}

}  // namespace planish::brep
