#include "heal.hpp"

#include "dihedral.hpp"
#include "slivers.hpp"

#include <planish/base/union_find.hpp>

#include <map>
#include <set>

// The model as it was meant: slivers closed (slivers.cpp), neighbouring planes that continue each
// other made one face. Its outline is walked anew: at an edge between two of the faces the walk
// goes on in the other one. A merged face keeps the number of the first, and the others stay in the
// list without loops, so that numbers are those of the file.

namespace planish::brep {
namespace {

/// Damaged solids may also have edges that both faces run along the same way.
bool passed_both_ways(const SolidEdge& edge) {
  return edge.uses == 2 && edge.forward[0] != edge.forward[1];
}

bool is_plane(const SolidModel& model, int f) {
  return f >= 0 && std::holds_alternative<Frame>(model.faces[f].surface);
}

/// Sets of two or more connected planes that continue each other, in the order of their numbers.
std::vector<std::vector<int>> coplanar_faces(const SolidModel& model) {
  UnionFind sets(static_cast<int>(model.faces.size()));
  for (int e = 0; e < std::ssize(model.edges); ++e) {
    const SolidEdge& edge = model.edges[e];
    if (passed_both_ways(edge) && is_plane(model, edge.faces[0]) &&
        is_plane(model, edge.faces[1]) && edge.faces[0] != edge.faces[1] && smooth_edge(model, e))
      sets.unite(edge.faces[0], edge.faces[1]);
  }
  std::map<int, std::vector<int>> by_root;
  for (int f = 0; f < std::ssize(model.faces); ++f)
    by_root[sets.root(f)].push_back(f);
  std::vector<std::vector<int>> several;
  for (auto& [root, faces] : by_root)
    if (faces.size() > 1) several.push_back(std::move(faces));
  return several;
}

/// Edges with one of the faces on both sides.
std::set<int> edges_between(const SolidModel& model, const std::set<int>& faces) {
  std::set<int> edges;
  for (const int f : faces)
    for (const auto& loop : model.faces[f].loops)
      for (const CoEdge& use : loop) {
        const SolidEdge& edge = model.edges[use.edge];
        if (passed_both_ways(edge) && faces.count(edge.faces[0]) && faces.count(edge.faces[1]))
          edges.insert(use.edge);
      }
  return edges;
}

/// Where an edge is used: faces[face].loops[loop][index].
struct UsePlace {
  int face = 0;
  int loop = 0;
  int index = 0;
};

const CoEdge& use_at(const SolidModel& model, const UsePlace& place) {
  return model.faces[place.face].loops[place.loop][place.index];
}

UsePlace place_after(const SolidModel& model, const UsePlace& place) {
  const auto& loop = model.faces[place.face].loops[place.loop];
  const int next = place.index + 1;
  return {place.face, place.loop, next < std::ssize(loop) ? next : 0};
}

std::vector<UsePlace> places_in(const SolidModel& model, const std::vector<int>& faces) {
  std::vector<UsePlace> places;
  for (const int f : faces)
    for (int l = 0; l < std::ssize(model.faces[f].loops); ++l)
      for (int i = 0; i < std::ssize(model.faces[f].loops[l]); ++i)
        places.push_back({f, l, i});
  return places;
}

/// Loops of the faces taken as one: at an edge between two of them the walk continues in the other.
std::vector<std::vector<CoEdge>> common_outline(const SolidModel& model,
                                                const std::vector<int>& faces,
                                                const std::set<int>& between) {
  using Key = std::pair<int, bool>;  // edge and sense of its use
  const auto key = [&](const UsePlace& place) {
    const CoEdge& use = use_at(model, place);
    return Key{use.edge, use.forward};
  };
  const std::vector<UsePlace> places = places_in(model, faces);
  std::map<Key, UsePlace> place_of;
  for (const UsePlace& place : places)
    place_of[key(place)] = place;
  std::set<Key> seen;
  std::vector<std::vector<CoEdge>> loops;
  for (const UsePlace& start : places) {
    if (between.count(key(start).first) || seen.count(key(start))) continue;
    std::vector<CoEdge>& loop = loops.emplace_back();
    UsePlace at = start;
    do {
      loop.push_back(use_at(model, at));
      seen.insert(key(at));
      at = place_after(model, at);
      for (size_t guard = 0; between.count(key(at).first) && guard <= place_of.size(); ++guard)
        at = place_after(model, place_of.at({key(at).first, !key(at).second}));
    } while (!seen.count(key(at)));
  }
  return loops;
}

/// The faces merged into one, which has the number of the first.
SolidModel with_merged(SolidModel model, const std::vector<int>& faces) {
  const int leader = faces.front();
  const std::set<int> members(faces.begin(), faces.end());
  const std::set<int> between = edges_between(model, members);
  auto loops = common_outline(model, faces, between);
  SolidFace& whole = model.faces[leader];
  for (const int f : faces) {
    if (f == leader) continue;
    SolidFace& part = model.faces[f];
    whole.volume += part.volume;
    whole.merged.push_back(f);
    part = SolidFace{DoublyCurved{"merged"}, 1, {}, {}, 0.0, 0.0};
  }
  whole.loops = std::move(loops);
  for (const auto& loop : whole.loops)
    for (const CoEdge& use : loop)
      for (int side = 0; side < 2; ++side) {
        SolidEdge& edge = model.edges[use.edge];
        if (!members.count(edge.faces[side])) continue;
        edge.merged_faces[side] = face_as_read(edge, side);
        edge.faces[side] = leader;
      }
  for (const int e : between) {
    model.edges[e].uses = 0;
    model.edges[e].faces = {-1, -1};
  }
  return model;
}

}  // namespace

SolidModel healed(SolidModel model) {
  model = without_slivers(std::move(model));
  for (const auto& faces : coplanar_faces(model))
    model = with_merged(std::move(model), faces);
  return model;
}

}  // namespace planish::brep
