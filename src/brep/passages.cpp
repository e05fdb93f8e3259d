#include "passages.hpp"

#include "projection.hpp"

#include <planish/base/tolerance.hpp>

#include <algorithm>
#include <limits>
#include <map>
#include <queue>
#include <set>

// Where a form lets through, as a smallest cut of a graph (math.md#pilot-holes): nodes are its
// faces, an edge of the solid costs its length to cut, and a face that looks towards one skin costs
// its projected area on the other's side. Shortest augmenting paths find the cut; its edges are
// chained into closed curves face by face round each corner. A lip that is rolled looks both ways:
// then areas are left out, and the shortest edges decide.

namespace planish::brep {
namespace {

/// A directed graph with capacities, of which a smallest cut is found by augmenting shortest paths.
class FlowGraph {
 public:
  explicit FlowGraph(int nodes) : out_(nodes) {}

  void add(int from, int to, double there, double back) {
    out_[from].push_back(static_cast<int>(arcs_.size()));
    arcs_.push_back({to, there});
    out_[to].push_back(static_cast<int>(arcs_.size()));
    arcs_.push_back({from, back});
  }

  /// By node, whether it stays on the side of the source. `least`: what counts as no capacity.
  std::vector<bool> source_side(int source, int sink, double least) {
    for (;;) {
      const std::vector<int> arrived = search(source, least);
      if (arrived[sink] < 0) {
        std::vector<bool> side;
        for (int node = 0; node < std::ssize(out_); ++node)
          side.push_back(node == source || arrived[node] >= 0);
        return side;
      }
      double room = std::numeric_limits<double>::infinity();
      for (int at = sink; at != source; at = arcs_[arrived[at] ^ 1].to)
        room = std::min(room, arcs_[arrived[at]].capacity);
      for (int at = sink; at != source; at = arcs_[arrived[at] ^ 1].to) {
        arcs_[arrived[at]].capacity -= room;
        arcs_[arrived[at] ^ 1].capacity += room;
      }
    }
  }

 private:
  struct Arc {
    int to = 0;
    double capacity = 0.0;
  };
  /// By node, the arc over which it was reached; −1: not reached, or the source.
  std::vector<int> search(int source, double least) const {
    std::vector<int> arrived(out_.size(), -1);
    std::queue<int> open;
    open.push(source);
    while (!open.empty()) {
      const int node = open.front();
      open.pop();
      for (const int a : out_[node]) {
        const int next = arcs_[a].to;
        if (next == source || arrived[next] >= 0 || arcs_[a].capacity <= least) continue;
        arrived[next] = a;
        open.push(next);
      }
    }
    return arrived;
  }

  std::vector<Arc> arcs_;
  std::vector<std::vector<int>> out_;
};

enum class Half { none, here, there };

/// Which faces are on which side of a cut: those of the part by the cut, those of the skins as they
/// are.
class Halves {
 public:
  Halves(const Recognition& of, const RimPart& part, const std::vector<bool>& here) : of_(of) {
    for (size_t i = 0; i < part.faces.size(); ++i)
      half_[part.faces[i]] = here[i] ? Half::here : Half::there;
  }
  Half of(int face) const {
    if (face < 0) return Half::none;
    if (const auto found = half_.find(face); found != half_.end()) return found->second;
    const Skin skin = of_.skins.skin_of[face];
    return skin == Skin::none ? Half::none : skin == of_.skin ? Half::here : Half::there;
  }

 private:
  const Recognition& of_;
  std::map<int, Half> half_;
};

using EdgeUsePlace = std::pair<int, bool>;  // an edge and the sense of its use

/// The uses of the cut's edges by faces on this side of it.
std::map<EdgeUsePlace, int> cut_uses(const Recognition& of, const RimPart& part,
                                     const Halves& halves) {
  std::map<EdgeUsePlace, int> uses;  // with the face
  for (const int f : part.faces)
    for (const auto& loop : of.model.faces[f].loops)
      for (const CoEdge& use : loop) {
        const int other = face_across(of.model.edges[use.edge], f);
        if (other == f || halves.of(other) == Half::none || halves.of(other) == halves.of(f))
          continue;
        if (halves.of(f) == Half::here)
          uses.emplace(EdgeUsePlace{use.edge, use.forward}, f);
        else
          uses.emplace(EdgeUsePlace{use.edge, !use.forward}, other);
      }
  return uses;
}

/// The use that follows in the face's loop.
std::optional<CoEdge> use_after(const SolidModel& model, int face, const EdgeUsePlace& place) {
  for (const auto& loop : model.faces[face].loops)
    for (size_t i = 0; i < loop.size(); ++i)
      if (EdgeUsePlace{loop[i].edge, loop[i].forward} == place) return loop[(i + 1) % loop.size()];
  return {};
}

/// The cut's edges chained along the faces on this side; empty where they do not close.
std::vector<std::vector<CoEdge>> chained_cut(const Recognition& of, const RimPart& part,
                                             const Halves& halves) {
  const std::map<EdgeUsePlace, int> uses = cut_uses(of, part, halves);
  std::vector<std::vector<CoEdge>> chains;
  std::set<EdgeUsePlace> seen;
  for (const auto& start : uses) {
    if (seen.count(start.first)) continue;
    std::vector<CoEdge>& chain = chains.emplace_back();
    EdgeUsePlace place = start.first;
    int face = start.second;
    while (seen.insert(place).second) {
      chain.push_back({place.first, place.second});
      // Round the corner, face by face, to where the cut goes on.
      for (size_t turns = 0;; ++turns) {
        const auto next = use_after(of.model, face, place);
        if (!next || turns > of.model.edges.size()) return {};
        place = {next->edge, next->forward};
        if (uses.count(place)) break;
        face = face_across(of.model.edges[place.first], face);
        if (halves.of(face) != Half::here) return {};
        place.second = !place.second;
      }
      face = uses.at(place);
    }
    if (place != start.first) return {};
  }
  return chains;
}

/// The cut where an edge costs so much a millimetre and areas count `area_share`.
std::vector<std::vector<CoEdge>> cheapest_cut(const Recognition& of, const RimPart& part,
                                              const std::vector<double>& areas,
                                              const EdgeLength& length_of, double area_share) {
  constexpr double kEdgeShare = 0.01;  // of the thickness: as much area as a mm of edge costs
  const int count = static_cast<int>(part.faces.size());
  const int source = count;
  const int sink = count + 1;
  std::map<int, int> node_of;
  for (int i = 0; i < count; ++i)
    node_of[part.faces[i]] = i;
  FlowGraph graph(count + 2);
  std::set<int> met;
  for (int i = 0; i < count; ++i) {
    const double area = area_share * areas[i];
    graph.add(source, i, std::max(area, 0.0), 0.0);
    graph.add(i, sink, std::max(-area, 0.0), 0.0);
    for (const auto& loop : of.model.faces[part.faces[i]].loops)
      for (const CoEdge& use : loop) {
        const SolidEdge& edge = of.model.edges[use.edge];
        const int other = face_across(edge, part.faces[i]);
        if (other < 0 || other == part.faces[i] || !met.insert(use.edge).second) continue;
        const double cost = kEdgeShare * of.skins.thickness * length_of(use.edge);
        if (const auto node = node_of.find(other); node != node_of.end())
          graph.add(i, node->second, cost, cost);
        else if (of.skins.skin_of[other] == of.skin)
          graph.add(source, i, cost, 0.0);
        else if (of.skins.skin_of[other] != Skin::none)
          graph.add(i, sink, cost, 0.0);
      }
  }
  const double least = tolerance::kComputed * of.skins.thickness * of.skins.thickness;
  return chained_cut(of, part, Halves(of, part, graph.source_side(source, sink, least)));
}

}  // namespace

std::vector<std::vector<CoEdge>> passages(const Recognition& of, const RimPart& part,
                                          const Frame& plane) {
  return passages(of, part, plane, [&](int e) { return of.model.edges[e].curve.length(); });
}

std::vector<std::vector<CoEdge>> passages(const Recognition& of, const RimPart& part,
                                          const Frame& plane, const EdgeLength& length_of) {
  const auto areas = mapped(part.faces, [&](int f) { return projected_area(of.model, f, plane); });
  // A rolled lip looks both ways, and areas part it as well; the shortest edges then decide.
  for (const double area_share : {1.0, 0.0}) {
    auto chains = cheapest_cut(of, part, areas, length_of, area_share);
    if (std::ssize(chains) == part.openings) return chains;
  }
  return {};
}

}  // namespace planish::brep
