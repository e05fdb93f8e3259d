#include "closed_forms.hpp"

#include "dihedral.hpp"

#include <algorithm>
#include <map>
#include <set>

// Bridges and lances that stay attached at both ends are stretched, not bent, and would make a loop
// of joints. A group inside an inner loop of a flange is one if it makes a ring with the flange: a
// tree of n groups has n joints with it and among themselves, more of them make a ring; so do two
// between the same groups along different lines. What rises from the sheet joins groups too: the
// round ends of beads and louvres, and upright ones, which stand on one skin in an inward corner,
// where the wall of a cut leads from skin to skin and has none.

namespace planish::brep {
namespace {

/// What has more of a skin is no form: it stays, so that the loop that it makes is refused as such.
constexpr double kLargestShare = 0.25;

using Neighbours = std::vector<std::vector<int>>;  // by group, then by part of the rim

bool is_drawn(const SolidModel& model, int face) {
  return std::holds_alternative<DoublyCurved>(model.faces[face].surface);
}

/// Faces of the rim that stand on one skin, with an inward corner between.
std::vector<bool> upright_faces(const SolidModel& model, const Rim& rim) {
  std::vector<int> skin_of(model.faces.size());
  for (const RimPart& part : rim.parts)
    for (const auto& [loops, skin] : {std::pair(&part.first, 1), std::pair(&part.second, 2)})
      for (const LoopRef& ref : *loops)
        skin_of[ref.face] = skin;
  std::vector<int> touched(model.faces.size());  // skins, as a sum
  std::vector<bool> inward(model.faces.size());
  for (int e = 0; e < std::ssize(model.edges); ++e)
    for (const int side : {0, 1}) {
      const auto& faces = model.edges[e].faces;
      const int skin = faces[side], wall = faces[1 - side];
      if (skin < 0 || wall < 0 || skin_of[skin] == 0 || rim.part_of[wall] < 0) continue;
      touched[wall] |= skin_of[skin];
      if (dihedral(model, e).value_or(0.0) < -kSmoothAngle) inward[wall] = true;
    }
  for (std::size_t f = 0; f < inward.size(); ++f)
    inward[f] = inward[f] && touched[f] < 3;
  return inward;
}

Neighbours neighbours_of(const SolidModel& model, const Groups& groups, const Rim& rim) {
  const std::size_t count = groups.rows.size();
  const std::vector<bool> upright = upright_faces(model, rim);
  Neighbours neighbours(count + rim.parts.size());
  for (const GroupJoint& joint : groups.joints) {
    if (joint.a == joint.b) continue;
    neighbours[joint.a].push_back(joint.b);
    neighbours[joint.b].push_back(joint.a);
  }
  for (const SolidEdge& edge : model.edges)
    for (const int side : {0, 1}) {
      const int skin = edge.faces[side], drawn = edge.faces[1 - side];
      if (skin < 0 || drawn < 0 || groups.of_face[skin] < 0 || rim.part_of[drawn] < 0) continue;
      const bool domed = is_drawn(model, drawn) && !rim.parts[rim.part_of[drawn]].within;
      if (!domed && !upright[drawn]) continue;
      const int part = static_cast<int>(count) + rim.part_of[drawn];
      neighbours[groups.of_face[skin]].push_back(part);
      neighbours[part].push_back(groups.of_face[skin]);
    }
  return neighbours;
}

/// Groups that a loop of the flange joins it to.
std::set<int> joined_along(const std::vector<CoEdge>& loop,
                           const std::map<int, GroupJoint>& joint_at, int flange) {
  std::set<int> joined;
  for (const CoEdge& use : loop)
    if (const auto found = joint_at.find(use.edge); found != joint_at.end()) {
      const GroupJoint& joint = found->second;
      const int other = joint.a == flange ? joint.b : joint.a;
      if (other != flange) joined.insert(other);
    }
  return joined;
}

/// Groups reached from these without crossing the flange.
std::set<int> reached_from(const std::set<int>& seeds, const Neighbours& neighbours, int flange) {
  std::set<int> reached = seeds;
  std::vector<int> stack(seeds.begin(), seeds.end());
  while (!stack.empty()) {
    const int at = stack.back();
    stack.pop_back();
    for (const int next : neighbours[at])
      if (next != flange && reached.insert(next).second) stack.push_back(next);
  }
  return reached;
}

/// Whether one edge goes on in the line of another.
bool is_in_line(const SpaceCurve& a, const SpaceCurve& b) {
  constexpr double kAside = 1e-3;  // of the longer: joints of one bend agree much closer
  if (a.kind != SpaceCurve::Kind::line || b.kind != SpaceCurve::Kind::line) return true;
  const Vec3 along = (a.end - a.start).normalized();
  const double limit = kAside * std::max(a.length(), b.length());
  return (b.start - a.start).cross(along).norm() <= limit &&
         (b.end - a.start).cross(along).norm() <= limit;
}

/// Joints between two groups along other lines than their first.
int other_lines(const SolidModel& model, const Groups& groups, const std::set<int>& inside,
                int flange) {
  std::map<std::pair<int, int>, std::vector<int>> lines;  // an edge for each
  const auto counts = [&](int g) { return g == flange || inside.contains(g); };
  for (const GroupJoint& joint : groups.joints) {
    if (joint.a == joint.b || !counts(joint.a) || !counts(joint.b)) continue;
    std::vector<int>& known = lines[std::minmax(joint.a, joint.b)];
    if (std::ranges::none_of(known, [&](int e) {
          return is_in_line(model.edges[e].curve, model.edges[joint.edge].curve);
        }))
      known.push_back(joint.edge);
  }
  int others = 0;
  for (const auto& [pair, edges] : lines)
    others += static_cast<int>(edges.size()) - 1;
  return others;
}

/// A tree of n groups and the flange has n joints; more form a ring.
bool makes_ring(const SolidModel& model, const Groups& groups, const Neighbours& neighbours,
                const std::set<int>& inside, int flange) {
  std::set<std::pair<int, int>> links;
  for (const int g : inside)
    for (const int other : neighbours[g])
      if (other == flange || inside.count(other) > 0) links.insert(std::minmax(g, other));
  return links.size() > inside.size() || other_lines(model, groups, inside, flange) > 0;
}

/// Whether one face that is drawn out of the sheet borders both groups.
bool share_a_dome(const SolidModel& model, const Groups& groups, const Rim& rim, int a, int b) {
  std::map<int, std::set<int>> beside;  // groups, by drawn face
  for (const SolidEdge& edge : model.edges)
    for (const int side : {0, 1}) {
      const int skin = edge.faces[side], drawn = edge.faces[1 - side];
      if (skin >= 0 && drawn >= 0 && groups.of_face[skin] >= 0 && rim.part_of[drawn] >= 0 &&
          is_drawn(model, drawn) && !rim.parts[rim.part_of[drawn]].within)
        beside[drawn].insert(groups.of_face[skin]);
    }
  return std::ranges::any_of(
      beside, [&](const auto& one) { return one.second.contains(a) && one.second.contains(b); });
}

/// Curved groups that meet a flange in a sharp edge and end in what is drawn from both: forms, even
/// where their mouths lie on the outline of the flange.
std::set<int> pressed_at_edges(const SolidModel& model, const Groups& groups, const Rim& rim) {
  std::set<int> pressed;
  for (const GroupJoint& joint : groups.joints)
    for (const auto& [flange, form] : {std::pair(joint.a, joint.b), std::pair(joint.b, joint.a)})
      if (joint.sharp && groups.rows[flange].flange && !groups.rows[form].flange &&
          share_a_dome(model, groups, rim, flange, form))
        pressed.insert(form);
  return pressed;
}

}  // namespace

std::vector<int> closed_forms(const SolidModel& model, const std::vector<Outline>& outlines,
                              const Groups& groups, const Rim& rim) {
  const Neighbours neighbours = neighbours_of(model, groups, rim);
  std::map<int, GroupJoint> joint_at;  // by edge
  for (const GroupJoint& joint : groups.joints)
    joint_at[joint.edge] = joint;
  const auto area_of = [&](const Group& group) {
    return sum_of(group.faces, [&](int f) { return outlines[f].area; });
  };
  const double most = kLargestShare * sum_of(groups.rows, area_of);
  std::set<int> taken;
  const auto look_inside = [&](int flange, const std::vector<CoEdge>& loop) {
    const std::set<int> seeds = joined_along(loop, joint_at, flange);
    if (seeds.empty()) return;
    const std::set<int> inside = reached_from(seeds, neighbours, flange);
    const double area = sum_of(
        inside, [&](int g) { return g < std::ssize(groups.rows) ? area_of(groups.rows[g]) : 0.0; });
    if (area <= most && makes_ring(model, groups, neighbours, inside, flange))
      taken.insert(inside.begin(), inside.end());
  };
  for (const int form : pressed_at_edges(model, groups, rim))
    if (area_of(groups.rows[form]) <= most) taken.insert(form);
  for (int g = 0; g < std::ssize(groups.rows); ++g) {
    if (!groups.rows[g].flange) continue;
    for (const int f : groups.rows[g].faces) {
      const int outer = outlines[f].outer;
      for (int l = 0; l < std::ssize(model.faces[f].loops); ++l)
        if (l != outer) look_inside(g, model.faces[f].loops[l]);
    }
  }
  std::vector<int> faces;
  for (const int g : taken)
    if (g < std::ssize(groups.rows))
      faces.insert(faces.end(), groups.rows[g].faces.begin(), groups.rows[g].faces.end());
  return faces;
}

}  // namespace planish::brep
