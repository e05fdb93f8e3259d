#include "thicken.hpp"

#include "border_curve.hpp"
#include "kernel_points.hpp"
#include "sheet_topology.hpp"
#include "side_wall.hpp"
#include "solid_builder.hpp"

#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRep_Builder.hxx>
#include <GProp_GProps.hxx>
#include <Precision.hxx>
#include <fmt/format.h>

#include <array>
#include <map>

namespace planish::brep {
namespace {

using Shape = BorderCurve::Shape;

std::string place(const BorderRef& ref) {
  return fmt::format("face {}, loop {}, border {}", index_of(ref.face), ref.loop, ref.border);
}

Result<void> check_input(const Sheet& sheet) {
  if (const auto right = check(sheet); !right)
    return fail(ErrorCode::invalid_input, right.error().message, right.error().where);
  for (const FaceId id : sheet.faces.ids())
    if (const double r = std::min(smallest_radius(sheet[id], Depths(sheet).first),
                                  smallest_radius(sheet[id], Depths(sheet).second));
        r < Precision::Confusion())
      return fail(ErrorCode::unsupported_shape,
                  fmt::format("A bend has an inside radius of {:.3g} mm; a solid needs one above "
                              "zero.",
                              r),
                  fmt::format("face {}", index_of(id)));
  return {};
}

/// Edges of one border: on the reference skin and on the other.
struct BorderEdges {
  BorderCurve border;
  CurvedWall wall;  ///< of curved free borders
  BuiltEdge reference, other;
};

class Thickener {
 public:
  Thickener(const Sheet& sheet, const ThickenOptions& options, SheetTopology topology,
            std::vector<CornerPoints> corners)
      : sheet_(sheet),
        depths_(sheet),
        options_(options),
        topology_(std::move(topology)),
        points_(std::move(corners)) {}

  Result<TopoDS_Shell> shell() {
    make_vertices();
    edges_.resize(topology_.borders.size());
    for (std::size_t row = 0; row < topology_.borders.size(); ++row)
      if (topology_.borders[row].leads)
        if (auto made = make_edges(static_cast<int>(row)); !made)
          return tl::unexpected(made.error());
    int first_row = 0;
    for (const Face& face : sheet_.faces) {
      for (double depth : {depths_.first, depths_.second})
        make_skin(face, first_row, depth);
      for (const BorderLoop& loop : face.loops)
        first_row += static_cast<int>(loop.size());
    }
    for (std::size_t row = 0; row < topology_.borders.size(); ++row)
      if (topology_.borders[row].mate < 0) make_wall(static_cast<int>(row));
    return builder_.shell();
  }

 private:
  void make_vertices() {
    for (const CornerPoints& point : points_) {
      reference_.push_back(builder_.vertex(point.reference));
      other_.push_back(builder_.vertex(point.other));
    }
  }

  const Face& face_at(int row) const { return face_of(sheet_, topology_.borders[row].ref); }
  const Border& border_at(int row) const { return border_of(sheet_, topology_.borders[row].ref); }

  Result<void> make_edges(int row) {
    const Face& face = face_at(row);
    const int start = topology_.borders[row].corner, end = topology_.end_corner(row);
    BorderEdges& edges = edges_[row];
    edges.border = border_curve(face, border_at(row).curve, options_.shape_tolerance);
    if (edges.border.shape == Shape::line) return make_straight(row, start, end);
    if (topology_.sharp[start] || topology_.sharp[end])
      return fail(ErrorCode::unsupported_shape,
                  "A curved border ends at a sharp bend; only straight ones can be mitred.",
                  place(topology_.borders[row].ref));

    if (topology_.borders[row].mate < 0)
      edges.wall = curved_wall(face, edges.border, depths_, options_.fit_tolerance);
    const auto curve = [&](const Handle(Geom_Curve) & fitted, double depth) {
      return fitted.IsNull() ? space_curve_below(face, edges.border, depth, options_.fit_tolerance)
                             : fitted;
    };
    const double length = edges.border.length;
    edges.reference = builder_.edge(curve(edges.wall.reference_edge, depths_.first), length,
                                    reference_[start], reference_[end]);
    edges.other = builder_.edge(curve(edges.wall.other_edge, depths_.second), length, other_[start],
                                other_[end]);
    return {};
  }

  Result<void> make_straight(int row, int start, int end) {
    const Vec3 along = points_[end].reference - points_[start].reference;
    if (along.dot(points_[end].other - points_[start].other) <= 0.0)
      return fail(ErrorCode::unsupported_shape,
                  fmt::format("A border of {:.3g} mm is shorter than the mitres of the sharp bends "
                              "at its ends.",
                              along.norm()),
                  place(topology_.borders[row].ref));
    edges_[row].reference = builder_.straight_edge(reference_[start], reference_[end]);
    edges_[row].other = builder_.straight_edge(other_[start], other_[end]);
    return {};
  }

  /// The edge of a border as its own face uses it; its curve still in the face's (u, v).
  EdgeUse skin_use(int row, double depth) const {
    const auto& node = topology_.borders[row];
    const int leader = node.leads ? row : node.mate;
    const BorderEdges& edges = edges_[leader];
    EdgeUse use{depth == depths_.first ? &edges.reference : &edges.other, edges.border.uv,
                node.leads};
    if (std::holds_alternative<Frame>(face_at(row).surface))
      use.curve.Nullify();
    else if (!node.leads)
      use.curve = across_joint(face_at(leader), edges.border, face_at(row),
                               reversed(border_at(row).curve), options_.shape_tolerance);
    return use;
  }

  void make_skin(const Face& face, int first_row, double depth) {
    const SkinSurface skin = skin_surface(face, depth, options_.fit_tolerance);
    const bool outer_skin = depth == depths_.first;
    std::vector<std::vector<EdgeUse>> loops;
    int row = first_row;
    for (const BorderLoop& borders : face.loops) {
      std::vector<EdgeUse>& loop = loops.emplace_back();
      for (std::size_t b = 0; b < borders.size(); ++b, ++row) {
        EdgeUse use = skin_use(row, depth);
        if (!use.curve.IsNull()) use.curve = skin.carried(use.curve, use.edge->length);
        // Seen from outside, the other skin's loops run the other way.
        if (outer_skin) {
          loop.push_back(use);
        } else {
          use.forward = !use.forward;
          loop.insert(loop.begin(), use);
        }
      }
    }
    builder_.face(skin.surface, outer_skin ? face.sense : -face.sense, loops);
  }

  const BuiltEdge* edge_across(int corner) {
    const auto [at, added] = across_.try_emplace(corner);
    if (added) at->second = builder_.straight_edge(reference_[corner], other_[corner]);
    return &at->second;
  }

  void make_wall(int row) {
    const int start = topology_.borders[row].corner, end = topology_.end_corner(row);
    const BorderEdges& edges = edges_[row];
    const SideWall wall = edges.border.shape == Shape::line
                              ? straight_wall({points_[start].reference, points_[end].reference,
                                               points_[start].other, points_[end].other},
                                              outward_across(face_at(row), edges.border,
                                                             0.5 * edges.border.length),
                                              options_.shape_tolerance)
                              : edges.wall.wall;
    gp_Pnt p;
    gp_Vec du, dv;
    wall.surface->D1(wall.middle.x(), wall.middle.y(), p, du, dv);
    const int outside = vector_of(du.Crossed(dv)).dot(wall.outward) > 0 ? 1 : -1;
    builder_.face(wall.surface, outside,
                  {{{&edges.reference, wall.on_reference, false},
                    {edge_across(start), wall.at_start, true},
                    {&edges.other, wall.on_other, true},
                    {edge_across(end), wall.at_end, false}}});
  }

  const Sheet& sheet_;
  Depths depths_;
  const ThickenOptions& options_;
  SheetTopology topology_;
  std::vector<CornerPoints> points_;
  SolidBuilder builder_;
  std::vector<TopoDS_Vertex> reference_, other_;
  std::vector<BorderEdges> edges_;
  std::map<int, BuiltEdge> across_;
};

Result<TopoDS_Solid> checked_solid(const TopoDS_Shell& shell) {
  BRep_Builder builder;
  TopoDS_Solid solid;
  builder.MakeSolid(solid);
  builder.Add(solid, shell);
  GProp_GProps properties;
  BRepGProp::VolumeProperties(solid, properties);
  if (!(properties.Mass() > 0.0))
    return fail(ErrorCode::internal,
                fmt::format("The folded solid has a volume of {:.6g} mm³: its faces point inwards.",
                            properties.Mass()));
  if (!BRepCheck_Analyzer(solid).IsValid())
    return fail(ErrorCode::internal, "The CAD kernel finds the folded solid invalid.");
  return solid;
}

}  // namespace

Result<TopoDS_Solid> thicken(const Sheet& sheet, const ThickenOptions& options) {
  if (auto sound = check_input(sheet); !sound) return tl::unexpected(sound.error());
  auto topology = sheet_topology(sheet);
  if (!topology) return tl::unexpected(topology.error());
  auto corners = corner_points(sheet, *topology);
  if (!corners) return tl::unexpected(corners.error());
  auto shell = Thickener(sheet, options, std::move(*topology), std::move(*corners)).shell();
  if (!shell) return tl::unexpected(shell.error());
  return checked_solid(*shell);
}

}  // namespace planish::brep
