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

TEST(Chained, TakesTheFirstOfTwoThatStartAsNear) {
  // Edges 1 and 2 leave one corner, which edge 3 reaches.
  const Vec3 a(0, 0, 0), b(1, 0, 0), c(2, 0, 0), d(3, 1, 0), e(3, -1, 0);
  const std::vector<std::pair<Vec3, Vec3>> ends{{a, b}, {c, d}, {c, e}, {b, c}};
  std::vector<SolidEdge> edges(4);
  for (int i = 0; i < 4; ++i) {
    edges[i].curve.start = ends[i].first;
    edges[i].curve.end = ends[i].second;
  }
  const auto uses = chained(edges, {{0, true}, {1, true}, {2, true}, {3, true}});
  EXPECT_EQ(numbers(uses), std::vector<int>({0, 3, 1, 2}));
}

}  // namespace
}  // namespace planish::brep
