#include "genus.hpp"

#include <planish/base/union_find.hpp>

#include <algorithm>
#include <utility>

// Handles of a solid by Euler's formula (math.md#openings-and-genus), and the openings of a patch
// of its faces. A vertex at which shells only touch is several corners: ends of edges are united
// along loops, not by place. The same count for a part of the faces, as if nothing lay beyond its
// outer edges, costs what the part has of edges.

namespace planish::brep {
namespace {

/// Faces taken for themselves, as if nothing lay beyond their outer edges, nor across edges that
/// part them. Costs what they have of edges, whatever the size of the model.
class PartSkin {
 public:
  PartSkin(const SolidModel& model, const std::vector<int>& faces, EdgeTest parts = {})
      : model_(model),
        parts_(std::move(parts)),
        sides_(sides_of(faces)),
        uses_(sides_.size(), 0),
        corners_(2 * count()) {
    for (const int f : faces) {
      const auto& loops = model.faces[f].loops;
      if (loops.empty()) continue;  // part of another face since healing
      euler_ += 2 - static_cast<int>(loops.size());
      for (const auto& loop : loops)
        for (size_t i = 0; i < loop.size(); ++i) {
          ++uses_[row_of(f, loop[i])];
          corners_.unite(end_of(f, loop[i]), start_of(f, loop[(i + 1) % loop.size()]));
        }
    }
    euler_ += corners_.count() - count();
  }

  /// V − E + Σ (2 − loops of the face).
  int euler() const { return euler_; }

  /// Closed borders with an edge that is wanted: outer edges chained at their corners.
  int borders(const EdgeTest& wanted) {
    UnionFind chains(2 * count());
    std::vector<int> roots;
    for (int e = 0; e < count(); ++e)
      if (uses_[e] == 1) {
        chains.unite(corners_.root(2 * e), corners_.root(2 * e + 1));
        if (wanted(sides_[e] / 2)) roots.push_back(corners_.root(2 * e));
      }
    for (int& root : roots)
      root = chains.root(root);
    std::ranges::sort(roots);
    return static_cast<int>(std::unique(roots.begin(), roots.end()) - roots.begin());
  }

 private:
  std::vector<int> sides_of(const std::vector<int>& faces) const {
    std::vector<int> sides;
    for (const int f : faces)
      for (const auto& loop : model_.faces[f].loops)
        for (const CoEdge& use : loop)
          sides.push_back(side_of(f, use));
    std::ranges::sort(sides);
    sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
    return sides;
  }
  /// Twice the edge; of one that parts its faces, one more for the second of them.
  int side_of(int face, const CoEdge& use) const {
    const bool second = parts_ && parts_(use.edge) && model_.edges[use.edge].faces[1] == face;
    return 2 * use.edge + (second ? 1 : 0);
  }
  int count() const { return static_cast<int>(sides_.size()); }
  int row_of(int face, const CoEdge& use) const {
    return static_cast<int>(std::ranges::lower_bound(sides_, side_of(face, use)) - sides_.begin());
  }
  /// The ends of row r are 2r and 2r + 1; ends that loops join are one corner.
  int start_of(int face, const CoEdge& use) const {
    return 2 * row_of(face, use) + (use.forward ? 0 : 1);
  }
  int end_of(int face, const CoEdge& use) const {
    return 2 * row_of(face, use) + (use.forward ? 1 : 0);
  }

  const SolidModel& model_;
  EdgeTest parts_;
  std::vector<int> sides_, uses_;
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

int closed_borders(const SolidModel& model, const std::vector<int>& faces, const EdgeTest& wanted) {
  return PartSkin(model, faces).borders(wanted);
}

PatchShape shape_of_patch(const SolidModel& model, const std::vector<int>& faces,
                          const EdgeTest& parts) {
  PartSkin patch(model, faces, parts);
  return {patch.euler(), patch.borders([](int) { return true; })};
}

}  // namespace planish::brep
