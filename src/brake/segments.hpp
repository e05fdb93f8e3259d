#pragma once

#include "workpiece.hpp"

namespace planish::brake_detail {

/// Segments of a tool standing side by side.
struct ToolRow {
  double from = 0.0;  ///< along the bend line, mm
  std::vector<double> segments;
  double length() const;
};

struct RowRequest {
  std::vector<Interval> pieces;   ///< of the bend line, from the lowest x on
  double shortfall = 0.0;         ///< may be missing at each end of a piece, mm
  std::vector<Interval> blocked;  ///< where a tool may not stand, apart and from the lowest x on
  double longest = 0.0;           ///< row that the machine takes, mm
};

/// Rows of segments that together press every piece: one row where nothing is in its way, else one
/// for each stretch between what blocks. Each row is as short as it can be, in the middle of what
/// it presses as far as there is room. Empty: no choice of segments does it.
std::vector<ToolRow> tool_rows(const std::vector<double>& segments, const RowRequest& request);

}  // namespace planish::brake_detail
