#include "block_tree.hpp"

#include <gtest/gtest.h>

namespace planish::collision_detail {
namespace {

std::vector<Vec3> cuboid(const Vec3& low, const Vec3& high) {
  std::vector<Vec3> corners;
  for (int i = 0; i < 8; ++i)
    corners.emplace_back(i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(),
                         i & 4 ? high.z() : low.z());
  return corners;
}

/// Corners at the axes, `size` from the middle.
std::vector<Vec3> octahedron(const Vec3& middle, double size) {
  std::vector<Vec3> corners;
  for (int k = 0; k < 3; ++k)
    for (const double sign : {1.0, -1.0})
      corners.push_back(middle + sign * size * Vec3::Unit(k));
  return corners;
}

TEST(BlockTree, FindsWhereBlocksOfTwoTreesMeet) {
  const BlockTree one({cuboid({0, 0, 0}, {10, 10, 10}), cuboid({50, 0, 0}, {60, 10, 10})});
  const BlockTree other({cuboid({8, 7, 6}, {20, 20, 20}), cuboid({80, 0, 0}, {90, 10, 10})});
  const Box3 found = one.meetings(other);
  EXPECT_TRUE(found.isApprox(Box3(Vec3(8, 7, 6), Vec3(10, 10, 10))));
  EXPECT_TRUE(other.meetings(one).isApprox(found));
  EXPECT_TRUE(one.meetings(BlockTree({cuboid({20, 0, 0}, {30, 9, 9})})).isEmpty());
}

TEST(BlockTree, LooksAtHullsAndNotAtBoxesAlone) {
  // Their boxes overlap at a corner. |x| + |y| + |z| of the middle between both is 3 · 6.
  const auto meets = [](double size) {
    return !BlockTree({octahedron({0, 0, 0}, size)})
                .meetings(BlockTree({octahedron({12, 12, 12}, size)}))
                .isEmpty();
  };
  EXPECT_FALSE(meets(17.9));
  EXPECT_TRUE(meets(18.1));
}

TEST(BlockTree, HoldsAllPlacesInItsBox) {
  const BlockTree row({cuboid({0, 0, 0}, {1, 9, 1}), cuboid({20, 0, 0}, {21, 9, 1})});
  const Box3 found = row.meetings(BlockTree({cuboid({-5, 4, 0}, {30, 5, 1})}));
  EXPECT_TRUE(found.isApprox(Box3(Vec3(0, 4, 0), Vec3(21, 5, 1))));
}

TEST(BlockTree, PassesByNeighboursInItsOwnList) {
  const auto a = cuboid({0, 0, 0}, {10, 1, 1}), b = cuboid({9, 0, 0}, {19, 1, 1}),
             c = cuboid({8, 0, 0}, {12, 1, 1}), far = cuboid({90, 0, 0}, {91, 1, 1});
  EXPECT_TRUE(BlockTree({a, b}).own_meetings().isEmpty());
  EXPECT_TRUE(BlockTree({a, b, c}).own_meetings().isApprox(Box3(Vec3(8, 0, 0), Vec3(10, 1, 1))));
  EXPECT_TRUE(BlockTree({a, far, c}).own_meetings().isApprox(Box3(Vec3(8, 0, 0), Vec3(10, 1, 1))));
  EXPECT_TRUE(BlockTree({a, far, far}).own_meetings().isEmpty());
}

}  // namespace
}  // namespace planish::collision_detail
