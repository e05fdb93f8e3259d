#pragma once

#include "nester.hpp"

namespace planish::nest_detail {

/// Copies of one shape that are laid as one.
struct Block {
  Shape shape;  ///< a rectangle around several, or the outline itself
  int of = 0;   ///< which of the shapes given
  /// Where the copies lie in it; `shape` of each is `of`.
  std::vector<Position> members;
};

/// A position within a block that lies at another.
Position within(const Position& block, const Position& member);

/// The shapes as they are, one block each with one member, if there are few. Else copies of small
/// ones are put together, so that a room holds about `kRoomful` blocks: what libnest2d needs for a
/// room grows with more than the square of their number.
std::vector<Block> blocks_of(const std::vector<Shape>& shapes, const Room& room,
                             const Progress& progress);

constexpr int kFew = 200, kRoomful = 120;

}  // namespace planish::nest_detail
