#include "shape.hpp"

#include <planish/geometry/region.hpp>
#include <planish/inspect/findings.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace planish::studio {
namespace {

using Numbers = std::vector<std::uint32_t>;

std::uint32_t count_of(std::size_t size) { return static_cast<std::uint32_t>(size); }

void append(std::vector<float>& to, const Vec2& p) {
  to.push_back(static_cast<float>(p.x()));
  to.push_back(static_cast<float>(p.y()));
}

void append(std::vector<float>& to, const Segment& line) {
  append(to, line.a);
  append(to, line.b);
}

std::uint32_t row_of(const Sheet&, FlangeId flange) {
  return static_cast<std::uint32_t>(index_of(flange));
}

std::uint32_t row_of(const Sheet& sheet, BendId bend) {
  return count_of(sheet.flanges.size() + static_cast<std::size_t>(index_of(bend)));
}

Json faces_json(const Sheet& sheet, const std::vector<FaceId>& faces) {
  Json json = Json::array();
  for (const FaceId id : faces) {
    const Face& face = sheet[id];
    if (face.source_face) json.push_back(*face.source_face);
    for (const int number : face.merged_faces)
      if (number != face.source_face) json.push_back(number);
  }
  return json;
}

void add_parts(Shape& shape, const Sheet& sheet) {
  for (const FlangeId id : sheet.flanges.ids())
    shape.parts.push_back({{"name", fmt::format("F{}", index_of(id) + 1)},
                           {"kind", "flange"},
                           {"faces", faces_json(sheet, sheet[id].faces)}});
  for (const BendId id : sheet.bends.ids())
    shape.parts.push_back({{"name", fmt::format("B{}", index_of(id) + 1)},
                           {"kind", "bend"},
                           {"angle", sheet[id].angle.degrees()},
                           {"faces", faces_json(sheet, sheet[id].faces)}});
}

void add_directions(Shape& shape, const Sheet& sheet, const FlatPattern& flat) {
  for (const FlatBend& bend : flat.bends)
    shape.parts[row_of(sheet, bend.bend)]["direction"] = bend.direction == BendDirection::up
                                                             ? "up"
                                                             : "down";
}

/// Where flanges are in space, exactly: of a flange of several faces the first one's.
void add_places(Shape& shape, const Sheet& sheet, const Layout& layout) {
  for (const FlangeId id : sheet.flanges.ids())
    if (!sheet[id].faces.empty())
      shape.parts[row_of(sheet, id)]["place"] = rows_json(
          flange_in_space(sheet, layout, sheet[id].faces.front()));
}

struct PolygonArrays {
  std::vector<float> points;
  Numbers ring_starts{0}, polygon_starts{0}, facet_starts{0};

  void add_ring(const std::vector<Vec2>& ring) {
    for (const Vec2& p : ring)
      append(points, p);
    ring_starts.push_back(count_of(points.size() / 2));
  }
  void add_facet(const std::vector<Polygon>& polygons) {
    for (const Polygon& polygon : polygons) {
      add_ring(polygon.outer);
      for (const auto& hole : polygon.holes)
        add_ring(hole);
      polygon_starts.push_back(count_of(ring_starts.size() - 1));
    }
    facet_starts.push_back(count_of(polygon_starts.size() - 1));
  }
};

/// What the borders are, exactly: their lengths, the circles on which arcs lie, and the features
/// that they outline, which are numbered as in the pattern.
void add_borders(Shape& shape, const std::vector<FacetBorder>& borders) {
  std::vector<float> lengths, circles;
  std::vector<std::int32_t> features;
  for (const auto& [curve, feature] : borders) {
    features.push_back(feature ? static_cast<std::int32_t>(index_of(*feature)) : -1);
    lengths.push_back(static_cast<float>(length(curve)));
    const auto* arc = std::get_if<Arc>(&curve);
    append(circles, arc ? arc->center : Vec2::Zero().eval());
    circles.push_back(arc ? static_cast<float>(arc->radius) : 0.0F);
    circles.push_back(arc ? static_cast<float>(arc->sweep) : 0.0F);
  }
  shape.add("edge_length", lengths);
  shape.add("edge_circle", circles);
  shape.add("edge_feature", features);
}

void add_facets(Shape& shape, const Sheet& sheet, const Facets& facets) {
  PolygonArrays polygons;
  std::vector<std::int32_t> parents;
  std::vector<float> hinges, angles, edges;
  Numbers parts, edge_facets, edge_numbers;
  for (const Facet& facet : facets.facets) {
    polygons.add_facet(facet.polygons);
    parents.push_back(facet.parent.value_or(-1));
    append(hinges, facet.hinge);
    angles.push_back(static_cast<float>(facet.angle.radians()));
    parts.push_back(std::visit([&](auto id) { return row_of(sheet, id); }, facet.part));
  }
  for (const FacetEdge& edge : facets.edges) {
    append(edges, edge.line);
    edge_facets.push_back(static_cast<std::uint32_t>(edge.facet));
    edge_numbers.push_back(static_cast<std::uint32_t>(edge.border));
  }
  shape.add("points", polygons.points);
  shape.add("ring_starts", polygons.ring_starts);
  shape.add("polygon_starts", polygons.polygon_starts);
  shape.add("facet_starts", polygons.facet_starts);
  shape.add("facet_parent", parents);
  shape.add("facet_hinge", hinges);
  shape.add("facet_angle", angles);
  shape.add("facet_part", parts);
  shape.add("edges", edges);
  shape.add("edge_facet", edge_facets);
  shape.add("edge_number", edge_numbers);
  add_borders(shape, facets.borders);
  shape.root = facets.root;
}

/// Closed lines to fill, counter-clockwise outside and clockwise about openings; filling all facets
/// instead costs a browser twenty times as much.
class Contours {
 public:
  explicit Contours(double chord) : chord_(chord) {}
  void add(const Loop& loop, bool outside, std::int32_t part) {
    const std::vector<Vec2> ring = sampled(loop, chord_);
    const bool turned = (ring_area(ring) > 0.0) != outside;
    add(turned ? std::vector<Vec2>(ring.rbegin(), ring.rend()) : ring, part);
  }
  void add(const std::vector<Vec2>& ring, std::int32_t part) {
    for (const Vec2& p : ring)
      append(points_, p);
    starts_.push_back(count_of(points_.size() / 2));
    parts_.push_back(part);
  }
  void add_to(Shape& shape) const {
    shape.add("contour_points", points_);
    shape.add("contour_starts", starts_);
    shape.add("contour_part", parts_);
  }

 private:
  double chord_;
  std::vector<float> points_;
  Numbers starts_{0};
  std::vector<std::int32_t> parts_;
};

/// The parts: bends with faces by their outlines, the others by their facets.
void add_part_contours(Contours& contours, const job::Report& report, const Facets& facets) {
  const Sheet& sheet = report.sheet;
  for (const BendId bend : sheet.bends.ids())
    for (const FaceId face : sheet[bend].faces) {
      const std::vector<Loop>& loops = report.layout.images[face];
      for (std::size_t i = 0; i < loops.size(); ++i)
        contours.add(loops[i], i == 0, static_cast<std::int32_t>(row_of(sheet, bend)));
    }
  for (const Facet& facet : facets.facets) {
    if (!sheet.faces_of(facet.part).empty() && std::holds_alternative<BendId>(facet.part)) continue;
    const auto row = std::visit([&](auto id) { return row_of(sheet, id); }, facet.part);
    for (const Polygon& polygon : facet.polygons) {
      contours.add(polygon.outer, static_cast<std::int32_t>(row));
      for (const auto& hole : polygon.holes)
        contours.add(hole, static_cast<std::int32_t>(row));
    }
  }
}

void add_contours(Shape& shape, const job::Report& report, const Facets& facets, double chord) {
  constexpr std::int32_t kWhole = -1, kRelief = -2;
  Contours contours(chord);
  contours.add(report.flat.outer.loop, true, kWhole);
  for (const Contour& opening : report.flat.openings)
    contours.add(opening.loop, false, kWhole);
  for (const Loop& relief : report.reliefs)
    contours.add(relief, true, kRelief);
  add_part_contours(contours, report, facets);
  contours.add_to(shape);
}

void add_bend_lines(Shape& shape, const Sheet& sheet, const FlatPattern& flat) {
  std::vector<float> lines;
  Numbers parts;
  for (const FlatBend& bend : flat.bends)
    for (const Segment& line : bend.lines) {
      append(lines, line);
      parts.push_back(row_of(sheet, bend.bend));
    }
  shape.add("bend_lines", lines);
  shape.add("bend_line_part", parts);
}

/// Triangles, counter-clockwise, of the areas that two faces share in the flat pattern.
void add_overlaps(Shape& shape, const job::Report& report) {
  constexpr double kChord = 0.05;  // mm
  const bool known = std::ranges::any_of(report.findings,
                                         [](const Finding& f) { return f.code == "overlap"; });
  if (!known) return;
  const auto faces = mapped(report.layout.images.ids(), [&](FaceId face) {
    return polygon_of(report.layout.region(face), kChord);
  });
  const double clearance = std::max(kContactShare * report.flat.thickness, kChord);
  std::vector<float> points;
  for (const Overlap& overlap : overlaps(faces, clearance, clearance * clearance))
    for (const auto& ring : overlap.outline)
      for (const auto& [a, b, c] : inset_triangles({ring, {}}, 0.0)) {
        const bool turns_left = ring_area({a, b, c}) > 0.0;
        for (const Vec2& corner : {a, turns_left ? b : c, turns_left ? c : b})
          append(points, corner);
      }
  shape.add("overlaps", points);
}

}  // namespace

void add_sheet(Shape& shape, const job::Report& report, const FacetOptions& options) {
  const Sheet& sheet = report.sheet;
  add_parts(shape, sheet);
  if (sheet.faces.empty() || report.flat.outer.loop.empty()) return;
  shape.pierces = 1 + report.flat.openings.size() + report.flat.slits.size();
  const Facets facets = facets_of(sheet, report.layout, options);
  add_places(shape, sheet, report.layout);
  add_facets(shape, sheet, facets);
  add_directions(shape, sheet, report.flat);
  add_contours(shape, report, facets, options.chord);
  add_bend_lines(shape, sheet, report.flat);
  add_overlaps(shape, report);
}

}  // namespace planish::studio
