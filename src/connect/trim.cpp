#include "trim.hpp"

#include "bend_frame.hpp"
#include "cut_back.hpp"
#include "tolerances.hpp"
#include "touches.hpp"

#include <planish/base/union_find.hpp>
#include <planish/geometry/plane.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

// By how much plates that touch give way. A bend of the radius R of the middle surface touches both
// plates R / tan(β/2) from the line in which their planes meet; as much is cut off along an edge
// that they share. At a corner that they share the edges run up to that line, so the corner is cut
// off where a bend would still have that radius. Edges that are folded stay, and are cut back when
// the fold is fitted: so where two folds of a plate meet, its corner is cut off square to them.

namespace planish::connect_detail {
namespace {

// A share of a plate's extent: more is not cut off.
constexpr double kMostCut = 0.25;
// Edges at less than this angle (sine) to the intersection line run along it.
constexpr double kAlong = 0.02;
// Inside radius for which open joints beside folds are cut back, as a share of the thickness: the
// relief between two folds at a right angle is then as wide as the sheet is thick.
constexpr double kOpenRadius = 0.5;

/// From an edge into its plate.
Vec3 inwards(const PlacedPlate& plate, const EdgePlace& edge) {
  return plate.frame.z.cross(edge_of(plate, edge).along());
}

/// A corner of a plate at which a fold begins or ends.
struct FoldEnd {
  int plate = 0, ring = 0, corner = 0;
  double reach = 0.0;  ///< by how much the fold cuts the plate back
};

class Trimming {
 public:
  Trimming(const PlateStructure& structure, const std::vector<PlacedPlate>& plates)
      : structure_(structure), plates_(plates), touches_(touches_of(structure, plates)) {
    for (const PlacedPlate& plate : plates) {
      PlateCuts& cuts = cuts_.emplace_back();
      for (int r = 0; r < plate.ring_count(); ++r)
        cuts.emplace_back(plate.ring(r).size());
    }
    for (const Touch& touch : touches_)
      if (!touch.corner) cut_edges(touch);
    for (const Touch& touch : touches_)
      if (touch.corner) cut_corners(touch);
    settle_folds();
  }

  bool all_touch() const {
    UnionFind touching(static_cast<int>(plates_.size()));
    for (const Touch& touch : touches_)
      touching.unite(touch.plates[0], touch.plates[1]);
    return plates_.size() > 1 && touching.count() == 1;
  }

  const PlateCuts& cuts(std::size_t plate) const { return cuts_[plate]; }
  const std::vector<SharedEdge>& shared() const { return shared_; }
  const std::vector<NarrowPlate>& narrow() const { return narrow_; }

 private:
  // The radius of the middle surface of the bend between two plates.
  double radius(int a, int b) const {
    std::optional<double> inside = structure_.defaults.inside_radius;
    for (const BendRequest& bend : structure_.bends) {
      const auto joins = [&](int p) {
        return std::ranges::find(bend.between, structure_.plates[p].id) != bend.between.end();
      };
      if (joins(a) && joins(b) && bend.inside_radius) inside = bend.inside_radius;
    }
    if (inside == 0.0) inside = kOpenRadius * structure_.thickness;
    return inside.value_or(structure_.thickness) + 0.5 * structure_.thickness;
  }

  // How far back both plates have to stay from the line in which their planes meet.
  double reach(int a, int b, const Vec3& into_a, const Vec3& into_b) const {
    return radius(a, b) / std::tan(0.5 * angle_between(into_a, into_b));
  }

  // Likewise; empty if that is too much of either.
  std::optional<double> depth(int a, int b, const Vec3& into_a, const Vec3& into_b) const {
    const double cut = reach(a, b, into_a, into_b);
    if (cut > kMostCut * std::min(plates_[a].extent, plates_[b].extent)) return std::nullopt;
    return cut;
  }

  void note_narrow(int own, int other, const EdgePlace& edge, const Vec3& into, double needed) {
    const PlacedPlate& plate = plates_[own];
    const Vec3 from = plate.corner(edge);
    double width = 0.0;
    for (int i = 0; i < plate.edge_count(); ++i)
      width = std::max(width, (plate.corner(i) - from).dot(into));
    if (width <= needed)
      narrow_.push_back(
          {own, other, width, needed, radius(own, other) - 0.5 * structure_.thickness});
  }

  EdgeCut& cut_at(int plate, const EdgePlace& edge) { return cuts_[plate][edge.ring][edge.corner]; }

  void cut_edges(const Touch& touch) {
    const auto [a, b] = touch.plates;
    const auto& [i, j] = touch.edges;
    const Vec3 into_a = inwards(plates_[a], i), into_b = inwards(plates_[b], j);
    const Line first = edge_of(plates_[a], i), second = edge_of(plates_[b], j);
    if (touch.folded) {
      note_fold(touch, 0.5 * structure_.thickness / std::tan(0.5 * angle_between(into_a, into_b)));
    } else {
      const double needed = reach(a, b, into_a, into_b);
      note_narrow(a, b, i, into_a, needed);
      note_narrow(b, a, j, into_b, needed);
      const auto cut = depth(a, b, into_a, into_b);
      if (!cut) return;
      // Of edges that miss each other, one may reach over the line where the planes meet.
      const double missed = std::max(first.off(second.from), first.off(second.to));
      const double back = *cut + (missed > kDrawn ? missed : 0.0);
      cut_at(a, i).strips.push_back({touch.ranges[0][0], touch.ranges[0][1], back});
      cut_at(b, j).strips.push_back({touch.ranges[1][0], touch.ranges[1][1], back});
    }
    shared_.push_back({{a, b},
                       first.from + touch.ranges[0][0] * first.along(),
                       first.from + touch.ranges[0][1] * first.along()});
  }

  EdgePlace before(int plate, const EdgePlace& edge) const {
    const int n = static_cast<int>(plates_[plate].ring(edge.ring).size());
    return {edge.ring, (edge.corner + n - 1) % n};
  }

  bool cut_already(int plate, const EdgePlace& corner) {
    return !cut_at(plate, corner).strips.empty() ||
           !cut_at(plate, before(plate, corner)).strips.empty();
  }

  bool folded(int a, int b) const {
    return std::ranges::any_of(touches_, [&](const Touch& touch) {
      return touch.folded && touch.plates == std::array{a, b};
    });
  }

  void cut_corners(const Touch& touch) {
    const auto [a, b] = touch.plates;
    const auto& [i, j] = touch.edges;
    if (cut_already(a, i) || cut_already(b, j) || folded(a, b)) return;
    cut_corner(a, i.corner, b);
    cut_corner(b, j.corner, a);
    shared_.push_back({{a, b}, plates_[a].corner(i.corner), plates_[a].corner(i.corner)});
  }

  // Where edges run from a shared corner away from the intersection line, they have the depth of
  // the bend at this distance from the corner.
  void cut_corner(int own, int corner, int other) {
    const PlacedPlate &plate = plates_[own], &beside = plates_[other];
    const Vec3 d = plate.frame.z.cross(beside.frame.z).normalized(), at = plate.corner(corner);
    const auto into = [&](const PlacedPlate& p) -> Vec3 {
      const Box2 box = box_of(p.outline);
      const Vec3 way = p.frame.point(Vec2(0.5 * (box.lo + box.hi))) - at;
      return (way - way.dot(d) * d).normalized();
    };
    const auto cut = depth(own, other, into(plate), into(beside));
    if (!cut) return;
    const int n = plate.edge_count();
    double least = 1.0, shortest = plate.extent;
    for (const int neighbour : {(corner + 1) % n, (corner + n - 1) % n}) {
      const Vec3 edge = plate.corner(neighbour) - at;
      const double sine = edge.normalized().cross(d).norm();
      if (sine > kAlong) least = std::min(least, sine);
      shortest = std::min(shortest, edge.norm());
    }
    double& corner_cut = cut_at(own, {0, corner}).corner;
    corner_cut = std::max(corner_cut, std::min(*cut / least, kMostCut * shortest));
  }

  // The ends of a fold that lie in corners of both plates, pair by pair.
  void note_fold(const Touch& touch, double reach) {
    const auto end_of = [&](std::size_t side, bool at_end) -> std::optional<FoldEnd> {
      const int plate = touch.plates[side];
      const EdgePlace& edge = touch.edges[side];
      const double length = edge_of(plates_[plate], edge).length();
      const double off = at_end ? length - touch.ranges[side][1] : touch.ranges[side][0];
      if (off > kMeantAsOne) return std::nullopt;
      const int n = static_cast<int>(plates_[plate].ring(edge.ring).size());
      return FoldEnd{plate, edge.ring, (edge.corner + (at_end ? 1 : 0)) % n, reach};
    };
    const Vec3 along = edge_of(plates_[touch.plates[0]], touch.edges[0]).along();
    const Vec3 other = edge_of(plates_[touch.plates[1]], touch.edges[1]).along();
    for (const bool at_end : {false, true})
      fold_ends_.push_back({end_of(0, at_end), end_of(1, at_end == (along.dot(other) > 0.0))});
  }

  /// How far from a corner along its edges a plate lets a fold begin.
  double setback(const FoldEnd& end) {
    double reach = 0.0;
    int folds = 0;
    for (const auto& ends : fold_ends_)
      for (const auto& one : ends)
        if (one && one->plate == end.plate && one->ring == end.ring && one->corner == end.corner) {
          reach += one->reach;
          ++folds;
        }
    const auto [strips, sine] = strips_at(end);
    const EdgeCut& cut = cut_at(end.plate, {end.ring, end.corner});
    double back = std::max(cut.corner, cut.square);
    if (folds > 1 && sine > kAlong) back = std::max(back, reach / sine);
    for (const CutStrip* strip : strips)
      back = std::max(back, strip->depth / std::max(sine, kAlong));
    return back;
  }

  /// The strips that end at a corner, and the sine of the angle between its edges: 0 if it turns
  /// inwards.
  std::pair<std::vector<CutStrip*>, double> strips_at(const FoldEnd& end) {
    const EdgePlace after{end.ring, end.corner}, ahead = before(end.plate, after);
    const PlacedPlate& plate = plates_[end.plate];
    const Line first = edge_of(plate, ahead), second = edge_of(plate, after);
    std::vector<CutStrip*> strips;
    for (CutStrip& strip : cut_at(end.plate, ahead).strips)
      if (first.length() - strip.to <= kMeantAsOne) strips.push_back(&strip);
    for (CutStrip& strip : cut_at(end.plate, after).strips)
      if (strip.from <= kMeantAsOne) strips.push_back(&strip);
    return {strips, std::max(0.0, first.along().cross(second.along()).dot(plate.frame.z))};
  }

  void set_back(const FoldEnd& end, double by) {
    const auto [strips, sine] = strips_at(end);
    for (CutStrip* strip : strips)
      strip->depth = std::max(strip->depth, by * sine);
    const PlacedPlate& plate = plates_[end.plate];
    const EdgePlace after{end.ring, end.corner};
    const double shortest = std::min(edge_of(plate, after).length(),
                                     edge_of(plate, before(end.plate, after)).length());
    if (!strips.empty() || by > kMostCut * shortest) return;
    EdgeCut& cut = cut_at(end.plate, after);
    (cut.corner > 0.0 ? cut.corner : cut.square) = by;
  }

  /// Both plates of a fold begin at the same distance from a corner. One that is cut back further
  /// asks that of its neighbour, which may ask it of the next one.
  void settle_folds() {
    for (std::size_t pass = 0; pass < plates_.size(); ++pass)
      for (const auto& [a, b] : fold_ends_) {
        if (!a || !b) continue;
        const double first = setback(*a), second = setback(*b);
        if (first <= 0.0 || second <= 0.0) continue;
        set_back(*a, std::max(first, second));
        set_back(*b, std::max(first, second));
      }
  }

  const PlateStructure& structure_;
  const std::vector<PlacedPlate>& plates_;
  std::vector<Touch> touches_;
  std::vector<PlateCuts> cuts_;
  std::vector<SharedEdge> shared_;
  std::vector<NarrowPlate> narrow_;
  std::vector<std::array<std::optional<FoldEnd>, 2>> fold_ends_;  ///< by fold, by end
};

}  // namespace

Trimmed trimmed_where_touching(const PlateStructure& structure, std::vector<PlacedPlate> plates) {
  Trimmed result{std::move(plates)};
  const Trimming trimming(structure, result.plates);
  result.all_touch = trimming.all_touch();
  result.shared = trimming.shared();
  result.narrow = trimming.narrow();
  std::vector<PlacedPlate> cut = result.plates;
  for (std::size_t p = 0; p < cut.size(); ++p)
    if (const auto by = cut_back(cut[p], trimming.cuts(p), structure.thickness))
      result.cut.push_back({static_cast<int>(p), *by});
  result.plates = std::move(cut);
  return result;
}

}  // namespace planish::connect_detail
