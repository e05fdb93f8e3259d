// Nearest curve of many to a point: a grid of squares that lists the curves whose boxes meet each.
// The search walks outwards in rings of squares and stops once the best distance is less than the
// next ring's.

#include "curve_index.hpp"

#include <algorithm>
#include <cmath>

namespace planish::sheet_detail {
namespace {

double distance_to(const Box2& box, const Vec2& p) {
  const Vec2 outside = (box.lo - p).cwiseMax(p - box.hi).cwiseMax(Vec2::Zero());
  return outside.norm();
}

}  // namespace

CurveIndex::CurveIndex(std::vector<Curve2> curves) : curves_(std::move(curves)) {
  if (curves_.empty()) return;
  for (const Curve2& curve : curves_) {
    boxes_.push_back(bounds(curve));
    box_.add(boxes_.back());
  }
  constexpr double kMostSquares = 512.0;  // along a side
  const double count = std::min(std::ceil(std::sqrt(curves_.size())), kMostSquares);
  side_ = box_.size().maxCoeff() / count;
  if (!(side_ > 0.0)) side_ = 1.0;  // all curves are one point
  columns_ = column_of(box_.hi.x()) + 1;
  rows_ = row_of(box_.hi.y()) + 1;
  cells_.resize(columns_ * rows_);
  for (int i = 0; i < std::ssize(curves_); ++i)
    for (int row = row_of(boxes_[i].lo.y()); row <= row_of(boxes_[i].hi.y()); ++row)
      for (int column = column_of(boxes_[i].lo.x()); column <= column_of(boxes_[i].hi.x());
           ++column)
        cell(column, row).push_back(i);
}

int CurveIndex::column_of(double x) const {
  return static_cast<int>(std::floor((x - box_.lo.x()) / side_));
}

int CurveIndex::row_of(double y) const {
  return static_cast<int>(std::floor((y - box_.lo.y()) / side_));
}

/// The squares `ring` steps from the one that holds p, as far as they are in the grid.
void CurveIndex::look_in_ring(const Vec2& p, int ring, std::optional<Hit>& best) const {
  const int middle_column = column_of(p.x()), middle_row = row_of(p.y());
  for (int row = std::max(0, middle_row - ring); row <= std::min(rows_ - 1, middle_row + ring);
       ++row) {
    const bool whole = std::abs(row - middle_row) == ring;
    const int step = whole || ring == 0 ? 1 : 2 * ring;
    for (int column = middle_column - ring; column <= middle_column + ring; column += step) {
      if (column < 0 || column >= columns_) continue;
      for (const int i : cells_[row * columns_ + column]) {
        if (best && distance_to(boxes_[i], p) >= best->distance) continue;
        const Nearest found = planish::nearest(curves_[i], p);
        if (!best || found.distance < best->distance)
          best = Hit{i, point_at(curves_[i], found.t), found.distance};
      }
    }
  }
}

std::optional<CurveIndex::Hit> CurveIndex::nearest(const Vec2& p) const {
  if (curves_.empty()) return {};
  const int column = column_of(p.x()), row = row_of(p.y());
  // Rings that meet the grid; p may lie outside of it.
  const int first = std::max({0, -column, column - columns_ + 1, -row, row - rows_ + 1});
  const int last = std::max({column, columns_ - 1 - column, row, rows_ - 1 - row});
  std::optional<Hit> best;
  for (int ring = first; ring <= last; ++ring) {
    look_in_ring(p, ring, best);
    // Anything in the next ring is at least `ring` squares away.
    if (best && best->distance <= ring * side_) break;
  }
  return best;
}

}  // namespace planish::sheet_detail
