#pragma once

#include <planish/sheet/sheet.hpp>

#include <optional>
#include <vector>

namespace planish {

/// The position of a border among all borders of a sheet: face by face, loop by loop.
enum class BorderId : int {};
constexpr int index_of(BorderId id) { return static_cast<int>(id); }

/// How the faces of a sheet are connected: the border across each joint, the next border along a
/// contour, the flanges and bends that touch. Requires the positions in the sheet's joints to exist
/// (`check`). A snapshot: it may outlive the sheet and does not follow later changes. O(borders).
class Topology {
 public:
  explicit Topology(const Sheet& sheet);

  // Borders.

  const BorderRef& operator[](BorderId id) const { return rows_[id].ref; }
  BorderId id_of(const BorderRef& ref) const;
  auto borders() const { return rows_.ids(); }
  std::size_t border_count() const { return rows_.size(); }

  /// The border that follows in the loop.
  BorderId next(BorderId id) const { return rows_[id].next; }
  /// The border across the joint; empty for a free border.
  std::optional<BorderId> twin(BorderId id) const { return rows_[id].twin; }
  bool is_free(BorderId id) const { return !rows_[id].twin; }
  bool is_free(const BorderRef& ref) const { return is_free(id_of(ref)); }
  /// The joint that the border is in, as in `Sheet::joints`.
  std::optional<int> joint(BorderId id) const { return rows_[id].joint; }

  /// The free border that follows a free border along the contour of the whole sheet, and of each
  /// sharp bend that is crossed on the way the border that begins beyond it.
  struct Step {
    BorderId border;
    std::vector<BorderId> beyond_sharp = {};
  };
  Step along_contour(BorderId id) const;

  // Flanges and bends, as nodes.

  /// Flanges come first, then bends.
  int node_of(PartId part) const;
  int node_of(FaceId face) const { return node_of_face_[face]; }
  int node_count() const { return static_cast<int>(joints_of_.size()); }
  /// Joints between a node and others; a sharp joint connects the flanges or bends on its two
  /// sides.
  const std::vector<int>& joints_of(int node) const;
  /// Whether joints lead from every face to every other.
  bool is_connected() const { return connected_; }

 private:
  struct Row {
    BorderRef ref;
    BorderId next{};
    std::optional<BorderId> twin = {};
    std::optional<int> joint = {};
    bool sharp = false;
  };
  void add_borders(const Sheet& sheet);
  void add_joints(const Sheet& sheet);

  IdVector<BorderId, Row> rows_;
  IdVector<FaceId, std::vector<int>> first_row_;  // by face and loop
  IdVector<FaceId, int> node_of_face_;
  std::vector<std::vector<int>> joints_of_;  // by node
  int flange_count_ = 0;
  bool connected_ = false;
};

}  // namespace planish
