#include "reference_shell.hpp"

#include "border_curve.hpp"
#include "sheet_topology.hpp"
#include "solid_builder.hpp"

#include <BRepCheck_Analyzer.hxx>
#include <BRep_Builder.hxx>
#include <Precision.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shell.hxx>
#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace planish::brep {
namespace {

Result<void> check_input(const Sheet& sheet) {
  if (const auto right = check(sheet); !right)
    return fail(ErrorCode::invalid_input, right.error().message, right.error().where);
  for (const FaceId id : sheet.faces.ids())
    if (const double r = smallest_radius(sheet[id], 0.0); r < Precision::Confusion())
      return fail(
          ErrorCode::unsupported_shape,
          fmt::format(
              "A bend's reference surface has a radius of {:.3g} mm; it must be above zero.", r),
          fmt::format("face {}", index_of(id)));
  return {};
}

/// Distance of the ends of a joint's two borders, the larger one.
double gap_of(const Sheet& sheet, const Joint& joint) {
  const auto end = [&](const BorderRef& ref, bool last) {
    const Curve2& curve = border_of(sheet, ref).curve;
    return skin_point(face_of(sheet, ref), last ? end_of(curve) : start_of(curve));
  };
  return std::max((end(joint.a, false) - end(joint.b, true)).norm(),
                  (end(joint.a, true) - end(joint.b, false)).norm());
}

/// Joints that name no border are kept: the topology refuses them by name.
Sheet without_gaping_joints(Sheet sheet, double tolerance) {
  std::erase_if(sheet.joints, [&](const Joint& joint) {
    return sheet.has(joint.a) && sheet.has(joint.b) && gap_of(sheet, joint) > tolerance;
  });
  return sheet;
}

/// Faces that joints connect, in the sheet's order.
std::vector<std::vector<int>> connected_faces(const Sheet& sheet) {
  std::vector<std::vector<int>> neighbours(sheet.faces.size());
  for (const Joint& joint : sheet.joints) {
    neighbours[index_of(joint.a.face)].push_back(index_of(joint.b.face));
    neighbours[index_of(joint.b.face)].push_back(index_of(joint.a.face));
  }
  std::vector<std::vector<int>> parts;
  std::vector<bool> seen(sheet.faces.size(), false);
  for (int first = 0; first < static_cast<int>(sheet.faces.size()); ++first) {
    if (seen[first]) continue;
    std::vector<int> part{first};
    seen[first] = true;
    for (std::size_t i = 0; i < part.size(); ++i)
      for (const int next : neighbours[part[i]])
        if (!seen[next]) {
          seen[next] = true;
          part.push_back(next);
        }
    std::ranges::sort(part);
    parts.push_back(std::move(part));
  }
  return parts;
}

class ShellMaker {
 public:
  ShellMaker(const Sheet& sheet, const ReferenceShellOptions& options, SheetTopology topology)
      : sheet_(sheet), options_(options), topology_(std::move(topology)) {}

  /// One for all faces that hang together.
  std::vector<TopoDS_Shell> shells() {
    make_vertices();
    edges_.resize(topology_.borders.size());
    for (std::size_t row = 0; row < topology_.borders.size(); ++row)
      if (topology_.borders[row].leads) make_edge(static_cast<int>(row));
    int first_row = 0;
    for (const Face& face : sheet_.faces)
      first_row = make_face(face, first_row);
    std::vector<TopoDS_Shell> shells;
    for (const std::vector<int>& faces : connected_faces(sheet_))
      shells.push_back(builder_.open_shell(faces));
    return shells;
  }

 private:
  struct BorderEdge {
    BorderCurve border;
    BuiltEdge edge;
  };

  const Face& face_at(int row) const { return face_of(sheet_, topology_.borders[row].ref); }
  const Border& border_at(int row) const { return border_of(sheet_, topology_.borders[row].ref); }

  void make_vertices() {
    std::vector<Vec3> sum(topology_.corners, Vec3::Zero());
    std::vector<int> count(topology_.corners, 0);
    for (const auto& node : topology_.borders) {
      sum[node.corner] += skin_point(face_of(sheet_, node.ref),
                                     start_of(border_of(sheet_, node.ref).curve));
      ++count[node.corner];
    }
    for (int corner = 0; corner < topology_.corners; ++corner)
      vertices_.push_back(builder_.vertex(sum[corner] / count[corner]));
  }

  void make_edge(int row) {
    BorderEdge& made = edges_[row];
    const TopoDS_Vertex &start = vertices_[topology_.borders[row].corner],
                        &end = vertices_[topology_.end_corner(row)];
    made.border = border_curve(face_at(row), border_at(row).curve, options_.shape_tolerance);
    made.edge = made.border.shape == BorderCurve::Shape::line
                    ? builder_.straight_edge(start, end)
                    : builder_.edge(
                          space_curve_below(face_at(row), made.border, 0.0, options_.fit_tolerance),
                          made.border.length, start, end);
  }

  /// The edge of a border as its own face uses it; its curve still in the face's (u, v).
  EdgeUse use_of(int row) const {
    const auto& node = topology_.borders[row];
    const int leader = node.leads ? row : node.mate;
    const BorderEdge& made = edges_[leader];
    EdgeUse use{&made.edge, made.border.uv, node.leads};
    if (std::holds_alternative<Frame>(face_at(row).surface))
      use.curve.Nullify();
    else if (!node.leads)
      use.curve = across_joint(face_at(leader), made.border, face_at(row),
                               reversed(border_at(row).curve), options_.shape_tolerance);
    return use;
  }

  /// Returns the row of the next face.
  int make_face(const Face& face, int row) {
    const SkinSurface skin = skin_surface(face, 0.0, options_.fit_tolerance);
    std::vector<std::vector<EdgeUse>> loops;
    for (const BorderLoop& borders : face.loops) {
      std::vector<EdgeUse>& loop = loops.emplace_back();
      for (std::size_t b = 0; b < borders.size(); ++b, ++row) {
        loop.push_back(use_of(row));
        if (EdgeUse& use = loop.back(); !use.curve.IsNull())
          use.curve = skin.carried(use.curve, use.edge->length);
      }
    }
    builder_.face(skin.surface, face.sense, loops);
    return row;
  }

  const Sheet& sheet_;
  const ReferenceShellOptions& options_;
  SheetTopology topology_;
  SolidBuilder builder_;
  std::vector<TopoDS_Vertex> vertices_;
  std::vector<BorderEdge> edges_;
};

}  // namespace

Result<TopoDS_Shape> reference_shell(const Sheet& given, const ReferenceShellOptions& options) {
  if (auto sound = check_input(given); !sound) return tl::unexpected(sound.error());
  const Sheet sheet = without_gaping_joints(given, options.joint_tolerance);
  auto topology = sheet_topology(sheet);
  if (!topology) return tl::unexpected(topology.error());
  const std::vector<TopoDS_Shell> shells = ShellMaker(sheet, options, std::move(*topology))
                                               .shells();
  for (const TopoDS_Shell& shell : shells)
    if (!BRepCheck_Analyzer(shell).IsValid())
      return fail(ErrorCode::internal, "The CAD kernel finds the folded surface invalid.");
  if (shells.size() == 1) return TopoDS_Shape(shells.front());
  TopoDS_Compound all;
  BRep_Builder builder;
  builder.MakeCompound(all);
  for (const TopoDS_Shell& shell : shells)
    builder.Add(all, shell);
  return TopoDS_Shape(all);
}

}  // namespace planish::brep
