#include <planish/geometry/box_tree.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace planish::test {
namespace {

Box2 box_between(double x0, double y0, double x1, double y1) {
  Box2 made;
  made.add(Vec2(x0, y0));
  made.add(Vec2(x1, y1));
  return made;
}

std::vector<size_t> found_in(const BoxTree2& tree, const Box2& query) {
  std::vector<size_t> ids;
  tree.visit(query, [&](size_t id) { ids.push_back(id); });
  std::ranges::sort(ids);
  return ids;
}

bool touch(const Box2& a, const Box2& b) {
  return (a.lo.array() <= b.hi.array()).all() && (b.lo.array() <= a.hi.array()).all();
}

TEST(BoxTree2, FindsWhatASearchThroughAllFinds) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> at(0.0, 100.0), size(0.0, 8.0);
  const auto any = [&] {
    const double x = at(random), y = at(random);
    return box_between(x, y, x + size(random), y + size(random));
  };
  for (const int count : {0, 1, 6, 7, 13, 300}) {
    std::vector<Box2> boxes;
    for (int i = 0; i < count; ++i)
      boxes.push_back(any());
    const BoxTree2 tree(boxes);
    for (int query = 0; query < 50; ++query) {
      const Box2 asked = any();
      std::vector<size_t> expected;
      for (size_t i = 0; i < boxes.size(); ++i)
        if (touch(boxes[i], asked)) expected.push_back(i);
      EXPECT_EQ(found_in(tree, asked), expected) << count;
    }
  }
}

TEST(BoxTree2, FindsBoxesThatTouchAndLeavesOutEmptyOnes) {
  const BoxTree2 tree({box_between(0, 0, 1, 1), Box2{}, box_between(1, 1, 2, 2)});
  EXPECT_EQ(found_in(tree, box_between(1, 1, 1, 1)), (std::vector<size_t>{0, 2}));
  EXPECT_TRUE(found_in(tree, Box2{}).empty());
}

TEST(BoxDistance, IsThatOfTheNearestPoints) {
  EXPECT_DOUBLE_EQ(box_distance(box_between(0, 0, 1, 1), box_between(4, 5, 9, 9)), 5.0);
  EXPECT_DOUBLE_EQ(box_distance(box_between(0, 0, 1, 1), box_between(0.5, 3, 2, 4)), 2.0);
  EXPECT_DOUBLE_EQ(box_distance(box_between(0, 0, 3, 3), box_between(1, 1, 2, 2)), 0.0);
}

TEST(Widened, GrowsByItsReachOnAllSides) {
  const Box2 grown = widened(box_between(1, 2, 3, 4), 0.5);
  EXPECT_EQ(grown.lo, Vec2(0.5, 1.5));
  EXPECT_EQ(grown.hi, Vec2(3.5, 4.5));
}

}  // namespace
}  // namespace planish::test
