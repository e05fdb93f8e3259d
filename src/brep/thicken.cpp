#include "thicken.hpp"

#include "border_curve.hpp"
#include "kernel_check.hpp"
#include "kernel_points.hpp"
#include "refusals.hpp"
#include "sheet_corners.hpp"
#include "side_wall.hpp"
#include "solid_builder.hpp"
#include "valid_input.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/sheet/places.hpp>

#include <BRepGProp.hxx>
#include <BRep_Builder.hxx>
#include <GProp_GProps.hxx>
#include <Geom_Plane.hxx>
#include <Precision.hxx>
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

// The solid of a sheet, built and not sewn: faces on both skins, a wall along each free border,
// edges shared by what the sheet says of its joints. Where a mitre at a fold that ends inside an
// edge turns a wall over, its edges across the thickness cross; both are divided there, and the two
// halves look opposite ways. The result must be valid to the kernel, closed, and of positive
// volume.

namespace planish::brep {
namespace {

using Shape = BorderCurve::Shape;

std::string row_text(const BorderRef& ref) {
  return fmt::format("face {}, loop {}, border {}", index_of(ref.face), ref.loop, ref.border);
}

Result<void> check_inside_radii(const Sheet& sheet) {
  if (auto right = valid_input(sheet); !right) return right;
  for (const FaceId id : sheet.faces.ids())
    if (const double r = std::min(smallest_radius(sheet[id], Depths(sheet).first),
                                  smallest_radius(sheet[id], Depths(sheet).second));
        r < Precision::Confusion())
      return fail(refuse::no_inside_radius,
                  {{"bend", place_of(sheet, std::get<BendId>(sheet[id].part_of))},
                   {"face", place::pointer(pointer_to(id))},
                   {"radius", r, unit::mm}},
                  fmt::format("face {}", index_of(id)));
  return {};
}

/// Edges of one border: on the reference skin and on the other.
struct BorderEdges {
  BorderCurve border;
  CurvedWall wall;  ///< of curved free borders
  BuiltEdge reference, other;
};

/// Where the edges across the thickness at two corners cross, well inside both.
std::optional<Vec3> crossing_of(const CornerPoints& a, const CornerPoints& b) {
  const Vec3 u = a.other - a.reference, v = b.other - b.reference, w = b.reference - a.reference;
  const Vec3 n = u.cross(v);
  if (n.norm() <= tolerance::kFileDigits * u.norm() * v.norm()) return std::nullopt;
  const double s = w.cross(v).dot(n) / n.squaredNorm(), t = w.cross(u).dot(n) / n.squaredNorm();
  const Vec3 at = a.reference + s * u;
  const double apart = (at - (b.reference + t * v)).norm();
  constexpr double kEnd = 1e-3;  // a share of the edge: its halves are edges as well
  if (apart > Precision::Confusion() || std::min(s, t) < kEnd || std::max(s, t) > 1.0 - kEnd)
    return std::nullopt;
  return at;
}

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
        if (auto made = make_edges(border); !made) return pass_on(made);
    for (const FaceId face : sheet_.faces.ids())
      for (double depth : {depths_.first, depths_.second})
        make_skin(face, depth);
    for (const BorderId border : topology().borders())
      if (crossed_.contains(border))
        make_crossed_wall(border);
      else if (topology().is_free(border))
        make_wall(border);
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
      return fail(refuse::curved_border_at_mitre,
                  {{"border", place::pointer(pointer_to(topology()[border]))},
                   {"at", place::point(points_[corners_.is_sharp(start) ? start : end].reference)}},
                  row_text(topology()[border]));

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
    if (along.dot(points_[end].other - points_[start].other) <= 0.0 && !cross_wall(border))
      return fail(refuse::border_shorter_than_mitres,
                  {{"border", place::pointer(pointer_to(topology()[border]))},
                   {"length", along.norm(), unit::mm},
                   {"at", place::point(points_[start].reference)}},
                  row_text(topology()[border]));
    edges_[border].reference = builder_.straight_edge(reference_[start], reference_[end]);
    edges_[border].other = builder_.straight_edge(other_[start], other_[end]);
    return {};
  }

  /// The wall at the end of a fold that ends inside an edge turns over: its edges across the
  /// thickness, one of them the mitre's, cross. Both are divided there. False if they do not cross,
  /// or if one of them is divided already.
  bool cross_wall(BorderId border) {
    const int start = corners_.at_start(border), end = corners_.at_end(border);
    if (!topology().is_free(border) || crossing_.count(start) + crossing_.count(end) > 0)
      return false;
    const auto at = crossing_of(points_[start], points_[end]);
    if (!at) return false;
    const TopoDS_Vertex vertex = builder_.vertex(*at);
    crossing_.emplace(start, vertex);
    crossing_.emplace(end, vertex);
    crossed_.insert(border);
    return true;
  }

  /// The edge of a border as used by its own face; its curve is still in the face's (u, v).
  EdgeUse skin_use(BorderId border, double depth) const {
    const BorderEdges& edges = edges_[corners_.leader(border)];
    return {depth == depths_.first ? &edges.reference : &edges.other,
            curve_in_own_face(sheet_, corners_, border, edges.border, options_.shape_tolerance),
            corners_.leads(border)};
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

  /// Across the thickness, from the reference skin: one edge, or two where a wall turns over.
  const std::vector<BuiltEdge>& edges_across(int corner) {
    const auto [at, added] = across_.try_emplace(corner);
    if (!added) return at->second;
    const TopoDS_Vertex &from = reference_[corner], &to = other_[corner];
    if (const auto crossing = crossing_.find(corner); crossing != crossing_.end())
      at->second = {builder_.straight_edge(from, crossing->second),
                    builder_.straight_edge(crossing->second, to)};
    else
      at->second = {builder_.straight_edge(from, to)};
    return at->second;
  }

  /// Both halves of a wall that turns over look opposite ways.
  void make_crossed_wall(BorderId border) {
    const int start = corners_.at_start(border), end = corners_.at_end(border);
    const BorderEdges& edges = edges_[border];
    const Vec3& corner = points_[start].reference;
    const Vec3 normal = (points_[end].reference - corner)
                            .cross(points_[start].other - corner)
                            .normalized();
    const Vec3 outward = outward_across(face_at(border), edges.border, 0.5 * edges.border.length);
    const int outside = normal.dot(outward) > 0.0 ? 1 : -1;
    const Handle(Geom_Surface) plane = new Geom_Plane(gp_Pnt(corner.x(), corner.y(), corner.z()),
                                                      gp_Dir(normal.x(), normal.y(), normal.z()));
    const auto &at_start = edges_across(start), &at_end = edges_across(end);
    builder_.face(
        plane, outside,
        {{{&edges.reference, {}, false}, {&at_start[0], {}, true}, {&at_end[0], {}, false}}});
    builder_.face(plane, -outside,
                  {{{&at_start[1], {}, true}, {&edges.other, {}, true}, {&at_end[1], {}, false}}});
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
    std::vector<EdgeUse> loop{{&edges.reference, wall.on_reference, false}};
    for (const BuiltEdge& edge : edges_across(start))
      loop.push_back({&edge, wall.at_start, true});
    loop.push_back({&edges.other, wall.on_other, true});
    const auto& at_end = edges_across(end);
    for (auto edge = at_end.rbegin(); edge != at_end.rend(); ++edge)
      loop.push_back({&*edge, wall.at_end, false});
    builder_.face(wall.surface, outside, {loop});
  }

  const Sheet& sheet_;
  Depths depths_;
  const ThickenOptions& options_;
  SheetCorners corners_;
  std::vector<CornerPoints> points_;
  SolidBuilder builder_;
  std::vector<TopoDS_Vertex> reference_, other_;
  IdVector<BorderId, BorderEdges> edges_;
  std::map<int, std::vector<BuiltEdge>> across_;  // by corner
  std::set<BorderId> crossed_;                    // whose walls turn over
  std::map<int, TopoDS_Vertex> crossing_;         // where an edge across is divided
};

Result<TopoDS_Solid> checked_solid(const TopoDS_Shell& shell) {
  BRep_Builder builder;
  TopoDS_Solid solid;
  builder.MakeSolid(solid);
  builder.Add(solid, shell);
  GProp_GProps properties;
  BRepGProp::VolumeProperties(solid, properties);
  if (!(properties.Mass() > 0.0))
    return fail(refuse::solid_inside_out, {{"volume", properties.Mass(), unit::mm3}});
  if (!is_sound(shell)) return fail(refuse::solid_invalid);
  return solid;
}

}  // namespace

Result<TopoDS_Solid> thicken(const Sheet& sheet, const ThickenOptions& options) {
  if (auto sound = check_inside_radii(sheet); !sound) return pass_on(sound);
  SheetCorners corners(sheet);
  auto points = corner_points(sheet, corners);
  if (!points) return pass_on(points);
  auto shell = Thickener(sheet, options, std::move(corners), std::move(*points)).shell();
  if (!shell) return pass_on(shell);
  return checked_solid(*shell);
}

}  // namespace planish::brep
