#include "tangent_pieces.hpp"

#include "borders.hpp"
#include "innermost.hpp"
#include "skin_outlines.hpp"
#include "tangent_runs.hpp"

#include <planish/base/id_vector.hpp>
#include <planish/geometry/plane.hpp>

#include <algorithm>
#include <cmath>

// An edge of a wall is seen on the flange along its normal and on the bend across it, so it is
// divided at the tangent line. For the innermost cell both are laid flat beside each other.

namespace planish::brep {
namespace {

/// A part of an edge, over the flange or over the bend.
struct SectionPiece {
  bool over_bend = false;
  Border border;
};

/// The bend beside an opening, and where the tangent line lies on it.
struct BendBeside {
  const SolidSurface& surface;
  double near = 0.0;  ///< u about which it is read
  Vec2 origin;        ///< of the tangent line, in (u, v)

  BendBeside(const Recognition& of, const TangentOpening& opening, const Frame& across)
      : BendBeside(of, of.groups.rows[of.groups.of_face[opening.here.on_bend->loop.face]].leader,
                   across) {}

 private:
  BendBeside(const Recognition& of, int leader, const Frame& across)
      : surface(of.model.faces[leader].surface),
        near(of.outlines[leader].u_middle),
        origin(parameters_of(std::get<Developable>(surface), across.origin, near)) {}
};

/// An edge divided where it crosses the tangent line; empty where both its images do not agree on
/// that.
std::vector<SectionPiece> divided(const Recognition& of, const TangentOpening& opening,
                                  const Frame& across, const CoEdge& use) {
  constexpr double kEnd = 1e-6;  // of the edge: it only begins or ends at the line
  const BendBeside bend(of, opening, across);
  Border flat = read_borders(of.model, {use}, opening.plane, 0.0, of.tolerance).front();
  const Border bent = read_borders(of.model, {use}, bend.surface, bend.near, of.tolerance).front();
  const Vec2 origin = opening.plane.local2(across.origin);
  const Vec2 along(across.y.dot(opening.plane.x), across.y.dot(opening.plane.y));
  const Vec2 over(across.x.dot(opening.plane.x), across.x.dot(opening.plane.y));
  const auto inner = [&](std::vector<double> at) {
    std::erase_if(at, [](double t) { return t < kEnd || t > 1.0 - kEnd; });
    at.insert(at.begin(), 0.0);
    at.push_back(1.0);
    return at;
  };
  const auto in_plane = inner(crossings(flat.curve, origin, along));
  const auto on_bend = inner(crossings(bent.curve, {bend.origin.x(), 0.0}, Vec2::UnitY()));
  if (in_plane.size() != on_bend.size()) return {};
  const auto depth = level_depth(of.model.edges[use.edge].curve, opening.plane, of.tolerance);
  flat.edge_depth = depth.value_or(0.0);
  if (!depth) flat.edge.reset();
  std::vector<SectionPiece> pieces;
  for (size_t i = 1; i < in_plane.size(); ++i) {
    const Vec2 middle = point_at(flat.curve, (in_plane[i - 1] + in_plane[i]) / 2);
    SectionPiece& piece = pieces.emplace_back((middle - origin).dot(over) > 0.0, flat);
    if (in_plane.size() > 2 || piece.over_bend) piece.border.edge_length.reset();
    piece.border.curve = trimmed(flat.curve, in_plane[i - 1], in_plane[i]);
    if (!piece.over_bend) continue;
    piece.border.edge.reset();
    piece.border.curve = trimmed(bent.curve, on_bend[i - 1], on_bend[i]);
  }
  return pieces;
}

/// Sets what is cut to pieces that follow each other; returns whether they go over the tangent line
/// and back.
bool set_cut(TangentOpening& opening, std::vector<SectionPiece> pieces) {
  const size_t count = pieces.size();
  size_t start = 0;
  int turns = 0;
  for (size_t i = 0; i < count; ++i)
    if (!pieces[i].over_bend && pieces[(i + count - 1) % count].over_bend) {
      start = i;
      ++turns;
    }
  if (turns != 1) return false;
  std::ranges::rotate(pieces, pieces.begin() + static_cast<std::ptrdiff_t>(start));
  opening.cut.clear();
  opening.cut_of_bend.clear();
  for (SectionPiece& piece : pieces)
    (piece.over_bend ? opening.cut_of_bend : opening.cut).push_back(std::move(piece.border));
  return true;
}

/// Lays what is seen on the flange and on the bend beside each other: x across the tangent line, y
/// along it, both half-way between the skins.
class BothFlat {
 public:
  BothFlat(const Recognition& of, const TangentOpening& opening, const Frame& across)
      : plane_(opening.plane),
        across_(across),
        bend_(of, opening, across),
        radius_(middle_radius(of, opening.here)),
        along_(std::get<Cylinder>(std::get<Developable>(bend_.surface)).frame.z.dot(across.y) > 0.0
                   ? 1.0
                   : -1.0) {}

  Vec2 operator()(const SectionPiece& piece, double t) const {
    const Vec2 p = point_at(piece.border.curve, t);
    if (!piece.over_bend) return across_.local2(plane_.point(p));
    return {radius_ * std::abs(p.x() - bend_.origin.x()), along_ * (p.y() - bend_.origin.y())};
  }

 private:
  const Frame& plane_;
  const Frame& across_;
  BendBeside bend_;
  double radius_, along_;
};

/// All edges of the walls, divided; empty where one cannot be.
std::vector<SectionPiece> wall_pieces(const Recognition& of, const TangentOpening& opening,
                                      const Frame& across) {
  std::vector<SectionPiece> pieces;
  for (const int edge : wall_edges(of, of.rim.parts[opening.part])) {
    const auto divided_edge = divided(of, opening, across, {edge, true});
    if (divided_edge.empty()) return {};
    std::ranges::copy_if(divided_edge, std::back_inserter(pieces), [&](const SectionPiece& piece) {
      return length(piece.border.curve) > of.tolerance;
    });
  }
  return pieces;
}

/// The middle of what is cut now.
Vec2 middle_of_cut(const TangentOpening& opening, const BothFlat& flat) {
  constexpr int kPoints = 32;
  std::vector<Vec2> ring;
  for (const auto* borders : {&opening.cut, &opening.cut_of_bend})
    for (const Border& border : *borders)
      for (int i = 0; i < kPoints; ++i)
        ring.push_back(
            flat({borders == &opening.cut_of_bend, border}, static_cast<double>(i) / kPoints));
  const Box2 box = planish::box_of(ring);
  return (box.lo + box.hi) / 2;
}

}  // namespace

bool divide(const Recognition& of, TangentOpening& opening, const Frame& across,
            const std::vector<CoEdge>& section) {
  std::vector<SectionPiece> pieces;
  for (const CoEdge& use : section) {
    if (length(read_borders(of.model, {use}, opening.plane, 0.0, of.tolerance).front().curve) <=
        of.tolerance)
      continue;
    const auto divided_edge = divided(of, opening, across, use);
    if (divided_edge.empty()) return false;
    std::ranges::copy(divided_edge, std::back_inserter(pieces));
  }
  return set_cut(opening, std::move(pieces));
}

void narrow_to_cell(const Recognition& of, TangentOpening& opening, const Frame& across) {
  constexpr double kEnds = 10.0;  // of the tolerance to which borders are read: so far ends are off
  const std::vector<SectionPiece> pieces = wall_pieces(of, opening, across);
  const BothFlat flat(of, opening, across);
  const auto curves = mapped(pieces, [&](const SectionPiece& piece) -> PlaneCurve {
    return [&](double t) { return flat(piece, t); };
  });
  const auto cell = reversed(  // openings run clockwise
      innermost_cell(curves, middle_of_cut(opening, flat), kEnds * of.tolerance));
  const auto cut_piece = [&](const CellPiece& part) {
    const SectionPiece& piece = pieces[part.curve];
    return SectionPiece{piece.over_bend, part_of(piece.border, part)};
  };
  TangentOpening narrowed = opening;
  const bool across_once = set_cut(narrowed, mapped(cell, cut_piece));
  if (across_once && cut_area(of, narrowed) < cut_area(of, opening)) opening = std::move(narrowed);
}

}  // namespace planish::brep
