#pragma once

#include <planish/geometry/frame.hpp>
#include <planish/sheet/sheet.hpp>

#include <functional>
#include <vector>

namespace planish::brep {

/// A curve of a plane, over t from 0 to 1.
using PlaneCurve = std::function<Vec2(double)>;

/// A part of one of some curves, run from one parameter to the other.
struct CellPiece {
  int curve = 0;
  double from = 0.0, to = 1.0;

  bool whole() const { return from + to == 1.0 && from * to == 0.0; }
};

/// The border of the cell that curves leave open round a point of it, counter-clockwise: what is
/// nearest in every direction. Pieces end in ends of curves or where two cross, to rounding; ends
/// within `tolerance` are one, and curves less than a thousandth of that apart run along each
/// other. Empty where the cell is not seen whole from the point. Takes time in proportion to the
/// number of curves.
std::vector<CellPiece> innermost_cell(const std::vector<PlaneCurve>& curves, const Vec2& within,
                                      double tolerance);

/// The same run the other way.
std::vector<CellPiece> reversed(std::vector<CellPiece> cell);

/// The same part of a border; of less than all of an edge the length is not known.
Border part_of(Border border, const CellPiece& piece);

}  // namespace planish::brep
