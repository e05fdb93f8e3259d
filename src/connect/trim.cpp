#include "trim.hpp"

#include "bend_frame.hpp"
#include "cut_back.hpp"
#include "tolerances.hpp"

#include <planish/base/union_find.hpp>
#include <planish/geometry/plane.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

// Where plates touch as a designer draws a box, and by how much each has to give way. A bend of the
// radius R of the middle surface touches both plates R / tan(β/2) from the line in which their
// planes meet; as much is cut off along an edge that they share. At a corner that they share the
// edges run up to that line, so the corner is cut off where a bend would still have that radius.

namespace planish::connect_detail {
namespace {

// A share of a plate's extent: more is not cut off.
constexpr double kMostCut = 0.25;
// Edges at less than this angle (sine) to the intersection line run along it.
constexpr double kAlong = 0.02;
// Edges and corners nearer than this are meant to be one, mm: drawings are rounded.
constexpr double kTouching = 0.05;

struct Line {
  Vec3 from, to;
  double length() const { return (to - from).norm(); }
  Vec3 along() const { return (to - from).normalized(); }
  double off(const Vec3& p) const { return (p - from).cross(along()).norm(); }
};

Line edge_of(const PlacedPlate& plate, int i) {
  return {plate.corner(i), plate.corner((i + 1) % plate.edge_count())};
}

/// From an edge into its plate.
Vec3 inwards(const PlacedPlate& plate, int i) {
  return plate.frame.z.cross(edge_of(plate, i).along());
}

/// From where to where edge i of one plate runs along edge j of the other; empty if it does not.
std::optional<std::pair<double, double>> common(const Line& a, const Line& b, double least) {
  if (a.off(b.from) > kTouching || a.off(b.to) > kTouching) return std::nullopt;
  const double p = (b.from - a.from).dot(a.along()), q = (b.to - a.from).dot(a.along());
  const double from = std::max(0.0, std::min(p, q)), to = std::min(a.length(), std::max(p, q));
  if (to - from <= least) return std::nullopt;
  return std::pair{from, to};
}

class Trimming {
 public:
  Trimming(const PlateStructure& structure, const std::vector<PlacedPlate>& plates)
      : structure_(structure),
        plates_(plates),
        cuts_(plates.size()),
        touching_(static_cast<int>(plates.size())) {
    for (std::size_t p = 0; p < plates.size(); ++p)
      cuts_[p].resize(plates[p].outline.size());
    for_each_pair([this](int a, int b) { find_shared_edges(a, b); });
    for_each_pair([this](int a, int b) { find_shared_corners(a, b); });
  }

  bool all_touch() {
    for (int p = 1; p < std::ssize(plates_); ++p)
      if (!touching_.same(p, 0)) return false;
    return plates_.size() > 1;
  }

  const std::vector<EdgeCut>& cuts(std::size_t plate) const { return cuts_[plate]; }
  const std::vector<SharedEdge>& shared() const { return shared_; }

 private:
  template <typename Look>
  void for_each_pair(const Look& look) {
    for (int a = 0; a < std::ssize(plates_); ++a)
      for (int b = a + 1; b < std::ssize(plates_); ++b)
        if (near(plates_[a], plates_[b]) &&
            plane_pair(plates_[a], plates_[b], kDrawn) == PlanePair::crossing)
          look(a, b);
  }

  static bool near(const PlacedPlate& a, const PlacedPlate& b) {
    return a.box().intersects(Eigen::AlignedBox3d(b.box().min() - Vec3::Constant(kTouching),
                                                  b.box().max() + Vec3::Constant(kTouching)));
  }

  // The radius of the middle surface of the bend between two plates.
  double radius(int a, int b) const {
    std::optional<double> inside = structure_.defaults.inside_radius;
    for (const BendRequest& bend : structure_.bends) {
      const auto joins = [&](int p) {
        return std::ranges::find(bend.between, structure_.plates[p].id) != bend.between.end();
      };
      if (joins(a) && joins(b) && bend.inside_radius) inside = bend.inside_radius;
    }
    return inside.value_or(structure_.thickness) + 0.5 * structure_.thickness;
  }

  // How far back both plates have to stay from the line; empty if that is too much of either.
  std::optional<double> depth(int a, int b, const Vec3& into_a, const Vec3& into_b) const {
    const double cut = radius(a, b) / std::tan(0.5 * angle_between(into_a, into_b));
    if (cut > kMostCut * std::min(plates_[a].extent, plates_[b].extent)) return std::nullopt;
    return cut;
  }

  void find_shared_edges(int a, int b) {
    for (int i = 0; i < plates_[a].edge_count(); ++i)
      for (int j = 0; j < plates_[b].edge_count(); ++j) {
        const Line first = edge_of(plates_[a], i), second = edge_of(plates_[b], j);
        const auto on_first = common(first, second, structure_.thickness);
        const auto on_second = common(second, first, structure_.thickness);
        if (!on_first || !on_second) continue;
        touching_.unite(a, b);
        const auto cut = depth(a, b, inwards(plates_[a], i), inwards(plates_[b], j));
        if (!cut) continue;
        // Of edges that miss each other, one may reach over the line where the planes meet.
        const double missed = std::max(first.off(second.from), first.off(second.to));
        const double back = *cut + (missed > kDrawn ? missed : 0.0);
        cuts_[a][i].strips.push_back({on_first->first, on_first->second, back});
        cuts_[b][j].strips.push_back({on_second->first, on_second->second, back});
        shared_.push_back({{a, b},
                           first.from + on_first->first * first.along(),
                           first.from + on_first->second * first.along()});
      }
  }

  bool cut_already(int plate, int corner) const {
    const int n = plates_[plate].edge_count();
    return !cuts_[plate][corner].strips.empty() ||
           !cuts_[plate][(corner + n - 1) % n].strips.empty();
  }

  void find_shared_corners(int a, int b) {
    for (int i = 0; i < plates_[a].edge_count(); ++i)
      for (int j = 0; j < plates_[b].edge_count(); ++j) {
        if ((plates_[a].corner(i) - plates_[b].corner(j)).norm() > kTouching) continue;
        touching_.unite(a, b);
        if (cut_already(a, i) || cut_already(b, j)) continue;
        cut_corner(a, i, b);
        cut_corner(b, j, a);
        shared_.push_back({{a, b}, plates_[a].corner(i), plates_[a].corner(i)});
      }
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
    double& corner_cut = cuts_[own][corner].corner;
    corner_cut = std::max(corner_cut, std::min(*cut / least, kMostCut * shortest));
  }

  const PlateStructure& structure_;
  const std::vector<PlacedPlate>& plates_;
  std::vector<std::vector<EdgeCut>> cuts_;  ///< by plate, by edge
  std::vector<SharedEdge> shared_;
  UnionFind touching_;
};

bool folds_sharply(const PlateStructure& structure) {
  const auto sharp = [](const auto& with) { return with.inside_radius == 0.0; };
  return sharp(structure.defaults) || std::ranges::any_of(structure.bends, sharp);
}

}  // namespace

Trimmed trimmed_where_touching(const PlateStructure& structure, std::vector<PlacedPlate> plates) {
  Trimmed result{std::move(plates), {}, {}};
  if (!structure.trim.value_or(true) || folds_sharply(structure)) return result;
  Trimming trimming(structure, result.plates);
  if (!structure.trim && !trimming.all_touch()) return result;
  result.shared = trimming.shared();
  std::vector<PlacedPlate> cut = result.plates;
  for (std::size_t p = 0; p < cut.size(); ++p)
    if (const auto by = cut_back(cut[p], trimming.cuts(p), structure.thickness))
      result.cut.push_back({static_cast<int>(p), *by});
  result.plates = std::move(cut);
  return result;
}

}  // namespace planish::connect_detail
