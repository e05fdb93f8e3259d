// Cuts a sheet open along edges (math.md#rips): the joints there are dropped, and with them what
// the solid had between the walls, the prism along the corner and, where three walls meet, the
// block T³ / |det of normals|. The genus follows Euler's formula from the corners that a rip parts.
// The sheet must stay in one part.

#include "refusals.hpp"
#include "rip_joint.hpp"

#include <planish/base/union_find.hpp>
#include <planish/sheet/places.hpp>
#include <planish/sheet/rip.hpp>
#include <planish/sheet/topology.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

// Cuts a sheet open along edges (math.md#rips). Faces stay where they are; what the sheet loses is
// what lies beyond the walls' inside edges: a wedge along each edge, and at a corner of three walls
// a block of T³ / |det of the normals|. Openings are counted anew by Euler's formula, as a rip
// makes two edges of one and parts corners.

namespace planish {
namespace {

/// As refusals name a joint.
bool is_at(const Sheet& sheet, const Joint& joint, int edge) { return sheet[joint.a].edge == edge; }

/// What lies between two walls that meet by their inside edge, mm³.
double corner_volume(const Sheet& sheet, const Joint& joint) {
  const double t = sheet.thickness;
  const double arc = t * t * sheet[*joint.sharp].angle.radians() / 2;
  return sheet[joint.a].edge_length.value_or(0.0) * arc + joint.mitre_volume;
}

Result<void> check_edge(const Sheet& sheet, int edge) {
  const auto joint = std::ranges::find_if(sheet.joints,
                                          [&](const Joint& j) { return is_at(sheet, j, edge); });
  if (joint == sheet.joints.end())
    return fail(refuse::no_edge_to_rip, {{"edge", place::edge(edge)}});
  if (!sheet_detail::can_be_ripped(sheet, *joint))
    return fail(refuse::rip_in_corner, {{"edge", edge_at(sheet, *joint, edge)},
                                        {"face", face_at(sheet, joint->a)},
                                        {"face", face_at(sheet, joint->b)}});
  return {};
}

/// The points at which borders end, as joints make them one.
class Corners {
 public:
  explicit Corners(const Sheet& sheet)
      : topology_(sheet), same_(static_cast<int>(topology_.border_count())) {
    for (const BorderId id : topology_.borders())
      if (const auto across = topology_.twin(id))
        same_.unite(static_cast<int>(id), static_cast<int>(topology_.next(*across)));
  }
  int count() { return same_.count(); }
  /// Whether the sheet has no edge: it encloses a space.
  bool is_closed() const {
    return std::ranges::all_of(
        topology_.borders(), [this](const BorderId id) { return topology_.twin(id).has_value(); });
  }
  /// Where a border begins.
  int start(const BorderRef& ref) { return same_.root(static_cast<int>(topology_.id_of(ref))); }
  int end(const BorderRef& ref) {
    return same_.root(static_cast<int>(topology_.next(topology_.id_of(ref))));
  }

 private:
  Topology topology_;
  UnionFind same_;  ///< by the border that begins there
};

/// Where three walls meet that are folded sharply from each other, the corner holds a block beyond
/// those along its edges: T³ / |det of the normals|. That of the corners at the ends of the rips.
double blocks_volume(const Sheet& sheet, const std::vector<Joint>& rips) {
  Corners corners(sheet);
  std::map<int, std::vector<Vec3>> normals;
  std::map<int, int> folds;
  for (const FaceId id : sheet.faces.ids())
    for (int l = 0; l < std::ssize(sheet[id].loops); ++l)
      for (int b = 0; b < std::ssize(sheet[id].loops[l]); ++b)
        if (const auto* plane = std::get_if<Frame>(&sheet[id].surface))
          normals[corners.start({id, l, b})].push_back(plane->z);
  for (const Joint& joint : sheet.joints)
    if (joint.sharp && sheet[*joint.sharp].reference_inside)
      for (const int corner : {corners.start(joint.a), corners.end(joint.a)})
        ++folds[corner];
  std::set<int> ends;
  for (const Joint& rip : rips)
    if (rip.sharp) ends.insert({corners.start(rip.a), corners.end(rip.a)});
  double volume = 0.0;
  for (const int corner : ends) {
    constexpr double kFlat = 0.01;  // of the determinant: normals nearly in a plane
    const std::vector<Vec3>& n = normals[corner];
    if (n.size() != 3 || folds[corner] != 3) continue;
    const double determinant = std::abs(n[0].dot(n[1].cross(n[2])));
    if (determinant > kFlat) volume += std::pow(sheet.thickness, 3) / determinant;
  }
  return volume;
}

/// Sharp bends at which nothing is joined any more.
std::set<BendId> idle_bends(const Sheet& sheet) {
  std::set<BendId> idle;
  for (const BendId id : sheet.bends.ids())
    if (sheet[id].faces.empty()) idle.insert(id);
  for (const Joint& joint : sheet.joints)
    if (joint.sharp) idle.erase(*joint.sharp);
  return idle;
}

Sheet without_bends(Sheet sheet, const std::set<BendId>& gone) {
  if (gone.empty()) return sheet;
  std::vector<BendId> renamed;
  IdVector<BendId, Bend> bends;
  for (const BendId id : sheet.bends.ids())
    renamed.push_back(gone.contains(id) ? BendId{} : bends.push_back(std::move(sheet.bends[id])));
  sheet.bends = std::move(bends);
  for (Face& face : sheet.faces)
    if (auto* bend = std::get_if<BendId>(&face.part_of)) *bend = renamed.at(index_of(*bend));
  for (Joint& joint : sheet.joints)
    if (joint.sharp) joint.sharp = renamed.at(index_of(*joint.sharp));
  return sheet;
}

tl::unexpected<Error> parted(const Sheet& sheet, const std::vector<Joint>& rips) {
  Facts facts = mapped(rips, [&](const Joint& rip) {
    return Fact("edge", edge_at(sheet, rip, *sheet[rip.a].edge));
  });
  return fail(rips.size() == 1 ? refuse::rip_parts : refuse::rips_part, facts);
}

}  // namespace

namespace sheet_detail {

bool can_be_ripped(const Sheet& sheet, const Joint& joint) {
  return sheet[joint.a].edge && (!joint.sharp || sheet[*joint.sharp].reference_inside);
}

}  // namespace sheet_detail

Result<Sheet> ripped(Sheet sheet, std::span<const int> edges) {
  if (edges.empty()) return sheet;
  for (const int edge : edges)
    if (auto fit = check_edge(sheet, edge); !fit) return pass_on(fit);
  const auto is_ripped = [&](const Joint& joint) {
    return std::ranges::any_of(edges, [&](int edge) { return is_at(sheet, joint, edge); });
  };
  Corners whole(sheet);
  std::vector<Joint> kept, rips;
  for (const Joint& joint : sheet.joints)
    (is_ripped(joint) ? rips : kept).push_back(joint);
  if (sheet.volume) *sheet.volume -= blocks_volume(sheet, rips);
  for (const Joint& rip : rips)
    if (rip.sharp) {
      if (sheet.volume) *sheet.volume -= corner_volume(sheet, rip);
      sheet.mitres_volume -= rip.mitre_volume;
    }
  sheet.joints = std::move(kept);
  // Euler's formula: openings are 1 − corners + edges − faces. A rip makes two edges of one, and of
  // a corner as many as it parts. The two shells of a closed sheet become one, with a contour.
  if (sheet.genus)
    *sheet.genus += static_cast<int>(rips.size()) - (Corners(sheet).count() - whole.count()) -
                    (whole.is_closed() ? 1 : 0);
  const std::set<BendId> idle = idle_bends(sheet);
  sheet = without_bends(std::move(sheet), idle);
  if (!Topology(sheet).is_connected()) return parted(sheet, rips);
  return sheet;
}

}  // namespace planish
