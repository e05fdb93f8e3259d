#include "joined_face.hpp"
#include "plate_outline.hpp"

#include <algorithm>

namespace planish::connect_detail {
namespace {

using Piece = ExtendedOutline::Piece;

std::vector<BendOnPlate> bends_on(const Parts& parts, int plate) {
  std::vector<BendOnPlate> bends;
  for (int b = 0; b < static_cast<int>(parts.fits.size()); ++b)
    for (int side = 0; side < 2; ++side)
      if (parts.plate_of(b, side) == plate) bends.push_back({b, side, &parts.fits[b]});
  return bends;
}

// On the skin to which the plate's normal points, or on the other one, turned over about x.
Frame skin_frame(const PlacedPlate& plate, double thickness, int sense) {
  Frame frame = plate.frame;
  frame.y *= sense;
  frame.z *= sense;
  frame.origin += 0.5 * thickness * frame.z;
  return frame;
}

// The loop seen from outside the material.
std::vector<Piece> seen_from_outside(std::vector<Piece> pieces, int sense) {
  if (sense > 0) return pieces;
  std::reverse(pieces.begin(), pieces.end());
  for (Piece& piece : pieces) {
    std::swap(piece.a, piece.b);
    for (Vec2* p : {&piece.a, &piece.b})
      p->y() = -p->y();
  }
  return pieces;
}

BorderLoop border_loop(const std::vector<Piece>& pieces) {
  BorderLoop loop;
  for (const Piece& piece : pieces)
    loop.push_back({.curve = Segment{piece.a, piece.b}, .edge_length = (piece.b - piece.a).norm()});
  return loop;
}

std::vector<Piece> hole_pieces(const std::vector<Vec2>& hole) {
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < hole.size(); ++i)
    pieces.push_back({hole[i], hole[(i + 1) % hole.size()], std::nullopt});
  return pieces;
}

}  // namespace

Result<JoinedFace> plate_face(const Parts& parts, int plate, int sense) {
  const PlacedPlate& placed = parts.plates[plate];
  const auto outline = extended_outline(placed, bends_on(parts, plate), parts.ids[plate]);
  if (!outline) return tl::unexpected(outline.error());
  JoinedFace made;
  made.face.surface = skin_frame(placed, parts.thickness, sense);
  const std::vector<Piece> outer = seen_from_outside(outline->pieces, sense);
  for (std::size_t i = 0; i < outer.size(); ++i)
    if (outer[i].bend) made.joints.push_back({plate, *outer[i].bend, static_cast<int>(i)});
  made.face.loops.push_back(border_loop(outer));
  for (const auto& hole : placed.holes)
    made.face.loops.push_back(border_loop(seen_from_outside(hole_pieces(hole), sense)));
  return made;
}

}  // namespace planish::connect_detail
