#include "joined_face.hpp"
#include "plate_outline.hpp"

#include <algorithm>

// A plate with its extensions as a face of the sheet. Outlines lie on the middle surface, the face
// on the skin that all faces share, half a thickness away. A plate that faces the other way is
// turned over about x and its loops are reversed, so that material stays on the left of every
// border (math.md#border-trihedron).

namespace planish::connect_detail {
namespace {

using Edge = ExtendedOutline::Edge;

std::vector<BendOnPlate> bends_on(const Parts& parts, int plate) {
  std::vector<BendOnPlate> bends;
  for (int b = 0; b < static_cast<int>(parts.fits.size()); ++b)
    for (int side = 0; side < 2; ++side)
      if (parts.plate_of(b, side) == plate) bends.push_back({b, side, &parts.fits[b]});
  return bends;
}

// On the skin to which the plate's normal points, or on the other one.
Frame skin_frame(const PlacedPlate& plate, double thickness, int sense) {
  Frame frame = plate.frame;
  frame.y *= sense;
  frame.z *= sense;
  frame.origin += 0.5 * thickness * frame.z;
  return frame;
}

// The loop seen from outside the material.
std::vector<Edge> seen_from_outside(std::vector<Edge> edges, int sense) {
  if (sense > 0) return edges;
  std::ranges::reverse(edges);
  for (Edge& edge : edges) {
    std::swap(edge.a, edge.b);
    for (Vec2* p : {&edge.a, &edge.b})
      p->y() = -p->y();
  }
  return edges;
}

BorderLoop border_loop(const std::vector<Edge>& edges) {
  return mapped(edges, [&](const Edge& edge) {
    return Border{.curve = Segment{edge.a, edge.b}, .edge_length = (edge.b - edge.a).norm()};
  });
}

// A hole with arcs, which no bend changes; seen from the other side it is mirrored about x.
BorderLoop shape_loop(Loop shape, int sense) {
  if (sense < 0) {
    Isometry2 mirror = Isometry2::Identity();
    mirror.linear()(1, 1) = -1.0;
    shape = reversed(transformed(shape, mirror));
  }
  return mapped(shape, [](const Curve2& curve) {
    return Border{.curve = curve, .edge_length = length(curve)};
  });
}

}  // namespace

Result<JoinedFace> plate_face(const Parts& parts, int plate, int sense) {
  const PlacedPlate& placed = parts.plates[plate];
  const std::vector<BendOnPlate> bends = bends_on(parts, plate);
  JoinedFace made;
  made.face.surface = skin_frame(placed, parts.thickness, sense);
  for (int ring = 0; ring < placed.ring_count(); ++ring) {
    if (!placed.is_polygon(ring)) {
      made.face.loops.push_back(shape_loop(placed.shapes[ring - 1], sense));
      continue;
    }
    const auto outline = extended_outline(placed, bends, parts.ids[plate], ring);
    if (!outline) return pass_on(outline);
    const std::vector<Edge> edges = seen_from_outside(outline->edges, sense);
    for (std::size_t i = 0; i < edges.size(); ++i)
      if (edges[i].bend) made.joints.push_back({plate, *edges[i].bend, static_cast<int>(i), ring});
    made.face.loops.push_back(border_loop(edges));
  }
  return made;
}

}  // namespace planish::connect_detail
