#include <planish/sheet/flat_pattern.hpp>

#include <gtest/gtest.h>

namespace planish::test {
namespace {

TEST(PartName, CountsFlangesFromOneAndCallsBendsAsThePatternDoes) {
  FlatPattern pattern;
  FlatBend bend;
  bend.id = "B7";
  bend.bend = BendId{2};
  pattern.bends = {bend};
  EXPECT_EQ(text_of(part_place(pattern, FlangeId{2})), "flange 3");
  EXPECT_EQ(text_of(part_place(pattern, BendId{2})), "bend B7");
  EXPECT_EQ(text_of(part_place(pattern, BendId{0})), "bend B1")
      << "one that the pattern does not have";
}

TEST(PartName, AnOrderIsKnownOnceOneBendHasItsStroke) {
  FlatPattern pattern;
  EXPECT_FALSE(has_order(pattern));
  pattern.bends.resize(2);
  EXPECT_FALSE(has_order(pattern));
  pattern.bends[1].stroke = 1;
  EXPECT_TRUE(has_order(pattern));
}

}  // namespace
}  // namespace planish::test
