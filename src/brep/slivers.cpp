#include "slivers.hpp"

#include "outline.hpp"

#include <planish/base/id_vector.hpp>

#include <algorithm>

// Faces narrower than the accuracy of files, between two that were meant to meet. One long edge
// replaces the other, and the sliver keeps its number without loops. Only where both neighbours
// have one direction at the edge: elsewhere the step may be meant.

namespace planish::brep {
namespace {

/// mm: steps between surfaces that should meet, as left by kernels with tolerances of this size.
constexpr double kSliver = 1e-3;

/// The long edges of a strip: one stays, the other goes.
struct Sides {
  int kept = 0;
  int gone = 0;
};

/// Empty unless the face has four edges, or three, and is narrower than the tolerance.
std::optional<Sides> sliver_sides(const SolidModel& model, const SolidFace& face) {
  if (face.loops.size() != 1 || face.loops.front().size() < 3 || face.loops.front().size() > 4)
    return {};
  auto lengths = mapped(face.loops.front(), [&](const CoEdge& use) {
    return std::pair<double, int>(model.edges[use.edge].curve.length(), use.edge);
  });
  std::sort(lengths.rbegin(), lengths.rend());
  const SpaceCurve& a = model.edges[lengths[0].second].curve;
  const SpaceCurve& b = model.edges[lengths[1].second].curve;
  if (lengths[2].first > kSliver || lengths[1].first < 2 * kSliver) return {};
  for (const double share : {0.0, 0.5, 1.0})
    if (b.distance(a.point(a.t0 + share * (a.t1 - a.t0))) > kSliver) return {};
  return Sides{lengths[0].second, lengths[1].second};
}

/// Whether two faces have the same direction at the middle of an edge: only then was the step
/// unintended.
bool continue_each_other(const SolidFace& a, const SolidFace& b, const SpaceCurve& edge) {
  if (std::holds_alternative<DoublyCurved>(a.surface) ||
      std::holds_alternative<DoublyCurved>(b.surface))
    return false;
  constexpr double kSameWay = 0.996;  // cosine of 5°
  const Vec3 middle = edge.point((edge.t0 + edge.t1) / 2);
  return outward_normal_at(a, middle).dot(outward_normal_at(b, middle)) > kSameWay;
}

void replace_use(SolidFace& face, int from, CoEdge to) {
  for (auto& loop : face.loops)
    for (CoEdge& use : loop)
      if (use.edge == from) use = to;
}

}  // namespace

SolidModel without_slivers(SolidModel model) {
  for (int f = 0; f < std::ssize(model.faces); ++f) {
    const auto sides = sliver_sides(model, model.faces[f]);
    if (!sides) continue;
    SolidEdge& kept = model.edges[sides->kept];
    SolidEdge& gone = model.edges[sides->gone];
    const int a = face_across(kept, f);
    const int b = face_across(gone, f);
    if (a < 0 || b < 0 || a == b || a == f || b == f ||
        !continue_each_other(model.faces[a], model.faces[b], kept.curve))
      continue;
    const bool a_forward = kept.faces[0] == a ? kept.forward[0] : kept.forward[1];
    replace_use(model.faces[b], sides->gone, {sides->kept, !a_forward});
    kept.faces = {a, b};
    kept.forward = {a_forward, !a_forward};
    gone.uses = 0;
    gone.faces = {-1, -1};
    model.faces[f].loops.clear();
    model.faces[f].surface = DoublyCurved{"closed sliver"};
  }
  return model;
}

}  // namespace planish::brep
