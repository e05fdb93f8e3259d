#pragma once

#include "clipper_names.hpp"

#include <planish/base/progress.hpp>

#include <vector>

namespace planish::nest_detail {

/// What is laid on sheets: an outline, counter-clockwise, in units of `kUnit`, as often as `count`.
struct Shape {
  Path outline;
  int count = 1;
};

/// Where one lies: turned by quarter turns about the origin of its outline, then shifted.
struct Position {
  int shape = 0;
  int quarter_turns = 0;
  IntPoint shift;
};

/// The rectangle from the origin to be filled.
struct Room {
  cInt length = 0, width = 0;
  bool half_turns_only = false;
};

/// The shapes on rooms, one list for each, by libnest2d: largest first, each at the place farthest
/// to the left in the first room that has one. Shapes touch, but do not overlap by more than two
/// units. What fits in no room is left out; all of it when cancelled. The only source that sees
/// libnest2d.
std::vector<std::vector<Position>> lay_out(const std::vector<Shape>& shapes, const Room& room,
                                           const Progress& progress);

}  // namespace planish::nest_detail
