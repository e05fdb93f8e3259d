#include "box_tree.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace planish::collision_detail {
namespace {

std::vector<Box3> random_boxes(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(0.0, 50.0), size(0.5, 8.0);
  std::vector<Box3> boxes;
  for (int i = 0; i < count; ++i) {
    const Vec3 low(place(random), place(random), place(random));
    boxes.emplace_back(low, low + Vec3(size(random), size(random), size(random)));
  }
  return boxes;
}

/// Whether they are at most that far apart along each axis, axis by axis.
bool within_reach(const Box3& a, const Box3& b, double reach) {
  for (int k = 0; k < 3; ++k)
    if (a.min()[k] > b.max()[k] + reach || b.min()[k] > a.max()[k] + reach) return false;
  return true;
}

using Pairs = std::set<std::pair<int, int>>;

TEST(BoxTree, FindsEveryPairOfTwoListsWithinReach) {
  const auto a = random_boxes(60, 1), b = random_boxes(45, 2);
  for (const double reach : {0.0, 1.5}) {
    Pairs expected, found;
    for (int i = 0; i < std::ssize(a); ++i)
      for (int j = 0; j < std::ssize(b); ++j)
        if (within_reach(a[i], b[j], reach)) expected.emplace(i, j);
    int calls = 0;
    BoxTree(a).visit_pairs(BoxTree(b), reach, [&](int i, int j) {
      found.emplace(i, j);
      ++calls;
    });
    EXPECT_EQ(found, expected);
    EXPECT_EQ(calls, std::ssize(found)) << "each once";
    EXPECT_FALSE(expected.empty());
  }
}

TEST(BoxTree, FindsEveryPairWithinItselfOnceTheSmallerFirst) {
  const auto boxes = random_boxes(70, 3);
  std::vector<std::pair<int, int>> expected;
  for (int i = 0; i < std::ssize(boxes); ++i)
    for (int j = i + 1; j < std::ssize(boxes); ++j)
      if (within_reach(boxes[i], boxes[j], 0.8)) expected.emplace_back(i, j);
  EXPECT_EQ(near_boxes(boxes, 0.8), expected);
}

TEST(BoxTree, FindsTheBoxesThatMeetAnother) {
  const auto boxes = random_boxes(80, 4);
  const BoxTree tree(boxes);
  for (const Box3& query : random_boxes(20, 5)) {
    std::set<int> expected, found;
    for (int i = 0; i < std::ssize(boxes); ++i)
      if (within_reach(boxes[i], query, 0.0)) expected.insert(i);
    tree.visit(query, [&](int i) { found.insert(i); });
    EXPECT_EQ(found, expected);
  }
  for (int i = 0; i < std::ssize(boxes); ++i)
    EXPECT_TRUE(tree.box(i).isApprox(boxes[i]));
}

TEST(BoxTree, TakesAReachAsStillNear) {
  const std::vector<Box3> boxes{Box3(Vec3(0, 0, 0), Vec3(1, 1, 1)),
                                Box3(Vec3(3, 0, 0), Vec3(4, 1, 1))};
  EXPECT_EQ(near_boxes(boxes, 2.0).size(), 1u);
  EXPECT_TRUE(near_boxes(boxes, 1.99).empty());
}

TEST(BoxTree, MayBeEmpty) {
  const BoxTree none({}), some(random_boxes(3, 6));
  const auto never = [](int, int) { ADD_FAILURE(); };
  none.visit(Box3(Vec3::Zero(), Vec3::Ones()), [](int) { ADD_FAILURE(); });
  none.visit_pairs(some, 100, never);
  some.visit_pairs(none, 100, never);
  none.visit_pairs(100, never);
}

}  // namespace
}  // namespace planish::collision_detail
