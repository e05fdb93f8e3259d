#include "heal.hpp"

#include "outline.hpp"
#include "skins.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

namespace planish::brep {
namespace {

/// mm: steps between surfaces that should meet, as kernels with 1e-3 tolerances leave them.
constexpr double kSliver = 1e-3;

void replace_use(SolidModel& model, int face, int from, CoEdge to) {
  for (auto& loop : model.faces[face].loops)
    for (CoEdge& use : loop)
      if (use.edge == from) use = to;
}

int other_face(const SolidEdge& edge, int face) {
  return edge.faces[0] == face ? edge.faces[1] : edge.faces[0];
}

/// The two long edges of a four-sided strip narrower than the tolerance.
std::optional<std::pair<int, int>> sliver_sides(const SolidModel& model, const SolidFace& face) {
  if (face.loops.size() != 1 || face.loops.front().size() < 3 || face.loops.front().size() > 4)
    return {};
  std::vector<std::pair<double, int>> lengths;
  for (const CoEdge& use : face.loops.front())
    lengths.emplace_back(model.edges[use.edge].curve.length(), use.edge);
  std::sort(lengths.rbegin(), lengths.rend());
  const SpaceCurve& a = model.edges[lengths[0].second].curve;
  const SpaceCurve& b = model.edges[lengths[1].second].curve;
  if (lengths[2].first > kSliver || lengths[1].first < 2 * kSliver) return {};
  for (const double share : {0.0, 0.5, 1.0})
    if (b.distance(a.point(a.t0 + share * (a.t1 - a.t0))) > kSliver) return {};
  return std::pair{lengths[0].second, lengths[1].second};
}

/// Whether two faces head the same way at the middle of an edge: only then was the step no intent.
bool continue_each_other(const SolidModel& model, int a, int b, const SpaceCurve& edge) {
  const SolidFace& first = model.faces[a];
  const SolidFace& second = model.faces[b];
  if (std::holds_alternative<DoublyCurved>(first.surface) ||
      std::holds_alternative<DoublyCurved>(second.surface))
    return false;
  constexpr double kSameWay = 0.996;  // cosine of 5°
  const Vec3 middle = edge.point((edge.t0 + edge.t1) / 2);
  return outward_normal_at(first, middle).dot(outward_normal_at(second, middle)) > kSameWay;
}

/// A step between two faces that were meant to meet: they share one of its edges afterwards.
void close_slivers(SolidModel& model) {
  for (size_t f = 0; f < model.faces.size(); ++f) {
    const auto sides = sliver_sides(model, model.faces[f]);
    if (!sides) continue;
    const int index = static_cast<int>(f);
    SolidEdge& kept = model.edges[sides->first];
    SolidEdge& gone = model.edges[sides->second];
    const int a = other_face(kept, index);
    const int b = other_face(gone, index);
    if (a < 0 || b < 0 || a == b || a == index || b == index ||
        !continue_each_other(model, a, b, kept.curve))
      continue;
    const bool a_forward = kept.faces[0] == a ? kept.forward[0] : kept.forward[1];
    replace_use(model, b, sides->second, {sides->first, !a_forward});
    kept.faces = {a, b};
    kept.forward = {a_forward, !a_forward};
    gone.uses = 0;
    gone.faces = {-1, -1};
    model.faces[f].loops.clear();
    model.faces[f].surface = DoublyCurved{"closed sliver"};
  }
}

/// Coplanar neighbours merged by walking round their common outline.
class PlaneMerger {
 public:
  explicit PlaneMerger(SolidModel& model) : model_(model), parent_(model.faces.size()) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  void run() {
    bool any = false;
    for (size_t e = 0; e < model_.edges.size(); ++e) {
      const SolidEdge& edge = model_.edges[e];
      if (!passed_both_ways(edge) || !plane(edge.faces[0]) || !plane(edge.faces[1])) continue;
      if (edge.faces[0] == edge.faces[1] || !smooth_edge(model_, static_cast<int>(e))) continue;
      parent_[root(edge.faces[0])] = root(edge.faces[1]);
      any = true;
    }
    if (!any) return;
    std::map<int, std::vector<int>> sets;
    for (size_t f = 0; f < parent_.size(); ++f)
      sets[root(static_cast<int>(f))].push_back(static_cast<int>(f));
    for (const auto& [leader, faces] : sets)
      if (faces.size() > 1) merge(faces);
  }

 private:
  /// Damaged solids also hold edges that both faces run along the same way.
  static bool passed_both_ways(const SolidEdge& edge) {
    return edge.uses == 2 && edge.forward[0] != edge.forward[1];
  }
  bool plane(int f) const {
    return f >= 0 && std::holds_alternative<Frame>(model_.faces[f].surface);
  }
  int root(int f) const {
    while (parent_[f] != f)
      f = parent_[f];
    return f;
  }

  struct Use {
    int face, loop, index;
  };

  void merge(const std::vector<int>& faces) {
    const std::set<int> members(faces.begin(), faces.end());
    const auto inner = [&](int e) {
      const SolidEdge& edge = model_.edges[e];
      return passed_both_ways(edge) && members.count(edge.faces[0]) && members.count(edge.faces[1]);
    };
    std::map<std::pair<int, bool>, Use> place;  // by edge and sense
    std::vector<Use> outline;
    for (const int f : faces)
      for (size_t l = 0; l < model_.faces[f].loops.size(); ++l)
        for (size_t i = 0; i < model_.faces[f].loops[l].size(); ++i) {
          const Use use{f, static_cast<int>(l), static_cast<int>(i)};
          place[{at(use).edge, at(use).forward}] = use;
          if (!inner(at(use).edge)) outline.push_back(use);
        }
    std::set<std::pair<int, bool>> seen;
    std::vector<std::vector<CoEdge>> loops;
    for (const Use& start : outline) {
      if (seen.count({at(start).edge, at(start).forward})) continue;
      std::vector<CoEdge>& loop = loops.emplace_back();
      Use use = start;
      do {
        loop.push_back(at(use));
        seen.insert({at(use).edge, at(use).forward});
        use = next(use);
        for (size_t guard = 0; inner(at(use).edge) && guard <= place.size(); ++guard)
          use = next(place.at({at(use).edge, !at(use).forward}));
      } while (!seen.count({at(use).edge, at(use).forward}));
    }
    const int leader = faces.front();
    std::set<int> inside;
    for (const auto& [key, use] : place)
      if (inner(key.first)) inside.insert(key.first);
    SolidFace& whole = model_.faces[leader];
    for (const int f : faces) {
      if (f == leader) continue;
      SolidFace& part = model_.faces[f];
      whole.volume += part.volume;
      whole.merged.push_back(f);
      part = SolidFace{DoublyCurved{"merged"}, 1, {}, {}, 0.0, 0.0};
    }
    whole.loops = std::move(loops);
    for (const auto& loop : whole.loops)
      for (const CoEdge& use : loop)
        for (int& face : model_.edges[use.edge].faces)
          if (members.count(face)) face = leader;
    for (const int e : inside) {
      model_.edges[e].uses = 0;
      model_.edges[e].faces = {-1, -1};
    }
  }

  const CoEdge& at(const Use& use) const {
    return model_.faces[use.face].loops[use.loop][use.index];
  }
  Use next(const Use& use) const {
    const auto& loop = model_.faces[use.face].loops[use.loop];
    return {use.face, use.loop, use.index + 1 < static_cast<int>(loop.size()) ? use.index + 1 : 0};
  }

  SolidModel& model_;
  std::vector<int> parent_;
};

}  // namespace

void heal(SolidModel& model) {
  close_slivers(model);
  PlaneMerger(model).run();
}

}  // namespace planish::brep
