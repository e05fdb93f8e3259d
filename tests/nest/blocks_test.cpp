#include "blocks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace planish::nest_detail {
namespace {

Path box_path(cInt length, cInt width) {
  return {{0, 0}, {length, 0}, {length, width}, {0, width}};
}

IntPoint quarter_turned(IntPoint p, int turns) {
  for (int i = 0; i < turns; ++i)
    p = {-p.Y, p.X};
  return p;
}

Path laid(const Path& outline, const Position& at) {
  Path path;
  for (const IntPoint& p : outline) {
    const IntPoint q = quarter_turned(p, at.quarter_turns);
    path.emplace_back(q.X + at.shift.X, q.Y + at.shift.Y);
  }
  return path;
}

struct Span {
  cInt low_x, low_y, high_x, high_y;
};
Span span_of(const Path& path) {
  Span span{path[0].X, path[0].Y, path[0].X, path[0].Y};
  for (const IntPoint& p : path)
    span = {std::min(span.low_x, p.X), std::min(span.low_y, p.Y), std::max(span.high_x, p.X),
            std::max(span.high_y, p.Y)};
  return span;
}

TEST(Within, MovesAMemberAsItsBlockIsMoved) {
  const Path outline = box_path(30, 10);
  for (int of_block = 0; of_block < 4; ++of_block)
    for (int of_member = 0; of_member < 4; ++of_member) {
      const Position block{7, of_block, {1000, -300}}, member{3, of_member, {40, 5}};
      const Position both = within(block, member);
      EXPECT_EQ(both.shape, 3);
      EXPECT_EQ(laid(outline, both), laid(laid(outline, member), block));
    }
}

TEST(BlocksOf, LeavesFewCopiesAsTheyAre) {
  const std::vector<Shape> shapes{{box_path(50, 20), kFew - 1}, {box_path(10, 10), 1}};
  const auto blocks = blocks_of(shapes, {10000, 5000, false}, {});
  ASSERT_EQ(blocks.size(), 2u);
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(blocks[i].of, i);
    EXPECT_EQ(blocks[i].shape.outline, shapes[i].outline);
    EXPECT_EQ(blocks[i].shape.count, shapes[i].count);
    ASSERT_EQ(blocks[i].members.size(), 1u);
    EXPECT_EQ(blocks[i].members[0].shape, i);
    EXPECT_EQ(blocks[i].members[0].shift, IntPoint(0, 0));
  }
}

TEST(BlocksOf, KeepsEveryCopyInBlocksThatHoldTheirMembers) {
  const std::vector<Shape> shapes{{box_path(3000, 1000), 403}, {box_path(40000, 30000), 5}};
  const Room room{300000, 150000, false};
  const auto blocks = blocks_of(shapes, room, {});
  std::map<int, int> copies;
  bool larger = false;
  for (const Block& block : blocks) {
    larger |= block.members.size() > 1;
    const Span around = span_of(block.shape.outline);
    double filled = 0.0;
    for (size_t i = 0; i < block.members.size(); ++i) {
      EXPECT_EQ(block.members[i].shape, block.of);
      const Span one = span_of(laid(shapes[block.of].outline, block.members[i]));
      EXPECT_GE(one.low_x, around.low_x - 2);
      EXPECT_GE(one.low_y, around.low_y - 2);
      EXPECT_LE(one.high_x, around.high_x + 2);
      EXPECT_LE(one.high_y, around.high_y + 2);
      filled += ClipperLib::Area(shapes[block.of].outline);
      for (size_t j = 0; j < i; ++j) {
        const Span other = span_of(laid(shapes[block.of].outline, block.members[j]));
        const cInt apart = std::max({one.low_x - other.high_x, other.low_x - one.high_x,
                                     one.low_y - other.high_y, other.low_y - one.high_y});
        EXPECT_GE(apart, -4) << "members lie beside each other";
      }
    }
    EXPECT_GE(filled, 0.99 * std::abs(ClipperLib::Area(block.shape.outline)))
        << "rectangles fill a rectangle";
    copies[block.of] += block.shape.count * static_cast<int>(block.members.size());
  }
  EXPECT_TRUE(larger);
  EXPECT_EQ(copies[0], 403);
  EXPECT_EQ(copies[1], 5);
}

TEST(BlocksOf, StopsWhenAsked) {
  const std::vector<Shape> shapes{{box_path(30, 10), 1000}};
  Progress stop;
  stop.cancelled = [] { return true; };
  const auto blocks = blocks_of(shapes, {300000, 150000, false}, stop);
  ASSERT_EQ(blocks.size(), 1u);
  EXPECT_EQ(blocks[0].shape.count, 1000);
}

}  // namespace
}  // namespace planish::nest_detail
