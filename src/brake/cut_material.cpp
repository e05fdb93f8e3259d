// Where the material of the pattern belongs: convex pieces of each face are clipped at the zones
// of the lines; what lies in a zone is bent there, what lies between belongs to the body. What
// must hold: zones and bodies together are the pattern, each place once (math.md#stages).
#include "cutting.hpp"

#include <algorithm>
#include <limits>

namespace planish::brake_detail {
namespace {

constexpr double kBesideSeam = 1e-6;  // mm: faces of a bend may end on its line

Convex in_line(const BrakeLine& line, Convex piece) {
  for (Vec2& p : piece)
    p = {line.along.dot(p - line.origin), line.across().dot(p - line.origin)};
  return piece;
}

Convex in_pattern(const BrakeLine& line, Convex piece) {
  for (Vec2& p : piece)
    p = line.origin + p.x() * line.along + p.y() * line.across();
  return piece;
}

/// Where a piece in the line's coordinates lies on the line.
std::optional<Interval> on_line(const Convex& piece) {
  Interval on{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (size_t i = 0; i < piece.size(); ++i) {
    const Vec2 &a = piece[i], &b = piece[(i + 1) % piece.size()];
    if ((a.y() > kBesideSeam) == (b.y() > kBesideSeam)) continue;
    const double x = a.x() + (a.y() - kBesideSeam) / (a.y() - b.y()) * (b.x() - a.x());
    on = {std::min(on.lo, x), std::max(on.hi, x)};
  }
  if (on.hi <= on.lo) return std::nullopt;
  return on;
}

}  // namespace

void Cutting::add_to_zone(const Raw& raw, const Convex& piece) {
  BrakeLine& line = made_.lines[raw.number];
  const double half = 0.5 * line.bend.allowance;
  const Convex whole = in_line(line, piece);
  const Convex zone = clipped(clipped(whole, {0, 1}, half), {0, -1}, half);
  if (!is_thin(zone, kTouching)) made_.zones[raw.number].pieces.push_back(zone);
  if (const auto on = on_line(whole)) line.pieces.push_back(*on);
}

/// What lies between the zones of neighbouring lines belongs to the body there.
void Cutting::add_bend_material(BendId id, const Convex& piece) {
  const int count = static_cast<int>(lines_at_[id].size());
  const Raw* raws = raw_.data() + first_raw_[id];
  for (int region = 0; region <= count; ++region) {
    Convex rest = piece;
    const auto cut = [&](const BrakeLine& line, double side) {
      const double half = 0.5 * line.bend.allowance;
      rest = in_pattern(line, clipped(in_line(line, rest), {0.0, side}, -half));
    };
    if (region > 0) cut(raws[region - 1].line, -1.0);
    if (region < count) cut(raws[region].line, 1.0);
    if (is_thin(rest, kTouching)) continue;
    made_.bodies[body_of(first_region_[id] + region)].pieces.push_back(std::move(rest));
  }
  for (int number = 0; number < count; ++number)
    add_to_zone(raws[number], piece);
}

void Cutting::add_material() {
  for (const FaceId face : sheet_.faces.ids())
    for (Convex& piece : face_material(sheet_, layout_, face)) {
      if (const auto* bend = std::get_if<BendId>(&sheet_[face].part_of))
        add_bend_material(*bend, piece);
      else
        made_.bodies[body_of(index_of(face))].pieces.push_back(std::move(piece));
    }
  for (const Raw& raw : raw_)
    for (const Convex& band : raw.bands)
      if (!is_thin(band, kTouching)) add_to_zone(raw, band);
  // A ruling at the very border of a face crosses none of its pieces.
  for (const Raw& raw : raw_)
    if (made_.lines[raw.number].pieces.empty())
      made_.lines[raw.number].pieces.push_back({0.0, raw.ruling});
  for (BrakeLine& line : made_.lines)
    line.pieces = joined(std::move(line.pieces), kTouching);
  for (BrakeLine& line : made_.lines)
    if (line.closes) line.pieces = made_.lines[*line.closes].pieces;
}

/// Contours with the material on their left run clockwise about openings.
IdVector<BorderId, bool> Cutting::along_openings(const Topology& topology) const {
  IdVector<BorderId, bool> found(topology.border_count(), false), seen = found;
  for (const BorderId id : topology.borders()) {
    std::vector<BorderId> contour;
    double area = 0.0;
    for (BorderId at = id; topology.is_free(at) && !seen[at];) {
      seen[at] = true;
      contour.push_back(at);
      const Curve2& image = layout_.image(topology[at]);
      at = topology.along_contour(at).border;
      const Vec2 end = end_of(image), next = start_of(layout_.image(topology[at]));
      area += green_area(image) + 0.5 * cross(end, next);  // a sharp bend leaves a gap
    }
    if (contour.empty() || (area > 0.0) == lies_left(topology[id].face)) continue;
    for (const BorderId at : contour)
      found[at] = true;
  }
  return found;
}

/// Straight borders of bends with several lines lie across them and are of no use to a gauge.
void Cutting::add_edges() {
  const Topology topology(sheet_);
  const IdVector<BorderId, bool> in_opening = along_openings(topology);
  for (const BorderId id : topology.borders()) {
    const BorderRef& ref = topology[id];
    const auto* image = std::get_if<Segment>(&layout_.image(ref));
    if (!topology.is_free(id) || !image || sheet_[ref].feature) continue;
    FreeEdge edge{image->a, image->b, in_opening[id]};
    if (!lies_left(ref.face)) std::swap(edge.a, edge.b);
    const auto* bend = std::get_if<BendId>(&sheet_[ref.face].part_of);
    if (!bend)
      made_.bodies[body_of(index_of(ref.face))].edges.push_back(edge);
    else if (lines_at_[*bend].size() == 1)
      made_.zones[raw_[first_raw_[*bend]].number].edges.push_back(edge);
  }
}

}  // namespace planish::brake_detail
