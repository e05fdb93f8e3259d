#include "touches.hpp"

#include "bend_frame.hpp"
#include "tolerances.hpp"

#include <planish/base/union_find.hpp>

#include <algorithm>
#include <optional>

// Where plates touch as a designer draws a box. At a fold of inside radius 0 both keep their edge,
// which the fold needs; which edges are folded is settled before any bend is fitted, as the tree of
// bends would settle it: the longest first.

namespace planish::connect_detail {
namespace {

/// From where to where edge i of one plate runs along edge j of the other; empty if it does not.
std::optional<std::array<double, 2>> common(const Line& a, const Line& b, double least) {
  if (a.off(b.from) > kMeantAsOne || a.off(b.to) > kMeantAsOne) return std::nullopt;
  const double p = (b.from - a.from).dot(a.along()), q = (b.to - a.from).dot(a.along());
  const double from = std::max(0.0, std::min(p, q)), to = std::min(a.length(), std::max(p, q));
  if (to - from <= least) return std::nullopt;
  return std::array{from, to};
}

bool near(const PlacedPlate& a, const PlacedPlate& b) {
  return a.box().intersects(Eigen::AlignedBox3d(b.box().min() - Vec3::Constant(kMeantAsOne),
                                                b.box().max() + Vec3::Constant(kMeantAsOne)));
}

std::vector<EdgePlace> all_edges(const PlacedPlate& plate) {
  std::vector<EdgePlace> edges;
  for (int r = 0; r < plate.ring_count(); ++r)
    for (int i = 0; i < plate.edges_of(r); ++i)
      edges.push_back({r, i});
  return edges;
}

void add_edges(const std::vector<PlacedPlate>& plates, int a, int b, double least,
               std::vector<Touch>& touches) {
  for (const EdgePlace& i : all_edges(plates[a]))
    for (const EdgePlace& j : all_edges(plates[b])) {
      const Line first = edge_of(plates[a], i), second = edge_of(plates[b], j);
      const auto on_first = common(first, second, least), on_second = common(second, first, least);
      if (on_first && on_second)
        touches.push_back({.plates = {a, b}, .edges = {i, j}, .ranges = {*on_first, *on_second}});
    }
}

void add_corners(const std::vector<PlacedPlate>& plates, int a, int b,
                 std::vector<Touch>& touches) {
  for (int i = 0; i < plates[a].edge_count(); ++i)
    for (int j = 0; j < plates[b].edge_count(); ++j)
      if ((plates[a].corner(i) - plates[b].corner(j)).norm() <= kMeantAsOne)
        touches.push_back({.plates = {a, b}, .edges = {{{0, i}, {0, j}}}, .corner = true});
}

/// Whether a request is for a fold along this stretch, as far as it says along which.
bool may_fold(const PlateStructure& structure, const std::vector<PlacedPlate>& plates,
              const BendRequest& bend, const Touch& touch) {
  if (bend.inside_radius != 0.0 || bend.between.size() != 2) return false;
  for (std::size_t p = 0; p < 2; ++p) {
    const std::string& id = structure.plates[touch.plates[p]].id;
    const auto side = std::ranges::find(bend.between, id);
    if (side == bend.between.end()) return false;
    const auto& edges = bend.edges[side - bend.between.begin()];
    const int number = plates[touch.plates[p]].edge_number(touch.edges[p]);
    if (edges && std::ranges::count(*edges, number) == 0) return false;
  }
  return true;
}

/// Each request folds the longest stretch that is left for it.
void fold_requested(const PlateStructure& structure, const std::vector<PlacedPlate>& plates,
                    const std::vector<Touch*>& longest_first) {
  for (const BendRequest& bend : structure.bends) {
    const auto touch = std::ranges::find_if(longest_first, [&](const Touch* one) {
      return !one->folded && may_fold(structure, plates, bend, *one);
    });
    if (touch != longest_first.end()) (*touch)->folded = true;
  }
}

void fold_tree(int plates, const std::vector<Touch*>& longest_first) {
  UnionFind joined(plates);
  for (Touch* touch : longest_first)
    touch->folded = joined.unite(touch->plates[0], touch->plates[1]);
}

}  // namespace

Line edge_of(const PlacedPlate& plate, const EdgePlace& edge) {
  return {plate.corner(edge), plate.corner(edge, 1)};
}

std::vector<Touch> touches_of(const PlateStructure& structure,
                              const std::vector<PlacedPlate>& plates) {
  std::vector<Touch> edges, corners;
  for (int a = 0; a < std::ssize(plates); ++a)
    for (int b = a + 1; b < std::ssize(plates); ++b) {
      if (!near(plates[a], plates[b]) ||
          plane_pair(plates[a], plates[b], kDrawn) != PlanePair::crossing)
        continue;
      add_edges(plates, a, b, structure.thickness, edges);
      add_corners(plates, a, b, corners);
    }
  std::vector<Touch*> longest_first;
  for (Touch& touch : edges)
    longest_first.push_back(&touch);
  std::ranges::stable_sort(longest_first, std::ranges::greater(), &Touch::length);
  if (!structure.bends.empty())
    fold_requested(structure, plates, longest_first);
  else if (structure.defaults.inside_radius == 0.0)
    fold_tree(static_cast<int>(plates.size()), longest_first);
  edges.insert(edges.end(), corners.begin(), corners.end());
  return edges;
}

}  // namespace planish::connect_detail
