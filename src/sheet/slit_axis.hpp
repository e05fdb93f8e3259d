#pragma once

#include <planish/geometry/curve.hpp>

#include <vector>

namespace planish::sheet_detail {

/// Slits as chains of corners: lines that go on where another ends, and nowhere else, are one slit.
/// A place where three of them meet ends all three. O(slits²).
std::vector<std::vector<Vec2>> chains_of(const std::vector<Segment>& slits, double tolerance);

/// A chain as lines and arcs within a tolerance of its corners. Small turns are those of a curve
/// drawn as lines, and become arcs with common tangents; others stay corners.
Loop curves_through(const std::vector<Vec2>& chain, double tolerance);

/// The curve beside one, at a distance to its left; to the right if negative. Arcs must be wider;
/// then corners are cut or rounded about themselves, so that the bank of a slit stays beside it.
Loop beside(const Loop& axis, double aside);

/// Of curves in turn the part from the first, or until the last, place that is outside a disc about
/// their start, or end.
Loop without_start(const Loop& curves, const Vec2& center, double radius);
Loop without_end(Loop curves, const Vec2& center, double radius);

}  // namespace planish::sheet_detail
