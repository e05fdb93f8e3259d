#pragma once

#include <planish/sheet/flat_pattern.hpp>

namespace planish::io_detail {

/// A circle within a pattern that holds no contour, mm: about the largest. Of radius 0, in the
/// middle of the pattern's box, where none is found.
struct RoomForText {
  Vec2 middle;
  double radius = 0.0;
};
RoomForText room_for_text(const FlatPattern& pattern);

}  // namespace planish::io_detail
