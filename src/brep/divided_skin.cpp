#include "divided_skin.hpp"

#include <planish/base/id_vector.hpp>
#include <planish/base/union_find.hpp>

#include <algorithm>
#include <cmath>
#include <map>

// A groove from edge to edge divides a skin. Of the reference skin what is the largest with all
// that is joined to it stays; the rest of its planes belongs to the rim, and the silhouette
// (math.md#silhouette) unites them again.

namespace planish::brep {

bool in_plane_of(const SolidModel& model, int f, int other, double spread) {
  constexpr double kAlike = 1.0 - 1e-9;  // cosine
  constexpr double kLevel = 1e-4;        // mm: files round
  const auto* a = std::get_if<Frame>(&model.faces[f].surface);
  const auto* b = std::get_if<Frame>(&model.faces[other].surface);
  return a && b && a->z.dot(b->z) > kAlike && std::abs(b->local(a->origin).z()) <= spread + kLevel;
}

std::set<int> faces_beside(const SolidModel& model, int face) {
  std::set<int> beside;
  for (const auto& loop : model.faces[face].loops)
    for (const CoEdge& use : loop)
      beside.insert(face_across(model.edges[use.edge], face));
  return beside;
}

namespace {

/// Whether a groove may lie between both: one wall goes on below them.
bool have_common_wall(const SolidModel& model, int face, int other) {
  const std::set<int> a = faces_beside(model, face), b = faces_beside(model, other);
  return std::ranges::any_of(a, [&](int wall) { return wall >= 0 && b.contains(wall); });
}

}  // namespace

void add_divided(Skins& skins, const SolidModel& model, const std::vector<bool>& candidates) {
  const std::vector<Skin> grown = skins.skin_of;
  for (int f = 0; f < std::ssize(grown); ++f) {
    if (!candidates[f] || grown[f] != Skin::none) continue;
    for (int other = 0; other < std::ssize(grown) && skins.skin_of[f] == Skin::none; ++other)
      if (grown[other] != Skin::none && in_plane_of(model, f, other, 0.0) &&
          have_common_wall(model, f, other))
        skins.skin_of[f] = grown[other];
  }
}

std::vector<DividedFlange> divided_flanges(const SolidModel& model, const Skins& skins,
                                           const Groups& groups) {
  const auto opposite = [&](const Group& group) {
    std::set<int> faces;
    for (const int f : group.faces)
      faces.insert(skins.partners[f].begin(), skins.partners[f].end());
    return faces;
  };
  const auto are_pieces = [&](const Group& a, const Group& b) {
    const std::set<int> below = opposite(b);
    return in_plane_of(model, a.leader, b.leader, skins.spread) &&
           std::ranges::any_of(a.faces,
                               [&](int f) {
                                 return std::ranges::any_of(b.faces, [&](int other) {
                                   return have_common_wall(model, f, other);
                                 });
                               }) &&
           std::ranges::any_of(opposite(a), [&](int f) { return below.contains(f); });
  };
  std::vector<DividedFlange> divided;
  for (size_t i = 0; i < groups.rows.size(); ++i)
    for (size_t j = 0; j < i; ++j)
      if (are_pieces(groups.rows[i], groups.rows[j])) {
        divided.push_back({groups.rows[j].leader, groups.rows[i].leader});
        break;
      }
  return divided;
}

int divided_pieces(const SolidModel& model, const std::vector<Outline>& outlines,
                   const Skins& skins, Skin skin) {
  const Groups groups = group_faces(model, outlines, skins, skin);
  return static_cast<int>(divided_flanges(model, skins, groups).size());
}

Skins without_divided(const SolidModel& model, const std::vector<Outline>& outlines, Skins skins,
                      Skin reference) {
  const Groups groups = group_faces(model, outlines, skins, reference);
  UnionFind sets(static_cast<int>(groups.rows.size()));
  for (const GroupJoint& joint : groups.joints)
    sets.unite(joint.a, joint.b);
  std::map<int, double> area;
  for (int g = 0; g < std::ssize(groups.rows); ++g)
    for (const int f : groups.rows[g].faces)
      area[sets.root(g)] += outlines[f].area;
  const auto by_area = [](const auto& one) { return one.second; };
  if (area.size() < 2) return skins;
  const int largest = std::ranges::max_element(area, {}, by_area)->first;
  const auto is_kept = [&](int f) {
    return groups.of_face[f] >= 0 && sets.root(groups.of_face[f]) == largest;
  };
  const std::vector<Skin> before = skins.skin_of;
  for (int f = 0; f < std::ssize(before); ++f) {
    if (before[f] != reference || is_kept(f)) continue;
    for (int other = 0; other < std::ssize(before) && skins.skin_of[f] != Skin::none; ++other)
      if (is_kept(other) && in_plane_of(model, f, other, skins.spread))
        skins.skin_of[f] = Skin::none;
  }
  return skins;
}

}  // namespace planish::brep
