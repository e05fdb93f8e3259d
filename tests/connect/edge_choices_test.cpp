#include "pair_search.hpp"
#include "random_sides.hpp"
#include "sample_fits.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

// All choices of edges between two plates: whichever is tried, it lies where the plates' edges are.

namespace planish::test {
namespace {

using namespace connect_detail;

double distance_to(const Segment& edge, const Vec2& p) {
  const Vec2 along = edge.b - edge.a;
  const double share = std::clamp((p - edge.a).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (p - (edge.a + share * along)).norm();
}

/// An irregular plate in the plane of x and `e` whose edges look towards the x axis.
Plate irregular(const std::string& id, std::mt19937& random, const Vec3& e) {
  Plate plate{id, {}, {}};
  for (const Vec2& p : random_outline(random, {5, 20.0, 0.1, true, false}))
    plate.outline.push_back(p.x() * Vec3::UnitX() + p.y() * e);
  return plate;
}

TEST(EdgeChoices, LieOnTheEdgesThatTheyName) {
  std::mt19937 random(5);
  PlateStructure structure;
  structure.thickness = 2.0;
  structure.plates = {irregular("A", random, Vec3::UnitY()), irregular("B", random, {0, 0.3, 0.9})};
  const PairTask pair(structure);
  const auto choices = edge_choices(pair.task, {});
  int pairs_of_edges = 0;
  for (const PairChoice& choice : choices) {
    const auto edges = choice.edges(choice.search.best);
    const auto corners = choice.corners(choice.search.best);
    for (int side = 0; side < 2; ++side) {
      const auto outline = side_outline(pair.plates[side], choice.frame, side);
      ASSERT_EQ(corners[side].size(), edges[side].size() + 1);
      for (std::size_t k = 0; k < edges[side].size(); ++k) {
        const std::size_t from = static_cast<std::size_t>(edges[side][k]);
        const Segment edge{outline[from], outline[(from + 1) % outline.size()]};
        EXPECT_LT(distance_to(edge, corners[side][k]), 1e-9);
        EXPECT_LT(distance_to(edge, corners[side][k + 1]), 1e-9);
        EXPECT_LT(corners[side][k].x(), corners[side][k + 1].x());
      }
      pairs_of_edges += edges[side].size() == 2;
    }
  }
  EXPECT_GT(pairs_of_edges, 4);
}

}  // namespace
}  // namespace planish::test
