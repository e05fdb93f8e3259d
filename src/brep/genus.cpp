#include "genus.hpp"

#include <planish/base/union_find.hpp>

#include <algorithm>

// Handles of a solid by Euler's formula (math.md#openings-and-genus), and the openings of a patch
// of its faces. A vertex at which shells only touch is several corners: ends of edges are united
// along loops, not by place. The same count for a part of the faces, as if nothing lay beyond its
// outer edges, costs what the part has of edges.

namespace planish::brep {
namespace {

/// Faces taken for themselves, as if nothing lay beyond their outer edges. Costs what they have of
/// edges, whatever the size of the model.
class PartSkin {
 public:
  PartSkin(const SolidModel& model, const std::vector<int>& faces)
      : edges_(edges_of(model, faces)), uses_(edges_.size(), 0), corners_(2 * count()) {
    for (const int f : faces) {
      const auto& loops = model.faces[f].loops;
      if (loops.empty()) continue;  // part of another face since healing
      euler_ += 2 - static_cast<int>(loops.size());
      for (const auto& loop : loops)
        for (size_t i = 0; i < loop.size(); ++i) {
          ++uses_[row_of(loop[i].edge)];
          corners_.unite(end_of(loop[i]), start_of(loop[(i + 1) % loop.size()]));
        }
    }
    euler_ += corners_.count() - count();
  }

  /// V − E + Σ (2 − loops of the face).
  int euler() const { return euler_; }

  /// Closed borders with an edge that is wanted: outer edges chained at their corners.
  int borders(const std::function<bool(int edge)>& wanted) {
    UnionFind chains(2 * count());
    std::vector<int> roots;
    for (int e = 0; e < count(); ++e)
      if (uses_[e] == 1) {
        chains.unite(corners_.root(2 * e), corners_.root(2 * e + 1));
        if (wanted(edges_[e])) roots.push_back(corners_.root(2 * e));
      }
    for (int& root : roots)
      root = chains.root(root);
    std::ranges::sort(roots);
    return static_cast<int>(std::unique(roots.begin(), roots.end()) - roots.begin());
  }

 private:
  static std::vector<int> edges_of(const SolidModel& model, const std::vector<int>& faces) {
    std::vector<int> edges;
    for (const int f : faces)
      for (const auto& loop : model.faces[f].loops)
        for (const CoEdge& use : loop)
          edges.push_back(use.edge);
    std::ranges::sort(edges);
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
  }
  int count() const { return static_cast<int>(edges_.size()); }
  int row_of(int edge) const {
    return static_cast<int>(std::ranges::lower_bound(edges_, edge) - edges_.begin());
  }
  /// The ends of edge e are 2e and 2e + 1; ends that loops join are one corner.
  int start_of(const CoEdge& use) const { return 2 * row_of(use.edge) + (use.forward ? 0 : 1); }
  int end_of(const CoEdge& use) const { return 2 * row_of(use.edge) + (use.forward ? 1 : 0); }

  std::vector<int> edges_, uses_;
  UnionFind corners_;
  int euler_ = 0;
};

bool is_closed(const SolidModel& model) {
  return std::ranges::all_of(model.edges, [](const SolidEdge& edge) {
    return edge.uses == 0 || (edge.uses == 2 && edge.forward[0] != edge.forward[1]);
  });
}

int shells_of(const SolidModel& model) {
  UnionFind sets(static_cast<int>(model.faces.size()));
  int shells = 0;
  for (const SolidFace& face : model.faces)
    shells += face.loops.empty() ? 0 : 1;
  for (const SolidEdge& edge : model.edges)
    if (edge.uses == 2 && sets.unite(edge.faces[0], edge.faces[1])) --shells;
  return shells;
}

std::vector<int> all_faces(const SolidModel& model) {
  std::vector<int> faces;
  for (int f = 0; f < std::ssize(model.faces); ++f)
    faces.push_back(f);
  return faces;
}

}  // namespace

std::optional<int> genus_of(const SolidModel& model) {
  if (!is_closed(model)) return {};
  const int missing = 2 * shells_of(model) - PartSkin(model, all_faces(model)).euler();
  if (missing < 0 || missing % 2 != 0) return {};
  return missing / 2;
}

int openings_through(const SolidModel& model, const std::vector<int>& faces) {
  PartSkin patch(model, faces);
  return (patch.borders([](int) { return true; }) - patch.euler()) / 2;
}

int closed_borders(const SolidModel& model, const std::vector<int>& faces,
                   const std::function<bool(int edge)>& wanted) {
  return PartSkin(model, faces).borders(wanted);
}

}  // namespace planish::brep
