#pragma once

#include <planish/base/result.hpp>
#include <planish/sheet/sheet.hpp>

#include <optional>
#include <vector>

namespace planish::brep {

/// The borders of a sheet in one row, and which of them share an edge or a corner.
struct SheetTopology {
  struct BorderNode {
    BorderRef ref;
    int next = 0;       ///< the border that follows in its loop
    int mate = -1;      ///< the border across the joint, −1 at free borders
    bool leads = true;  ///< of two mates, the one that gives the edge its curve
    int corner = 0;     ///< where the border starts
  };
  std::vector<BorderNode> borders;
  int corners = 0;
  std::vector<bool> sharp;  ///< by corner: an end of a sharp joint

  int end_corner(int border) const { return borders[borders[border].next].corner; }
};

/// Errors: `invalid_input` when a joint names a border that does not exist or is joined already.
Result<SheetTopology> sheet_topology(const Sheet& sheet);

/// Position of a corner: on the reference skin (of sheets that refer to a surface between, on the
/// skin that it stands for), and on the other one, as far from every plane that meets there (a
/// sharp joint mitres).
struct CornerPoints {
  Vec3 reference = Vec3::Zero();
  Vec3 other = Vec3::Zero();
};

/// Errors: `unsupported_shape` where a sharp joint turns so far that its mitre runs away.
Result<std::vector<CornerPoints>> corner_points(const Sheet& sheet, const SheetTopology& topology);

inline const Face& face_of(const Sheet& sheet, const BorderRef& ref) { return sheet[ref.face]; }
inline const Border& border_of(const Sheet& sheet, const BorderRef& ref) { return sheet[ref]; }

}  // namespace planish::brep
