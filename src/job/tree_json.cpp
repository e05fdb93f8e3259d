#include "tree_json.hpp"

#include <planish/sheet/facets.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <optional>
#include <set>

// The tree over which a sheet is laid flat, as articles on unfolding draw it: flanges and bends are
// nodes, and each is reached once, from the root outwards. Faces are followed, over the joints that
// the layout kept; the faces of one part are one node. A sharp bend has no faces: it is the node
// between the two parts that meet there.

namespace planish::job {
using namespace schema;
namespace {

std::string name_of(const FlatPattern& flat, const PartId& part) {
  if (const auto* flange = std::get_if<FlangeId>(&part))
    return fmt::format("F{}", index_of(*flange) + 1);
  const BendId bend = std::get<BendId>(part);
  const auto found = std::ranges::find(flat.bends, bend, &FlatBend::bend);
  return found != flat.bends.end() ? found->id : fmt::format("B{}", index_of(bend) + 1);
}

/// Row by row.
Json matrix_json(const Eigen::Isometry3d& motion, const Units& units) {
  Json rows = Json::array();
  for (int r = 0; r < 4; ++r) {
    Json row = Json::array();
    for (int c = 0; c < 4; ++c) {
      const double value = motion.matrix()(r, c);
      row.push_back(number_json(c == 3 && r < 3 ? units.length(value) : value));
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

class Tree {
 public:
  Tree(const Report& report, const Units& units)
      : sheet_(report.sheet), layout_(report.layout), flat_(report.flat), units_(units) {}

  Json rows() {
    std::vector<std::vector<int>> joints(sheet_.faces.size());  // by face
    for (const int j : layout_.tree)
      for (const FaceId face : {sheet_.joints[j].a.face, sheet_.joints[j].b.face})
        joints[index_of(face)].push_back(j);
    std::deque<FaceId> reached{layout_.root};
    std::set<FaceId> seen{layout_.root};
    add(sheet_[layout_.root].part_of, {});
    while (!reached.empty()) {
      const FaceId from = reached.front();
      reached.pop_front();
      for (const int j : joints[index_of(from)]) {
        const Joint& joint = sheet_.joints[j];
        const FaceId to = joint.a.face == from ? joint.b.face : joint.a.face;
        if (!seen.insert(to).second) continue;
        PartId parent = sheet_[from].part_of;
        if (joint.sharp) {
          add(*joint.sharp, parent);
          parent = *joint.sharp;
        }
        add(sheet_[to].part_of, parent);
        reached.push_back(to);
      }
    }
    return std::move(rows_);
  }

 private:
  void add(const PartId& part, const std::optional<PartId>& parent) {
    if (!added_.insert(part).second) return;
    Json row;
    row["part"] = name_of(flat_, part);
    row["parent"] = parent ? Json(name_of(flat_, *parent)) : Json(nullptr);
    if (const auto* flange = std::get_if<FlangeId>(&part)) {
      const FaceId face = sheet_[*flange].faces.front();
      if (sheet_[face].source_face) row["face"] = *sheet_[face].source_face;
      row["transform"] = matrix_json(flange_in_space(sheet_, layout_, face), units_);
    }
    rows_.push_back(std::move(row));
  }

  const Sheet& sheet_;
  const Layout& layout_;
  const FlatPattern& flat_;
  const Units& units_;
  std::set<PartId> added_;
  Json rows_ = Json::array();
};

}  // namespace

Json tree_json(const Report& report, const Units& units) {
  const bool laid = !report.sheet.faces.empty() &&
                    report.layout.placement.size() == report.sheet.faces.size();
  return laid ? Tree(report, units).rows() : Json::array();
}

Schema tree_schema() {
  const Schema row = list(number().or_null());
  return list(
      object({required("part", text()), required("parent", text().or_null()),
              optional("face", whole(1).said("of the solid, of a flange")),
              optional("transform", list(row).said("4 × 4, from the pattern to the flange"))}));
}

}  // namespace planish::job
