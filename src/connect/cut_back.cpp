#include "cut_back.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/geometry/plane.hpp>
#include <planish/geometry/region.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

// An outline with strips cut off along its edges and corners cut off. Each edge becomes pieces at
// depths of their own with steps between; corners are where the outermost pieces of neighbours
// meet. The result counts only if it is still a simple polygon that holds the plate's holes.

namespace planish::connect_detail {
namespace {

/// A part of an edge, set in by a depth.
struct Piece {
  double from = 0.0, to = 0.0, depth = 0.0;
  bool keeps_number = false;
  bool is_strip = false;
};

struct Side {
  Vec2 start, along, inwards;
  double length = 0.0;
  std::vector<Piece> pieces;
  double corner = 0.0;  ///< cut off at its start

  Vec2 at(double x, double depth) const { return start + x * along + depth * inwards; }
};

// Reliefs beside a strip are deeper than it by this share of their width, so that the edge along
// the strip ends at them.
constexpr double kDeeper = 0.5;

std::vector<Piece> pieces_of(std::vector<CutStrip> strips, double length, double relief) {
  std::ranges::sort(strips, {}, &CutStrip::from);
  std::vector<Piece> pieces;
  double done = 0.0;
  const double nothing = tolerance::kComputed * length;
  for (const CutStrip& strip : strips) {
    double from = std::max(strip.from - relief, done), to = strip.to + relief;
    if (from - done <= relief) from = done;
    if (length - to <= relief) to = length;
    if (strip.to <= done) continue;
    const auto add = [&](double end, double depth, bool keeps, bool is_strip = false) {
      if (end <= done + nothing) return;
      pieces.push_back({done, end, depth, keeps, is_strip});
      done = end;
    };
    const bool first = std::ranges::none_of(pieces, &Piece::keeps_number);
    add(from, 0.0, false);
    add(strip.from, strip.depth + kDeeper * relief, false);
    add(strip.to, strip.depth, first, true);
    add(to, strip.depth + kDeeper * relief, false);
  }
  if (done < length - nothing) pieces.push_back({done, length, 0.0, pieces.empty()});
  return pieces;
}

/// The end of a side at a corner: what is cut off there, by how far the outermost piece is set in,
/// and how far from the corner the strip begins.
struct SideEnd {
  double set_in = 0.0, strip_from = 0.0, ear = 0.0;
  bool cut() const { return set_in > 0.0; }
};

SideEnd end_of(const Side& side, bool at_start) {
  SideEnd end;
  double done = 0.0;
  for (std::size_t k = 0; k < side.pieces.size(); ++k) {
    const Piece& piece = side.pieces[at_start ? k : side.pieces.size() - 1 - k];
    if (piece.depth == 0.0 && k > 0) break;
    if (piece.depth == 0.0) end.ear = piece.to - piece.from;
    end.set_in = std::max(end.set_in, piece.depth);
    end.strip_from = done;
    if (piece.is_strip) break;
    done += piece.to - piece.from;
  }
  return end;
}

/// Takes off the pieces of a side before its strip, from the corner on, that lie within `room` of
/// the corner: there the cut along the other side has taken them. An ear goes with what is beside
/// it.
void join_corner(Side& side, bool at_start, const SideEnd& own, double room) {
  auto& pieces = side.pieces;
  const auto outermost = [&]() -> Piece& { return at_start ? pieces.front() : pieces.back(); };
  const auto take_off = [&] {
    const Piece gone = outermost();
    pieces.erase(at_start ? pieces.begin() : pieces.end() - 1);
    (at_start ? outermost().from : outermost().to) = at_start ? gone.from : gone.to;
  };
  if (own.ear > 0.0) take_off();
  if (own.strip_from <= room)
    while (!outermost().is_strip)
      take_off();
}

/// Where both sides of a corner are cut, ears that one relief would part from the plate go, and so
/// do reliefs that the cut along the other side takes anyway.
void settle_corners(std::vector<Side>& sides) {
  const std::size_t n = sides.size();
  for (std::size_t i = 0; i < n; ++i) {
    Side &before = sides[(i + n - 1) % n], &after = sides[i];
    const SideEnd last = end_of(before, false), first = end_of(after, true);
    if (!last.cut() || !first.cut()) continue;
    if (last.ear > first.set_in && first.ear > last.set_in) continue;
    join_corner(before, false, last, first.set_in);
    join_corner(after, true, first, last.set_in);
  }
}

std::vector<Side> sides(const PlacedPlate& plate, const std::vector<EdgeCut>& cuts, double relief) {
  std::vector<Side> all;
  const std::size_t n = plate.outline.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 &a = plate.outline[i], &b = plate.outline[(i + 1) % n];
    Side side{a, (b - a).normalized(), {}, (b - a).norm(), {}, cuts[i].corner};
    side.inwards = Vec2(-side.along.y(), side.along.x());
    side.pieces = pieces_of(cuts[i].strips, side.length, relief);
    all.push_back(std::move(side));
  }
  settle_corners(all);
  return all;
}

/// Where an edge begins after another one: one point, or two with a new edge between.
std::vector<Vec2> corner_between(const Side& before, const Side& after) {
  const double in = before.pieces.back().depth, out = after.pieces.front().depth;
  const Vec2 p = before.at(before.length, in), q = after.at(0.0, out);
  if (in == 0.0 && out == 0.0) {
    if (after.corner == 0.0) return {after.start};
    return {before.at(before.length - after.corner, 0.0), after.at(after.corner, 0.0)};
  }
  const double turn = cross(before.along, after.along);
  if (std::abs(turn) <= tolerance::kComputed) return in == out ? std::vector{q} : std::vector{p, q};
  return {p + cross(q - p, after.along) / turn * before.along};
}

/// An outline with the number of the edge that begins at each corner.
struct Numbered {
  std::vector<Vec2> corners;
  std::vector<int> numbers;
  int next = 0;  ///< number of the next new edge
  std::vector<int> cut_corners = {};

  void add(const Vec2& corner, std::optional<int> number) {
    corners.push_back(corner);
    numbers.push_back(number ? *number : next++);
  }
};

Numbered outline_of(const std::vector<Side>& sides, int first_new) {
  Numbered outline{{}, {}, first_new};
  const std::size_t n = sides.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Side& side = sides[i];
    const auto number = [&](const Piece& piece) {
      return piece.keeps_number ? std::optional(static_cast<int>(i)) : std::nullopt;
    };
    const auto start = corner_between(sides[(i + n - 1) % n], side);
    if (start.size() > 1 && side.corner > 0.0) outline.cut_corners.push_back(outline.next);
    if (start.size() > 1) outline.add(start.front(), std::nullopt);
    outline.add(start.back(), number(side.pieces.front()));
    for (std::size_t k = 1; k < side.pieces.size(); ++k) {
      const Piece &last = side.pieces[k - 1], &piece = side.pieces[k];
      if (last.depth != piece.depth) outline.add(side.at(piece.from, last.depth), std::nullopt);
      outline.add(side.at(piece.from, piece.depth), number(piece));
    }
  }
  return outline;
}

bool remains_whole(const PlacedPlate& plate, const std::vector<Vec2>& outline) {
  const std::size_t n = outline.size();
  for (std::size_t i = 0; i < n; ++i)
    if ((outline[(i + 1) % n] - outline[i]).norm() <= tolerance::kFileDigits * plate.extent)
      return false;
  if (!self_crossings(outline).empty() || ring_area(outline) <= 0.0) return false;
  return std::ranges::all_of(plate.holes, [&](const std::vector<Vec2>& hole) {
    return std::ranges::all_of(hole, [&](const Vec2& p) { return inside({outline}, p); });
  });
}

}  // namespace

std::optional<double> cut_back(PlacedPlate& plate, const std::vector<EdgeCut>& cuts,
                               double relief) {
  double deepest = 0.0;
  for (const EdgeCut& cut : cuts) {
    deepest = std::max(deepest, cut.corner);
    for (const CutStrip& strip : cut.strips)
      deepest = std::max(deepest, strip.depth);
  }
  if (deepest == 0.0) return std::nullopt;
  Numbered outline = outline_of(sides(plate, cuts, relief), plate.all_edges());
  if (!remains_whole(plate, outline.corners)) return std::nullopt;
  plate.given_edges = plate.edges_of(0);
  plate.outline = std::move(outline.corners);
  plate.numbers = std::move(outline.numbers);
  plate.cut_corners = std::move(outline.cut_corners);
  plate.area = ring_area(plate.outline);
  return deepest;
}

}  // namespace planish::connect_detail
