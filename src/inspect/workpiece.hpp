#pragma once

#include "gap.hpp"
#include "ring_index.hpp"

#include <planish/sheet/flat_pattern.hpp>

#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace planish::inspect_detail {

/// One limit of a bend zone: where a flange begins.
struct BendSide {
  size_t bend = 0;                ///< index in the pattern's bends
  std::vector<Segment> segments;  ///< tangent line, where there is material
  Vec2 start = Vec2::Zero();      ///< ends of the whole line
  Vec2 end = Vec2::Zero();
  Vec2 outward = Vec2::Zero();  ///< unit vector across the line, away from the bend zone
  double length() const { return (end - start).norm(); }
};

/// A segment of a tangent line and its bend.
struct TangentSegment {
  Segment line;
  size_t bend = 0;
};

/// Ends of a whole bend line.
struct BendSpan {
  Vec2 start = Vec2::Zero();
  Vec2 end = Vec2::Zero();
};

/// An opening as the rules see it.
struct Opening {
  const Loop* loop = nullptr;
  BoxedLoop boxed;
  Vec2 center = Vec2::Zero();
  Told size;                    ///< "Ø 6 mm", "12 × 4 mm"
  bool is_cut = false;          ///< a slit, drawn and cut as one line
  std::set<size_t> bounds;      ///< bends that end at it: it is a relief, or the window of a tab
  std::set<size_t> reaches_in;  ///< bends from whose zone it takes material
};

/// A flat pattern prepared for queries by place. Holds references: sheet and pattern must outlive
/// it.
struct Workpiece {
  Workpiece(const Sheet& sheet, const FlatPattern& pattern);

  const Sheet& sheet;
  const FlatPattern& pattern;
  double thickness;
  RingIndex contours;  ///< ring 0 is the outer contour, ring i + 1 opening i
  RingIndex slits;     ///< the pattern's slits, there and back: cuts without area
  std::vector<BendSide> sides;
  std::vector<std::optional<BendSpan>> spans;  ///< by bend; empty without bend lines
  std::vector<Box2> zones;                     ///< by bend: box of its lines
  std::vector<TangentSegment> tangent_lines;   ///< the segments of all sides
  BoxTree2 tangent_index;                      ///< index of their boxes
  BoxTree2 zone_index;                         ///< index of `zones`
  std::vector<Opening> openings;

  /// The sides of one bend.
  std::span<const BendSide> sides_of(size_t bend) const;
  /// A bend by its name, and the middle of its line.
  Place place_of(size_t bend) const;
  bool material(const Vec2& p) const { return contours.odd(p); }
  /// Whether the straight line from a to b, both on contours or tangent lines, is all material.
  bool joined_by_material(const Vec2& a, const Vec2& b) const;
};

/// Whether the radius is so large that the bend is rolled, not pressed: its flanges need not bridge
/// a die, and openings in it keep their shape.
bool is_rolled(const FlatBend& bend, double thickness);
/// A bend turned back on itself, by at least 170°.
bool is_hem(const FlatBend& bend);

}  // namespace planish::inspect_detail
