#include "grouping.hpp"

#include "rim.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

namespace planish::brep {
namespace {

/// Two faces continue one surface when they agree within the accuracy of files and fits.
struct Agreement {
  double length;  ///< mm
  double angle = 1e-3;
};

bool same_axis(const Frame& a, const Frame& b, const Agreement& agreement) {
  if (1.0 - std::abs(a.z.dot(b.z)) > agreement.angle * agreement.angle) return false;
  const Vec3 d = b.origin - a.origin;
  return (d - d.dot(a.z) * a.z).norm() <= agreement.length;
}

bool same_surface(const SolidFace& f, const SolidFace& g, double size) {
  constexpr double kFileDigits = 1e-7;  // of the size: positions in STEP files
  const Agreement agreement{kFileDigits * size + 1e-4 + 10 * (f.fitted + g.fitted)};
  const auto* a = std::get_if<Developable>(&f.surface);
  const auto* b = std::get_if<Developable>(&g.surface);
  if (!a && !b) return true;  // smooth neighbours that are planes are one plane
  if (!a || !b || a->index() != b->index() || f.sense != g.sense) return false;
  if (const auto* cylinder = std::get_if<Cylinder>(a)) {
    const auto& other = std::get<Cylinder>(*b);
    return same_axis(cylinder->frame, other.frame, agreement) &&
           std::abs(cylinder->radius - other.radius) <= agreement.length;
  }
  if (const auto* cone = std::get_if<Cone>(a)) {
    const auto& other = std::get<Cone>(*b);
    return (cone->frame.origin - other.frame.origin).norm() <=
               agreement.length / std::sin(cone->half_angle) &&
           std::abs(cone->half_angle - other.half_angle) <= agreement.angle &&
           cone->frame.z.dot(other.frame.z) > 1.0 - agreement.angle * agreement.angle;
  }
  return false;
}

class UnionFind {
 public:
  explicit UnionFind(size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  int root(int i) {
    while (parent_[i] != i)
      i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(int a, int b) { parent_[root(a)] = root(b); }

 private:
  std::vector<int> parent_;
};

class Grouper {
 public:
  Grouper(const SolidModel& model, const std::vector<Outline>& outlines, const Skins& skins,
          Side side)
      : model_(model), outlines_(outlines), skins_(skins), side_(side), sets_(model.faces.size()) {}

  Groups run() {
    find_joints();
    for (const GroupJoint& joint : groups_.joints)
      if (!joint.sharp && same_surface(face(joint.a), face(joint.b), model_.size))
        sets_.join(joint.a, joint.b);
    join_interrupted_bends();
    collect();
    for (GroupJoint& joint : groups_.joints) {
      joint.a = groups_.of_face[joint.a];
      joint.b = groups_.of_face[joint.b];
    }
    return std::move(groups_);
  }

 private:
  const SolidFace& face(int f) const { return model_.faces[f]; }
  bool mine(int f) const { return f >= 0 && skins_.side[f] == side_; }

  void find_joints() {
    std::set<int> sharp;
    for (const SharpEdge& edge : skins_.sharp)
      sharp.insert(edge.edge);
    for (size_t e = 0; e < model_.edges.size(); ++e) {
      const SolidEdge& edge = model_.edges[e];
      if (edge.uses != 2 || !mine(edge.faces[0]) || !mine(edge.faces[1])) continue;
      const bool bent = sharp.count(static_cast<int>(e)) > 0;
      const bool seam = edge.faces[0] == edge.faces[1];
      if (!bent && !seam && !smooth_edge(model_, static_cast<int>(e))) continue;
      groups_.joints.push_back({static_cast<int>(e), edge.faces[0], edge.faces[1], bent});
    }
  }

  /// A bend cut through by notches or holes is several faces between the same two flanges.
  void join_interrupted_bends() {
    std::map<int, std::set<int>> flanges_of;
    for (const GroupJoint& joint : groups_.joints) {
      if (joint.sharp) continue;
      const bool a_flat = std::holds_alternative<Frame>(face(joint.a).surface);
      const bool b_flat = std::holds_alternative<Frame>(face(joint.b).surface);
      if (a_flat && !b_flat) flanges_of[sets_.root(joint.b)].insert(sets_.root(joint.a));
      if (b_flat && !a_flat) flanges_of[sets_.root(joint.a)].insert(sets_.root(joint.b));
    }
    std::map<std::set<int>, std::vector<int>> by_flanges;
    for (const auto& [bend, flanges] : flanges_of)
      if (flanges.size() == 2) by_flanges[flanges].push_back(bend);
    for (const auto& [flanges, bends] : by_flanges)
      for (size_t i = 0; i < bends.size(); ++i)
        for (size_t j = i + 1; j < bends.size(); ++j)
          if (same_surface(face(bends[i]), face(bends[j]), model_.size))
            sets_.join(bends[i], bends[j]);
  }

  void collect() {
    groups_.of_face.assign(model_.faces.size(), -1);
    std::map<int, int> row_of_root;
    for (size_t f = 0; f < model_.faces.size(); ++f) {
      const int index = static_cast<int>(f);
      if (!mine(index)) continue;
      const auto [at, fresh] = row_of_root.emplace(sets_.root(index),
                                                   static_cast<int>(groups_.rows.size()));
      if (fresh)
        groups_.rows.push_back({{}, std::holds_alternative<Frame>(face(index).surface), index});
      Group& row = groups_.rows[at->second];
      row.faces.push_back(index);
      if (outlines_[f].area > outlines_[row.leader].area) row.leader = index;
      groups_.of_face[f] = at->second;
    }
  }

  const SolidModel& model_;
  const std::vector<Outline>& outlines_;
  const Skins& skins_;
  Side side_;
  UnionFind sets_;
  Groups groups_;
};

/// Groups reached from the joints along an inner loop of a flange without crossing that flange.
std::set<int> reached_inside(const std::vector<std::vector<int>>& neighbours, int flange,
                             const std::set<int>& seeds) {
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

/// A tree of n groups and the flange has n joints; more make a ring.
bool makes_ring(const Groups& groups, const std::set<int>& inside, int flange) {
  std::set<std::pair<int, int>> links;
  const auto in = [&](int g) { return g == flange || inside.count(g) > 0; };
  for (const GroupJoint& joint : groups.joints)
    if (joint.a != joint.b && in(joint.a) && in(joint.b))
      links.insert(std::minmax(joint.a, joint.b));
  return links.size() > inside.size();
}

}  // namespace

Groups group_faces(const SolidModel& model, const std::vector<Outline>& outlines,
                   const Skins& skins, Side side) {
  return Grouper(model, outlines, skins, side).run();
}

std::vector<int> closed_forms(const SolidModel& model, const std::vector<Outline>& outlines,
                              const Groups& groups) {
  std::vector<std::vector<int>> neighbours(groups.rows.size());
  std::map<int, int> group_across;  // by edge: index into joints
  for (size_t i = 0; i < groups.joints.size(); ++i) {
    const GroupJoint& joint = groups.joints[i];
    group_across[joint.edge] = static_cast<int>(i);
    if (joint.a == joint.b) continue;
    neighbours[joint.a].push_back(joint.b);
    neighbours[joint.b].push_back(joint.a);
  }
  std::set<int> taken;
  for (size_t g = 0; g < groups.rows.size(); ++g) {
    if (!groups.rows[g].flange) continue;
    for (const int f : groups.rows[g].faces) {
      const int outer = outer_loop(outlines[f]);
      const auto& loops = model.faces[f].loops;
      for (size_t l = 0; l < loops.size(); ++l) {
        if (static_cast<int>(l) == outer) continue;
        std::set<int> seeds;
        for (const CoEdge& use : loops[l])
          if (const auto found = group_across.find(use.edge); found != group_across.end()) {
            const GroupJoint& joint = groups.joints[found->second];
            const int other = joint.a == static_cast<int>(g) ? joint.b : joint.a;
            if (other != static_cast<int>(g)) seeds.insert(other);
          }
        if (seeds.empty()) continue;
        const std::set<int> inside = reached_inside(neighbours, static_cast<int>(g), seeds);
        if (makes_ring(groups, inside, static_cast<int>(g)))
          taken.insert(inside.begin(), inside.end());
      }
    }
  }
  std::vector<int> faces;
  for (const int g : taken)
    for (const int f : groups.rows[g].faces)
      faces.push_back(f);
  return faces;
}

}  // namespace planish::brep
