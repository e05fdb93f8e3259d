// Who is whose neighbour in a sheet: borders numbered in a row with their successors and twins. The
// free border that follows another is found by turning about the corner they share, over each joint
// to the next face, as in a half-edge structure.

#include <planish/base/assert.hpp>
#include <planish/base/union_find.hpp>
#include <planish/sheet/topology.hpp>

// How faces are connected, as rows by border: twin, next, joint, contour. The border that follows
// along a contour of the whole sheet is found by turning about a corner, from border to twin, until
// one is free; a corner has at most as many faces as there are borders, which ends the walk in a
// broken sheet too.

namespace planish {

const std::vector<int>& Topology::joints_of(int node) const {
  PLANISH_ASSERT(node >= 0 && node < node_count());
  return joints_of_[node];
}

Topology::Topology(const Sheet& sheet)
    : joints_of_(sheet.flanges.size() + sheet.bends.size()),
      flange_count_(static_cast<int>(sheet.flanges.size())) {
  add_borders(sheet);
  add_joints(sheet);
}

void Topology::add_borders(const Sheet& sheet) {
  for (const FaceId id : sheet.faces.ids()) {
    const Face& face = sheet[id];
    std::vector<int>& first = first_row_.emplace_back();
    for (int l = 0; l < std::ssize(face.loops); ++l) {
      first.push_back(static_cast<int>(rows_.size()));
      const int count = static_cast<int>(face.loops[l].size());
      for (int b = 0; b < count; ++b)
        rows_.push_back({{id, l, b}, BorderId{first.back() + (b + 1) % count}});
    }
    node_of_face_.push_back(node_of(face.part_of));
  }
}

void Topology::add_joints(const Sheet& sheet) {
  UnionFind parts(static_cast<int>(sheet.faces.size()));
  for (int j = 0; j < std::ssize(sheet.joints); ++j) {
    const Joint& joint = sheet.joints[j];
    const BorderId a = id_of(joint.a), b = id_of(joint.b);
    rows_[a].twin = b;
    rows_[b].twin = a;
    rows_[a].joint = rows_[b].joint = j;
    rows_[a].sharp = rows_[b].sharp = joint.sharp.has_value();
    parts.unite(index_of(joint.a.face), index_of(joint.b.face));
    const int from = node_of(joint.a.face), to = node_of(joint.b.face);
    if (from == to) continue;
    joints_of_[from].push_back(j);
    joints_of_[to].push_back(j);
  }
  // The faces of a flange or bend lie on one surface, joined or not.
  for (const FaceId id : sheet.faces.ids())
    parts.unite(index_of(id), index_of(sheet.faces_of(sheet[id].part_of).front()));
  connected_ = parts.count() == 1;
}

BorderId Topology::id_of(const BorderRef& ref) const {
  const std::vector<int>& first = first_row_[ref.face];
  PLANISH_ASSERT(ref.loop >= 0 && ref.loop < std::ssize(first) && ref.border >= 0);
  const BorderId id{first[ref.loop] + ref.border};
  PLANISH_ASSERT(rows_[id].ref == ref);
  return id;
}

Topology::Step Topology::along_contour(BorderId id) const {
  Step step{next(id)};
  // Around a corner there are at most as many faces as borders.
  for (std::size_t guard = 0; !is_free(step.border) && guard < rows_.size(); ++guard) {
    const bool sharp = rows_[step.border].sharp;
    step.border = next(*twin(step.border));
    if (sharp) step.beyond_sharp.push_back(step.border);
  }
  return step;
}

int Topology::node_of(PartId part) const {
  const auto* flange = std::get_if<FlangeId>(&part);
  const int row = flange ? index_of(*flange) : index_of(std::get<BendId>(part));
  PLANISH_ASSERT(row >= 0 && row < (flange ? flange_count_ : node_count() - flange_count_));
  return flange ? row : flange_count_ + row;
}

}  // namespace planish
