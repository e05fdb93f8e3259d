#include "blocks.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

// Many copies as blocks of few, since the cost of nesting grows with the square of what is nested.
// Up to eight copies are laid in narrow rooms, and the way that fills its rectangle best (of equals
// the squarer) becomes a rectangle of its own; blocks are grouped again until they are large
// enough. What does not divide evenly stays single. Moving a block moves its members by the same
// motion.

namespace planish::nest_detail {
namespace {

struct Extent {
  IntPoint low, high;
  cInt length() const { return high.X - low.X; }
  cInt width() const { return high.Y - low.Y; }
  double area() const { return static_cast<double>(length()) * static_cast<double>(width()); }
};

Extent extent_of(const Path& path) {
  Extent extent{path.front(), path.front()};
  for (const IntPoint& p : path) {
    extent.low = {std::min(extent.low.X, p.X), std::min(extent.low.Y, p.Y)};
    extent.high = {std::max(extent.high.X, p.X), std::max(extent.high.Y, p.Y)};
  }
  return extent;
}

IntPoint turned(const IntPoint& p, int quarter_turns) {
  switch (quarter_turns % 4) {
    case 1:
      return {-p.Y, p.X};
    case 2:
      return {-p.X, -p.Y};
    case 3:
      return {p.Y, -p.X};
    default:
      return p;
  }
}

Path placed(const Path& outline, const Position& position) {
  Path path;
  for (const IntPoint& p : outline) {
    const IntPoint at = turned(p, position.quarter_turns);
    path.emplace_back(at.X + position.shift.X, at.Y + position.shift.Y);
  }
  return path;
}

bool fits(const Extent& extent, const Room& room) {
  const bool along = extent.length() <= room.length && extent.width() <= room.width;
  const bool across = extent.width() <= room.length && extent.length() <= room.width;
  return along || (across && !room.half_turns_only);
}

Path rectangle(cInt length, cInt width) {
  return {{0, 0}, {length, 0}, {length, width}, {0, width}};
}

/// `count` copies in a room of that width, with the rectangle around them.
struct Trial {
  std::vector<Position> positions;
  Extent extent;
};

std::optional<Trial> laid_in(const Path& outline, int count, cInt width, const Room& room) {
  const auto rooms = lay_out({{outline, count}}, {room.length, width, room.half_turns_only},
                             Progress{});
  if (rooms.size() != 1) return std::nullopt;
  Trial trial{rooms.front(), {}};
  Path all;
  for (const Position& position : trial.positions) {
    const Path path = placed(outline, position);
    all.insert(all.end(), path.begin(), path.end());
  }
  trial.extent = extent_of(all);
  return fits(trial.extent, room) ? std::optional(trial) : std::nullopt;
}

/// The way to lay at most `most` copies in which most of their rectangle is filled.
std::optional<Trial> densest(const Path& outline, int most, const Room& room) {
  constexpr int kFewest = 2;
  std::optional<Trial> best;
  double best_fill = 0.0;
  const Extent one = extent_of(outline);
  const cInt short_side = std::min(one.length(), one.width());
  for (int count = most; count >= std::max(kFewest, most / 2); --count) {
    for (int rows = 1; rows <= count && rows * short_side <= room.width; ++rows) {
      const auto trial = laid_in(outline, count, rows * short_side, room);
      if (!trial) continue;
      const double fill = count * std::abs(ClipperLib::Area(outline)) / trial->extent.area();
      // Of two that are equally full, the one nearer to a square; of those the larger.
      const double squareness = static_cast<double>(
                                    std::min(trial->extent.length(), trial->extent.width())) /
                                static_cast<double>(
                                    std::max(trial->extent.length(), trial->extent.width()));
      constexpr double kWorth = 0.05;  // of the fill, for a square in place of a long strip
      const double value = fill + kWorth * squareness;
      if (value > best_fill) {
        best_fill = value;
        best = trial;
      }
    }
  }
  return best;
}

/// Blocks of several of the given ones, and what remains.
struct Grouped {
  Block block;
  std::optional<Block> rest;
};

std::optional<Grouped> grouped(const Block& one, double wanted_area, const Room& room) {
  constexpr int kMost = 8;
  const double area = extent_of(one.shape.outline).area();
  const int most = std::min({kMost, one.shape.count, static_cast<int>(2.0 * wanted_area / area)});
  if (most < 2) return std::nullopt;
  const std::optional<Trial> trial = densest(one.shape.outline, most, room);
  if (!trial) return std::nullopt;
  const auto size = static_cast<int>(trial->positions.size());
  Grouped result;
  result.block.of = one.of;
  result.block.shape = {rectangle(trial->extent.length(), trial->extent.width()),
                        one.shape.count / size};
  for (Position position : trial->positions) {
    position.shift.X -= trial->extent.low.X;
    position.shift.Y -= trial->extent.low.Y;
    for (const Position& member : one.members)
      result.block.members.push_back(within(position, member));
  }
  if (const int left = one.shape.count % size; left > 0) {
    result.rest = one;
    result.rest->shape.count = left;
  }
  return result;
}

}  // namespace

Position within(const Position& block, const Position& member) {
  const IntPoint shift = turned(member.shift, block.quarter_turns);
  return {member.shape,
          (block.quarter_turns + member.quarter_turns) % 4,
          {shift.X + block.shift.X, shift.Y + block.shift.Y}};
}

std::vector<Block> blocks_of(const std::vector<Shape>& shapes, const Room& room,
                             const Progress& progress) {
  const double wanted_area = static_cast<double>(room.length) * static_cast<double>(room.width) /
                             kRoomful;
  const int copies = std::accumulate(shapes.begin(), shapes.end(), 0,
                                     [](int sum, const Shape& s) { return sum + s.count; });
  std::vector<Block> blocks;
  for (std::size_t s = 0; s < shapes.size(); ++s) {
    Block block{shapes[s], static_cast<int>(s), {{static_cast<int>(s), 0, {0, 0}}}};
    while (copies > kFew && !progress.should_stop() &&
           extent_of(block.shape.outline).area() < wanted_area) {
      auto larger = grouped(block, wanted_area, room);
      if (!larger) break;
      if (larger->rest) blocks.push_back(*larger->rest);
      block = larger->block;
    }
    blocks.push_back(block);
  }
  return blocks;
}

}  // namespace planish::nest_detail
