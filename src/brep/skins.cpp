#include "skins.hpp"

#include "dihedral.hpp"
#include "divided_skin.hpp"
#include "model_places.hpp"
#include "refusals.hpp"

#include <planish/base/id_vector.hpp>

#include <algorithm>
#include <limits>

// Both skins of a sheet, grown over smooth and sharply bent edges from candidates: faces that have
// enough of their area covered by opposite ones at the sheet's thickness, or by the floors of
// pockets. The first skin is the
// largest component (of a flat plate the largest in one plane), the second the one that shares most
// area with it. An island opposite one skin, cut off from the other, belongs to that other. At last
// depths must agree, or it is no sheet.

namespace planish::brep {
namespace {

/// Faces with enough material of the sheet's thickness below them to be skin.
std::vector<bool> covered_faces(const FacePairs& pairs) {
  constexpr double kCovered = 0.3;  // of the face
  return mapped(pairs.covered, [&](double share) { return share >= kCovered; });
}

/// The same, and planes that pockets across the sheet leave little of: most of what lies below them
/// is nearer than the sheet is thick.
std::vector<bool> covered_over_pockets(const SolidModel& model,
                                       const std::vector<Outline>& outlines, const FacePairs& pairs,
                                       double thickness, double slack) {
  constexpr double kRim = 0.02;   // of the face, at the thickness
  constexpr double kFloor = 0.5;  // of the face, with the floors of pockets
  const auto nearer = [&](int f) {
    double area = 0.0;
    for (int g = 0; g < std::ssize(outlines); ++g)
      if (const auto seen = g == f ? std::nullopt : opposite(model, outlines, f, g);
          seen && seen->depth > slack && seen->depth < thickness - slack && seen->spread <= slack)
        area += seen->overlap;
    return area;
  };
  std::vector<bool> candidates = covered_faces(pairs);
  for (int f = 0; f < std::ssize(candidates); ++f) {
    const double rim = pairs.covered[f];
    if (candidates[f] || rim < kRim || !std::holds_alternative<Frame>(model.faces[f].surface))
      continue;
    candidates[f] = rim + nearer(f) / outlines[f].area >= kFloor;
  }
  return candidates;
}

/// Candidates connected over smooth and sharply bent edges.
struct Components {
  std::vector<int> of_face;    ///< −1 for faces that are not candidates
  std::vector<double> area;    ///< mm²
  std::vector<bool> in_plane;  ///< whether all faces lie in one plane
};

/// Whether both faces are planes that face the same way.
bool in_one_plane(const SolidFace& a, const SolidFace& b) {
  constexpr double kNearlyParallel = 0.9995;  // cosine; 1.8°
  const auto* first = std::get_if<Frame>(&a.surface);
  const auto* second = std::get_if<Frame>(&b.surface);
  return first && second && first->z.dot(second->z) > kNearlyParallel;
}

std::vector<std::vector<int>> skin_neighbours(const SolidModel& model,
                                              const std::vector<bool>& candidates,
                                              const std::vector<SharpEdge>& sharp) {
  std::vector<std::vector<int>> neighbours(model.faces.size());
  const auto join = [&](int e) {
    const auto& [f, g] = model.edges[e].faces;
    neighbours[f].push_back(g);
    neighbours[g].push_back(f);
  };
  for (int e = 0; e < std::ssize(model.edges); ++e) {
    if (!smooth_edge(model, e)) continue;
    const auto& [f, g] = model.edges[e].faces;
    if (candidates[f] && candidates[g]) join(e);
  }
  for (const SharpEdge& edge : sharp)
    join(edge.edge);
  return neighbours;
}

Components components_of(const SolidModel& model, const std::vector<std::vector<int>>& neighbours,
                         const std::vector<bool>& candidates,
                         const std::vector<Outline>& outlines) {
  Components components{std::vector<int>(candidates.size(), -1), {}, {}};
  for (int f = 0; f < std::ssize(candidates); ++f) {
    if (!candidates[f] || components.of_face[f] >= 0) continue;
    const int label = static_cast<int>(components.area.size());
    double& area = components.area.emplace_back(0.0);
    bool in_plane = true;
    std::vector<int> stack{f};
    components.of_face[f] = label;
    while (!stack.empty()) {
      const int at = stack.back();
      stack.pop_back();
      area += outlines[at].area;
      in_plane = in_plane && in_one_plane(model.faces[f], model.faces[at]);
      for (const int next : neighbours[at])
        if (components.of_face[next] < 0) {
          components.of_face[next] = label;
          stack.push_back(next);
        }
    }
    components.in_plane.push_back(in_plane);
  }
  return components;
}

/// The component that shares the most area with another across the thickness, and that area.
std::pair<int, double> most_opposite(const Components& components, const FacePairs& pairs,
                                     int first) {
  std::vector<double> shared(components.area.size(), 0.0);
  for (const FacePair& pair : pairs.rows) {
    const int a = components.of_face[pair.a];
    const int b = components.of_face[pair.b];
    if (a < 0 || b < 0) continue;
    if (a == first) shared[b] += pair.opposite.overlap;
    if (b == first) shared[a] += pair.opposite.overlap;
  }
  const auto most = std::ranges::max_element(shared);
  return {static_cast<int>(most - shared.begin()), *most};
}

/// The component at which the first skin starts; −1 if there is none.
int first_component(const Components& components, SkinStart start) {
  int first = -1;
  for (int c = 0; c < std::ssize(components.area); ++c) {
    if (start == SkinStart::largest_plane && !components.in_plane[c]) continue;
    if (first < 0 || components.area[c] > components.area[first]) first = c;
  }
  return first;
}

/// The component at which the first skin starts and the one opposite it.
Result<std::pair<int, int>> two_skins(const SolidModel& model, const std::vector<Outline>& outlines,
                                      const Components& components, const FacePairs& pairs,
                                      SkinStart start) {
  const auto place_of = [&](int component) {
    int largest = -1;
    for (int f = 0; f < std::ssize(components.of_face); ++f)
      if (components.of_face[f] == component &&
          (largest < 0 || outlines[f].area > outlines[largest].area))
        largest = f;
    return face_place(model, largest);
  };
  const int first = first_component(components, start);
  if (first < 0) return fail(refuse::no_common_thickness);
  const auto [second, shared] = most_opposite(components, pairs, first);
  if (shared <= 0.0) return fail(refuse::nothing_opposite, {{"face", place_of(first)}});
  if (second == first) return fail(refuse::skins_run_together, {{"face", place_of(first)}});
  return std::pair{first, second};
}

/// Faces opposite one skin but cut off from the other (a tongue that a bend runs past) belong to
/// that other skin.
std::vector<std::pair<int, Skin>> islands_of(const Skins& skins,
                                             const std::vector<bool>& candidates) {
  std::vector<std::pair<int, Skin>> islands;
  for (int f = 0; f < std::ssize(candidates); ++f) {
    if (!candidates[f] || skins.skin_of[f] != Skin::none) continue;
    const auto& partners = skins.partners[f];
    const auto all_on = [&](Skin skin) {
      return !partners.empty() &&
             std::ranges::all_of(partners, [&](int p) { return skins.skin_of[p] == skin; });
    };
    if (all_on(Skin::first)) islands.emplace_back(f, Skin::second);
    if (all_on(Skin::second)) islands.emplace_back(f, Skin::first);
  }
  return islands;
}

/// Mean and spread of the depths of all pairs with a face of the first skin.
struct Measured {
  double thickness = 0.0;
  double spread = 0.0;
};
Measured measured(const FacePairs& pairs, const Components& components, int first) {
  double lo = std::numeric_limits<double>::infinity();
  double hi = 0.0;
  double weight = 0.0;
  double mean = 0.0;
  for (const FacePair& pair : pairs.rows) {
    if (components.of_face[pair.a] != first && components.of_face[pair.b] != first) continue;
    lo = std::min(lo, pair.opposite.depth - pair.opposite.spread / 2);
    hi = std::max(hi, pair.opposite.depth + pair.opposite.spread / 2);
    weight += pair.opposite.overlap;
    mean += pair.opposite.overlap * pair.opposite.depth;
  }
  return {mean / weight, std::max(0.0, hi - lo)};
}

}  // namespace

Result<Skins> find_skins(const SolidModel& model, const std::vector<Outline>& outlines,
                         double thickness, double tolerance, SkinStart start) {
  const double slack = tolerance * thickness;
  const FacePairs pairs = pair_faces(model, outlines, thickness, slack);
  std::vector<bool> candidates = start == SkinStart::milled
                                     ? covered_over_pockets(model, outlines, pairs, thickness,
                                                            slack)
                                     : covered_faces(pairs);
  const auto rounded = rounded_outsides(model, outlines, candidates, thickness, slack);
  for (const RoundedOutside& outside : rounded)
    candidates[outside.face] = true;
  Skins skins;
  skins.sharp = find_sharp_edges(model, pairs.partners, candidates, rounded, thickness);
  const Components components = components_of(
      model, skin_neighbours(model, candidates, skins.sharp), candidates, outlines);
  const auto both = two_skins(model, outlines, components, pairs, start);
  if (!both) return pass_on(both);
  const auto [first, second] = *both;
  skins.partners = pairs.partners;
  for (const int component : components.of_face)
    skins.skin_of.push_back(component == first    ? Skin::first
                            : component == second ? Skin::second
                                                  : Skin::none);
  for (const auto& [f, skin] : islands_of(skins, candidates)) {
    skins.skin_of[f] = skin;
    (skin == Skin::first ? skins.islands_first : skins.islands_second) += 1;
  }
  add_divided(skins, model, candidates);
  skins.area_first = components.area[first];
  skins.area_second = components.area[second];
  const Measured found = measured(pairs, components, first);
  skins.thickness = found.thickness;
  skins.spread = found.spread;
  return skins;
}

}  // namespace planish::brep
