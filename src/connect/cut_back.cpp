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
  int number = 0;
  Vec2 start, along, inwards;
  double length = 0.0;
  std::vector<Piece> pieces;
  double corner = 0.0, square = 0.0;  ///< cut off at its start

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

std::vector<Side> sides(const PlacedPlate& plate, int ring, const std::vector<EdgeCut>& cuts,
                        double relief) {
  std::vector<Side> all;
  const std::vector<Vec2>& corners = plate.ring(ring);
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 &a = corners[i], &b = corners[(i + 1) % n];
    const int number = plate.edge_number({ring, static_cast<int>(i)});
    Side side{number,         a,  (b - a).normalized(), {},
              (b - a).norm(), {}, cuts[i].corner,       cuts[i].square};
    side.inwards = Vec2(-side.along.y(), side.along.x());
    side.pieces = pieces_of(cuts[i].strips, side.length, relief);
    all.push_back(std::move(side));
  }
  settle_corners(all);
  return all;
}

/// Beside a strip that ends at a corner which turns inwards, the edge there would press on the
/// bend: a relief, from that edge to the strip's end, where `along` and `inwards` begin.
std::vector<Vec2> relief_at(const Vec2& along, const Vec2& inwards, double depth,
                            const Vec2& beside, double length, double relief) {
  const double deeper = kDeeper * relief, out = -beside.dot(inwards), on = beside.dot(along);
  std::vector<Vec2> local{{-relief, depth + deeper}, {0.0, depth + deeper}, {0.0, depth}};
  double used = deeper / out;
  if (used * on > -relief) {
    local.insert(local.begin(), {{used * on, -deeper}, {-relief, -deeper}});
  } else {
    used = -relief / on;
    local.insert(local.begin(), {-relief, -used * out});
  }
  if (used > 0.5 * length) return {};
  return mapped(local, [&](const Vec2& p) -> Vec2 { return p.x() * along + p.y() * inwards; });
}

std::vector<Vec2> relief_between(const Side& before, const Side& after, double relief) {
  const Piece &last = before.pieces.back(), &first = after.pieces.front();
  constexpr double kTurns = 0.02;  // sine
  if (last.is_strip == first.is_strip || cross(before.along, after.along) > -kTurns) return {};
  std::vector<Vec2> points = first.is_strip ? relief_at(after.along, after.inwards, first.depth,
                                                        -before.along, before.length, relief)
                                            : relief_at(-before.along, before.inwards, last.depth,
                                                        after.along, after.length, relief);
  if (last.is_strip) std::ranges::reverse(points);
  for (Vec2& p : points)
    p += after.start;
  return points;
}

/// A corner cut off square to both of its edges; an obtuse one no deeper than twice its width.
std::vector<Vec2> square_corner(const Side& before, const Side& after) {
  constexpr double kDeepest = 2.0;
  const double width = after.square, turn = cross(before.along, after.along);
  const double depth = width * (1.0 + before.along.dot(after.along)) / turn;
  std::vector<Vec2> points{before.at(before.length - width, 0.0)};
  if (depth <= kDeepest * width) {
    points.push_back(after.at(width, depth));
  } else {
    points.push_back(before.at(before.length - width, kDeepest * width));
    points.push_back(after.at(width, kDeepest * width));
  }
  points.push_back(after.at(width, 0.0));
  return points;
}

/// Where an edge begins after another one: one point, or several with new edges between.
std::vector<Vec2> corner_between(const Side& before, const Side& after, double relief) {
  const double in = before.pieces.back().depth, out = after.pieces.front().depth;
  const Vec2 p = before.at(before.length, in), q = after.at(0.0, out);
  if (in == 0.0 && out == 0.0) {
    if (after.square > 0.0) return square_corner(before, after);
    if (after.corner == 0.0) return {after.start};
    return {before.at(before.length - after.corner, 0.0), after.at(after.corner, 0.0)};
  }
  if (auto notch = relief_between(before, after, relief); !notch.empty()) return notch;
  const double turn = cross(before.along, after.along);
  if (std::abs(turn) <= tolerance::kComputed) return in == out ? std::vector{q} : std::vector{p, q};
  return {p + cross(q - p, after.along) / turn * before.along};
}

/// An outline with the number of the edge that begins at each corner.
struct Numbered {
  std::vector<Vec2> corners;
  std::vector<int> numbers;
};

/// Numbers new edges on from `next`, and notes those of corners that were cut off.
Numbered ring_of(const std::vector<Side>& sides, double relief, int& next,
                 std::vector<int>& cut_corners) {
  Numbered ring;
  const auto add = [&](const Vec2& corner, std::optional<int> number) {
    ring.corners.push_back(corner);
    ring.numbers.push_back(number ? *number : next++);
  };
  const std::size_t n = sides.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Side& side = sides[i];
    const auto number = [&](const Piece& piece) {
      return piece.keeps_number ? std::optional(side.number) : std::nullopt;
    };
    const auto start = corner_between(sides[(i + n - 1) % n], side, relief);
    for (std::size_t k = 0; k + 1 < start.size(); ++k) {
      if (side.corner + side.square > 0.0) cut_corners.push_back(next);
      add(start[k], std::nullopt);
    }
    add(start.back(), number(side.pieces.front()));
    for (std::size_t k = 1; k < side.pieces.size(); ++k) {
      const Piece &last = side.pieces[k - 1], &piece = side.pieces[k];
      if (last.depth != piece.depth) add(side.at(piece.from, last.depth), std::nullopt);
      add(side.at(piece.from, piece.depth), number(piece));
    }
  }
  return ring;
}

bool remains_simple(const std::vector<Vec2>& before, const std::vector<Vec2>& ring, double extent) {
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i)
    if ((ring[(i + 1) % n] - ring[i]).norm() <= tolerance::kFileDigits * extent) return false;
  return self_crossings(ring).empty() && ring_area(ring) * ring_area(before) > 0.0;
}

/// Whether the rings of a plate lie apart, as they were: the holes in the outline, beside each
/// other.
bool lie_apart(const PlacedPlate& plate) {
  const auto outside = [](const std::vector<Vec2>& ring) {
    return [&ring](const Vec2& p) { return !inside({ring}, p); };
  };
  for (std::size_t h = 0; h < plate.holes.size(); ++h) {
    if (std::ranges::any_of(plate.holes[h], outside(plate.outline)) ||
        !std::ranges::all_of(plate.outline, outside(plate.holes[h])))
      return false;
    for (std::size_t k = 0; k < plate.holes.size(); ++k)
      if (k != h && !std::ranges::all_of(plate.holes[k], outside(plate.holes[h]))) return false;
  }
  return true;
}

/// A plate cut back; empty if it would not remain whole.
std::optional<PlacedPlate> cut_plate(const PlacedPlate& plate, const PlateCuts& cuts,
                                     double relief) {
  PlacedPlate cut = plate;
  int next = plate.all_edges();
  for (int r = 0; r < plate.ring_count(); ++r) {
    if (!plate.is_polygon(r)) {
      cut.numbers.emplace_back();
      continue;
    }
    Numbered ring = ring_of(sides(plate, r, cuts[r], relief), relief, next, cut.cut_corners);
    if (!remains_simple(plate.ring(r), ring.corners, plate.extent)) return std::nullopt;
    (r == 0 ? cut.outline : cut.holes[r - 1]) = std::move(ring.corners);
    cut.numbers.push_back(std::move(ring.numbers));
  }
  if (!lie_apart(cut)) return std::nullopt;
  cut.area = ring_area(cut.outline);
  return cut;
}

}  // namespace

std::optional<double> cut_back(PlacedPlate& plate, const PlateCuts& cuts, double relief) {
  double deepest = 0.0;
  for (const std::vector<EdgeCut>& ring : cuts)
    for (const EdgeCut& cut : ring) {
      deepest = std::max({deepest, cut.corner, cut.square});
      for (const CutStrip& strip : cut.strips)
        deepest = std::max(deepest, strip.depth);
    }
  if (deepest == 0.0) return std::nullopt;
  auto cut = cut_plate(plate, cuts, relief);
  if (!cut) return std::nullopt;
  plate = std::move(*cut);
  return deepest;
}

}  // namespace planish::connect_detail
