#pragma once

#include <planish/geometry/curve.hpp>

#include <vector>

namespace planish::slit_detail {

/// A place on an edge of a strip in the flat sheet, and its derivatives by the abscissa.
struct EdgePlace {
  Vec2 at = Vec2::Zero();
  Vec2 first = Vec2::UnitX();
  Vec2 second = Vec2::Zero();
};

/// A long edge of a strip in the flat sheet, by an abscissa that runs with the strip: a line along
/// the sheet, where the abscissa is the coordinate along, or a chain of lines.
///
/// A chain is cut as it is; for the solver its corners are rounded over half of the shorter line
/// beside them, so that places have continuous first derivatives. A ridge ends where its line meets
/// the chain itself (`on_chain`).
class EdgeCurve {
 public:
  EdgeCurve(double across = 0.0) : across_(across) {}  // NOLINT: a line along the sheet
  /// A chain of at least two points, none of them twice in turn, whose first has the abscissa
  /// `from` and whose last `to`; in between it grows evenly with the length.
  EdgeCurve(std::vector<Vec2> chain, double from, double to);

  EdgePlace place(double abscissa) const;
  bool is_line() const { return chain_.empty(); }
  double across() const { return across_; }  ///< of a line; of a chain where it begins

  /// Where the line from `from` through `near` goes through the chain next to `near`.
  struct Crossing {
    Vec2 at = Vec2::Zero();
    int line = 0;  ///< of the chain, from its corner of this number to the next
  };
  Crossing on_chain(const Vec2& from, const Vec2& near, double abscissa) const;
  const std::vector<Vec2>& chain() const { return chain_; }

 private:
  int line_at(double length) const;
  Vec2 along(int line) const;
  double length_of(int line) const { return reached_[line + 1] - reached_[line]; }

  double across_ = 0.0;
  std::vector<Vec2> chain_;      ///< empty: a line along the sheet
  std::vector<double> reached_;  ///< length at each corner
  double from_ = 0.0, speed_ = 1.0;
};

}  // namespace planish::slit_detail
