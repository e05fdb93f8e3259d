#include "grouping.hpp"

#include "dihedral.hpp"
#include "same_surface.hpp"

#include <planish/base/union_find.hpp>

#include <map>
#include <set>

// Faces of a skin that make one flange or one bend. Faces that continue each other on one surface
// are united; then bends that join the same two flanges and lie on one surface are, since a notch
// or a hole may cut a bend through. Groups come in the order of their first faces, so the result
// does not hang on the order of the edges.

namespace planish::brep {
namespace {

bool is_flat(const SolidFace& face) { return std::holds_alternative<Frame>(face.surface); }

/// Joints of one skin, with face numbers in place of groups.
std::vector<GroupJoint> face_joints(const SolidModel& model, const Skins& skins, Skin skin) {
  std::set<int> sharp;
  for (const SharpEdge& edge : skins.sharp)
    sharp.insert(edge.edge);
  const auto mine = [&](int f) { return f >= 0 && skins.skin_of[f] == skin; };
  std::vector<GroupJoint> joints;
  for (int e = 0; e < std::ssize(model.edges); ++e) {
    const SolidEdge& edge = model.edges[e];
    if (edge.uses != 2 || !mine(edge.faces[0]) || !mine(edge.faces[1])) continue;
    const bool bent = sharp.count(e) > 0;
    const bool seam = edge.faces[0] == edge.faces[1];
    if (bent || seam || smooth_edge(model, e))
      joints.push_back({e, edge.faces[0], edge.faces[1], bent});
  }
  return joints;
}

/// Faces that continue each other on one surface.
UnionFind continued_faces(const SolidModel& model, const std::vector<GroupJoint>& joints) {
  UnionFind sets(static_cast<int>(model.faces.size()));
  for (const GroupJoint& joint : joints)
    if (!joint.sharp && same_surface(model.faces[joint.a], model.faces[joint.b], model.size))
      sets.unite(joint.a, joint.b);
  return sets;
}

/// Bends by the set of flanges that they join; a bend cut through by a notch or hole counts several
/// times.
std::map<std::set<int>, std::vector<int>> bends_by_flanges(const SolidModel& model,
                                                           const std::vector<GroupJoint>& joints,
                                                           UnionFind& sets) {
  std::map<int, std::set<int>> flanges_of;
  for (const GroupJoint& joint : joints) {
    if (joint.sharp) continue;
    const bool a_flat = is_flat(model.faces[joint.a]);
    const bool b_flat = is_flat(model.faces[joint.b]);
    if (a_flat && !b_flat) flanges_of[sets.root(joint.b)].insert(sets.root(joint.a));
    if (b_flat && !a_flat) flanges_of[sets.root(joint.a)].insert(sets.root(joint.b));
  }
  std::map<std::set<int>, std::vector<int>> bends;
  for (const auto& [bend, flanges] : flanges_of)
    if (flanges.size() == 2) bends[flanges].push_back(bend);
  return bends;
}

UnionFind with_interrupted_bends(const SolidModel& model, const std::vector<GroupJoint>& joints,
                                 UnionFind sets) {
  for (const auto& [flanges, bends] : bends_by_flanges(model, joints, sets))
    for (size_t i = 0; i < bends.size(); ++i)
      for (size_t j = i + 1; j < bends.size(); ++j)
        if (same_surface(model.faces[bends[i]], model.faces[bends[j]], model.size))
          sets.unite(bends[i], bends[j]);
  return sets;
}

}  // namespace

Groups group_faces(const SolidModel& model, const std::vector<Outline>& outlines,
                   const Skins& skins, Skin skin) {
  Groups groups;
  groups.joints = face_joints(model, skins, skin);
  UnionFind sets = with_interrupted_bends(model, groups.joints,
                                          continued_faces(model, groups.joints));
  groups.of_face.assign(model.faces.size(), -1);
  std::map<int, int> row_of_root;
  for (int f = 0; f < std::ssize(model.faces); ++f) {
    if (skins.skin_of[f] != skin) continue;
    const auto [at, fresh] = row_of_root.emplace(sets.root(f),
                                                 static_cast<int>(groups.rows.size()));
    if (fresh) groups.rows.push_back({{}, is_flat(model.faces[f]), f});
    Group& row = groups.rows[at->second];
    row.faces.push_back(f);
    if (outlines[f].area > outlines[row.leader].area) row.leader = f;
    groups.of_face[f] = at->second;
  }
  for (GroupJoint& joint : groups.joints) {
    joint.a = groups.of_face[joint.a];
    joint.b = groups.of_face[joint.b];
  }
  return groups;
}

}  // namespace planish::brep
