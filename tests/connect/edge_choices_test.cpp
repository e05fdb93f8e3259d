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

/// Two plates at a right angle, 2 thick, whose facing edges are a V: its point lies `above` the
/// line where the planes meet, its ends, 100 mm to both sides, 20 mm higher.
PlateStructure with_points(double above) {
  const auto plate = [&](const std::string& id, const Vec3& up) {
    Plate made{id, {}, {}};
    for (const Vec2& p : {Vec2(0, above + 20), Vec2(100, above), Vec2(200, above + 20),
                          Vec2(200, 100), Vec2(0, 100)})
      made.outline.push_back(p.x() * Vec3::UnitX() + p.y() * up);
    return made;
  };
  PlateStructure structure;
  structure.thickness = 2.0;
  structure.plates = {plate("A", Vec3::UnitY()), plate("B", Vec3::UnitZ())};
  return structure;
}

/// Where facing runs end that are not corners of the plates, as (x, height), each once.
std::vector<Vec2> cut_ends(const PlateStructure& structure) {
  const PairTask pair(structure);
  std::vector<Vec2> ends;
  for (const PairChoice& choice : edge_choices(pair.task, {})) {
    const auto corners = choice.corners(choice.search.best);
    for (int side = 0; side < 2; ++side) {
      const auto outline = side_outline(pair.plates[side], choice.frame, side);
      for (const Vec2& p : corners[side]) {
        const auto is_near = [](const Vec2& q) {
          return [q](const Vec2& other) { return (other - q).norm() < 1e-9; };
        };
        if (std::ranges::any_of(outline, is_near(p))) continue;
        const Vec2 end(choice.frame.point(side, p).x(), p.y());
        if (std::ranges::none_of(ends, is_near(end))) ends.push_back(end);
      }
    }
  }
  std::ranges::sort(ends, {}, [](const Vec2& p) { return p.x(); });
  return ends;
}

TEST(EdgeChoices, LeaveRoomForABendBesideThePointWherePlatesTouch) {
  // Inside radii of the thickness, and of a quarter of it, need 2 + 1 and 0.5 + 1 to the line: both
  // flanks of the V, 1 in 5 steep, are cut off there.
  const auto ends = cut_ends(with_points(0));
  const std::vector<Vec2> expected{{85, 3}, {92.5, 1.5}, {107.5, 1.5}, {115, 3}};
  ASSERT_EQ(ends.size(), expected.size());
  for (std::size_t i = 0; i < ends.size(); ++i)
    EXPECT_LT((ends[i] - expected[i]).norm(), 1e-9) << ends[i].transpose();
}

TEST(EdgeChoices, CutNothingOffWhereThereIsRoomForTheRadius) {
  // 2 above the line there is room for the smaller radius.
  const auto ends = cut_ends(with_points(2));
  const std::vector<Vec2> expected{{95, 3}, {105, 3}};
  ASSERT_EQ(ends.size(), expected.size());
  for (std::size_t i = 0; i < ends.size(); ++i)
    EXPECT_LT((ends[i] - expected[i]).norm(), 1e-9) << ends[i].transpose();
  EXPECT_TRUE(cut_ends(with_points(3.5)).empty());
}

TEST(EdgeChoices, BeginWithTheWidestThatIsWorthItsSpan) {
  std::mt19937 random(7);
  PlateStructure structure;
  structure.thickness = 2.0;
  structure.plates = {irregular("A", random, Vec3::UnitY()), irregular("B", random, {0, 0.3, 0.9})};
  for (const double trade_off : {0.0, 0.3, 1.0, 10.0}) {
    const PairTask pair(structure, {.trade_off = trade_off});
    const auto choices = edge_choices(pair.task, {});
    ASSERT_GT(choices.size(), 10u);
    const auto shortest = std::ranges::min_element(
        choices, {}, [](const PairChoice& choice) { return choice.search.best.span; });
    const EdgeChoice &first = choices.front().search.best, &least = shortest->search.best;
    EXPECT_LE(first.span - least.span, trade_off * (first.width - least.width) + 1e-9);
    for (const PairChoice& choice : choices) {
      const EdgeChoice& other = choice.search.best;
      const bool wider = other.width > first.width + 1e-9;
      EXPECT_TRUE(!wider || other.span - least.span > trade_off * (other.width - least.width));
    }
  }
}

}  // namespace
}  // namespace planish::test
