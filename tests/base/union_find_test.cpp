#include <planish/base/union_find.hpp>

#include <gtest/gtest.h>

namespace planish {
namespace {

TEST(UnionFind, TellsWhetherASetGrew) {
  UnionFind sets(4);
  EXPECT_TRUE(sets.unite(3, 1));
  EXPECT_TRUE(sets.unite(1, 2));
  EXPECT_FALSE(sets.unite(2, 3));
  EXPECT_EQ(sets.count(), 2);
  EXPECT_TRUE(sets.same(2, 3));
  EXPECT_FALSE(sets.same(0, 3));
}

TEST(UnionFind, IsNamedByItsSmallestNumber) {
  UnionFind sets(6);
  sets.unite(5, 4);
  sets.unite(4, 2);
  for (const int i : {2, 4, 5})
    EXPECT_EQ(sets.root(i), 2);
}

}  // namespace
}  // namespace planish
