#pragma once

#include <planish/base/result.hpp>
#include <planish/sheet/flat_pattern.hpp>

#include <optional>
#include <vector>

namespace planish::sheet_detail {

/// A corner of a contour, where curve `at` begins; contour 0 is the outer one, then come the
/// openings.
struct Corner {
  int contour = 0;
  int at = 0;
};

/// A slit as cut: within `half_width` of its axis, with a hole at each end inside the material.
struct Slot {
  Segment axis;  ///< from one end to the other
  double half_width = 0.0;
  double hole = 0.0;                    ///< radius, 0: none
  std::optional<Corner> opens_at = {};  ///< where the axis begins; closed without
  Loop curves = {};                     ///< what its axis is if not straight: lines and arcs

  Loop whole_axis() const { return curves.empty() ? Loop{axis} : curves; }
  /// The axis as chords.
  std::vector<Segment> chords() const;

  /// Radius and places of its ends inside the material.
  double end_radius() const { return hole > half_width ? hole : half_width; }
  std::vector<Vec2> holes() const {
    return opens_at ? std::vector<Vec2>{axis.b} : std::vector<Vec2>{axis.a, axis.b};
  }
};

/// The curve as chords that deviate from it by at most a thousandth of its length.
std::vector<Vec2> chain_of(const Curve2& curve);

/// The contour of a slot inside the material, clockwise.
Loop closed_slot(const Slot& slot);

/// The contour that a slot opens into, with its banks. Errors: `bad_option` (the contour's
/// neighbouring lines are shorter than the slot is wide, or a curve of the axis is tighter),
/// `unsupported_shape` (they are not lines).
Result<Contour> with_open_slot(const Contour& contour, const Slot& slot, double tolerance);

/// The parts of a line outside all slots.
std::vector<Segment> outside(const Segment& line, const std::vector<Slot>& slots);

}  // namespace planish::sheet_detail
