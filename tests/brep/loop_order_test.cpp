#include "loop_order.hpp"

#include <gtest/gtest.h>

namespace planish::brep {
namespace {

/// The sides of a unit square, run counter-clockwise; corner i is vertex i.
std::vector<SolidEdge> square() {
  const std::vector<Vec3> corners{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  std::vector<SolidEdge> edges(4);
  for (int i = 0; i < 4; ++i) {
    edges[i].curve.start = corners[i];
    edges[i].curve.end = corners[(i + 1) % 4];
    edges[i].vertices = {i, (i + 1) % 4};
  }
  return edges;
}

std::vector<int> numbers(const std::vector<CoEdge>& uses) {
  std::vector<int> edges;
  for (const CoEdge& use : uses)
    edges.push_back(use.edge);
  return edges;
}

TEST(InOrder, IsALoopThatRunsFromVertexToVertex) {
  EXPECT_TRUE(in_order(square(), {{0, true}, {1, true}, {2, true}, {3, true}}));
  EXPECT_TRUE(in_order(square(), {{3, false}, {2, false}, {1, false}, {0, false}}));
  EXPECT_FALSE(in_order(square(), {{0, true}, {2, true}, {1, true}, {3, true}}));
  EXPECT_FALSE(in_order(square(), {{0, true}, {1, false}, {2, true}, {3, true}}));
}

TEST(Chained, OrdersUsesByTheirEnds) {
  const auto uses = chained(square(), {{2, true}, {0, true}, {1, true}, {3, true}});
  EXPECT_EQ(numbers(uses), std::vector<int>({2, 3, 0, 1}));
  EXPECT_TRUE(in_order(square(), uses));
}

TEST(Chained, FollowsEdgesThatRunBackwards) {
  const auto uses = chained(square(), {{0, false}, {1, false}, {2, false}, {3, false}});
  EXPECT_EQ(numbers(uses), std::vector<int>({0, 3, 2, 1}));
}

TEST(Chained, TakesTheNearestStartWhereEndsLieApart) {
  auto edges = square();
  edges[1].curve.start += Vec3(0.01, 0, 0);
  edges[3].curve.start += Vec3(0, -0.02, 0);
  const auto uses = chained(edges, {{0, true}, {3, true}, {2, true}, {1, true}});
  EXPECT_EQ(numbers(uses), std::vector<int>({0, 1, 2, 3}));
}

}  // namespace
}  // namespace planish::brep
