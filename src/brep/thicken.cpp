#include "thicken.hpp"

#include "border_curve.hpp"
#include "kernel_check.hpp"
#include "kernel_points.hpp"
#include "sheet_corners.hpp"
#include "side_wall.hpp"
#include "solid_builder.hpp"

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
  Thickener(const Sheet& sheet, const ThickenOptions& options, SheetCorners corners,
            std::vector<CornerPoints> points)
      : sheet_(sheet),
        depths_(sheet),
        options_(options),
        corners_(std::move(corners)),
        points_(std::move(points)) {}

  Result<TopoDS_Shell> shell() {
    make_vertices();
    edges_.resize(topology().border_count());
    for (const BorderId border : topology().borders())
      if (corners_.leads(border))
        if (auto made = make_edges(border); !made) return tl::unexpected(made.error());
    for (const FaceId face : sheet_.faces.ids())
      for (double depth : {depths_.first, depths_.second})
        make_skin(face, depth);
    for (const BorderId border : topology().borders())
      if (topology().is_free(border)) make_wall(border);
    return builder_.shell();
  }

 private:
  void make_vertices() {
    for (const CornerPoints& point : points_) {
      reference_.push_back(builder_.vertex(point.reference));
      other_.push_back(builder_.vertex(point.other));
    }
  }

  const Topology& topology() const { return corners_.topology(); }
  const Face& face_at(BorderId border) const { return sheet_[topology()[border].face]; }
  const Curve2& curve_at(BorderId border) const { return sheet_[topology()[border]].curve; }

  Result<void> make_edges(BorderId border) {
    const Face& face = face_at(border);
    const int start = corners_.at_start(border), end = corners_.at_end(border);
    BorderEdges& edges = edges_[border];
    edges.border = border_curve(face, curve_at(border), options_.shape_tolerance);
    if (edges.border.shape == Shape::line) return make_straight(border, start, end);
    if (corners_.is_sharp(start) || corners_.is_sharp(end))
      return fail(ErrorCode::unsupported_shape,
                  "A curved border ends at a sharp bend; only straight ones can be mitred.",
                  place(topology()[border]));

    if (topology().is_free(border))
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

  Result<void> make_straight(BorderId border, int start, int end) {
    const Vec3 along = points_[end].reference - points_[start].reference;
    if (along.dot(points_[end].other - points_[start].other) <= 0.0)
      return fail(ErrorCode::unsupported_shape,
                  fmt::format("A border of {:.3g} mm is shorter than the mitres of the sharp bends "
                              "at its ends.",
                              along.norm()),
                  place(topology()[border]));
    edges_[border].reference = builder_.straight_edge(reference_[start], reference_[end]);
    edges_[border].other = builder_.straight_edge(other_[start], other_[end]);
    return {};
  }

  /// The edge of a border as used by its own face; its curve is still in the face's (u, v).
  EdgeUse skin_use(BorderId border, double depth) const {
    const BorderId leader = corners_.leader(border);
    const bool leads = leader == border;
    const BorderEdges& edges = edges_[leader];
    EdgeUse use{depth == depths_.first ? &edges.reference : &edges.other, edges.border.uv, leads};
    if (std::holds_alternative<Frame>(face_at(border).surface))
      use.curve.Nullify();
    else if (!leads)
      use.curve = across_joint(face_at(leader), edges.border, face_at(border),
                               reversed(curve_at(border)), options_.shape_tolerance);
    return use;
  }

  void make_skin(FaceId id, double depth) {
    const Face& face = sheet_[id];
    const SkinSurface skin = skin_surface(face, depth, options_.fit_tolerance);
    const bool outer_skin = depth == depths_.first;
    std::vector<std::vector<EdgeUse>> loops;
    for (int l = 0; l < std::ssize(face.loops); ++l) {
      std::vector<EdgeUse>& loop = loops.emplace_back();
      for (int b = 0; b < std::ssize(face.loops[l]); ++b) {
        EdgeUse use = skin_use(topology().id_of({id, l, b}), depth);
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

  void make_wall(BorderId border) {
    const int start = corners_.at_start(border), end = corners_.at_end(border);
    const BorderEdges& edges = edges_[border];
    const SideWall wall = edges.border.shape == Shape::line
                              ? straight_wall({points_[start].reference, points_[end].reference,
                                               points_[start].other, points_[end].other},
                                              outward_across(face_at(border), edges.border,
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
  SheetCorners corners_;
  std::vector<CornerPoints> points_;
  SolidBuilder builder_;
  std::vector<TopoDS_Vertex> reference_, other_;
  IdVector<BorderId, BorderEdges> edges_;
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
  if (!is_sound(shell))
    return fail(ErrorCode::internal, "The CAD kernel finds the folded solid invalid.");
  return solid;
}

}  // namespace

Result<TopoDS_Solid> thicken(const Sheet& sheet, const ThickenOptions& options) {
  if (auto sound = check_input(sheet); !sound) return tl::unexpected(sound.error());
  SheetCorners corners(sheet);
  auto points = corner_points(sheet, corners);
  if (!points) return tl::unexpected(points.error());
  auto shell = Thickener(sheet, options, std::move(corners), std::move(*points)).shell();
  if (!shell) return tl::unexpected(shell.error());
  return checked_solid(*shell);
}

}  // namespace planish::brep
