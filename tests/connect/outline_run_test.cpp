#include "outline_run.hpp"

#include "bend_frame.hpp"
#include "sample_fits.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace planish::test {
namespace {

using namespace connect_detail;
using ::testing::ElementsAre;

/// 200 × 100, edges 0 (y = 0), 1 (x = 200), 2 (y = 100), 3 (x = 0), and a square hole of 40.
PlacedPlate holed_plate() {
  return laid({"A",
               {{0, 0, 0}, {200, 0, 0}, {200, 100, 0}, {0, 100, 0}},
               {{{80, 30, 0}, {120, 30, 0}, {120, 70, 0}, {80, 70, 0}}}});
}

std::vector<Vec3> in_space(const PlacedPlate& plate, const OutlineRun& run) {
  std::vector<Vec3> points;
  for (const Vec2& p : run_points(plate, run))
    points.push_back(plate.frame.point(p));
  return points;
}

void expect_points(const std::vector<Vec3>& points, const std::vector<Vec3>& expected) {
  ASSERT_EQ(points.size(), expected.size());
  for (size_t i = 0; i < points.size(); ++i)
    EXPECT_NEAR((points[i] - expected[i]).norm(), 0.0, 1e-9);
}

TEST(OutlineRun, RunsFromPointToPointInTheOrderOfTheOutline) {
  const PlacedPlate plate = holed_plate();
  expect_points(in_space(plate, outline_run(plate, {0}, {{50, 0, 0}, {150, 0, 0}})),
                {{50, 0, 0}, {150, 0, 0}});
  expect_points(in_space(plate, outline_run(plate, {0}, {{150, 0, 0}, {50, 0, 0}})),
                {{50, 0, 0}, {150, 0, 0}});
  const std::vector<Vec3> corner{{50, 0, 0}, {200, 0, 0}, {200, 30, 0}};
  expect_points(in_space(plate, outline_run(plate, {0, 1}, {corner[0], corner[2]})), corner);
  expect_points(in_space(plate, outline_run(plate, {1, 0}, {corner[2], corner[0]})), corner);
  // Over the end of the outline's list, three edges.
  expect_points(in_space(plate, outline_run(plate, {2, 3, 0}, {{20, 100, 0}, {10, 0, 0}})),
                {{20, 100, 0}, {0, 100, 0}, {0, 0, 0}, {10, 0, 0}});
  expect_points(in_space(plate, outline_run(plate, {0, 3, 2}, {{10, 0, 0}, {20, 100, 0}})),
                {{20, 100, 0}, {0, 100, 0}, {0, 0, 0}, {10, 0, 0}});
}

TEST(OutlineRun, EndsInACornerThatIsAsNear) {
  const PlacedPlate plate = holed_plate();
  const OutlineRun run = outline_run(plate, {0}, {{1e-12, 0, 0}, {200 - 1e-12, 0, 0}});
  EXPECT_EQ(run.start, 0.0);
  EXPECT_EQ(run.end, 1.0);
  const OutlineRun beyond = outline_run(plate, {0}, {{-5, 0, 0}, {205, 0, 0}});
  EXPECT_EQ(beyond.start, 0.0);
  EXPECT_EQ(beyond.end, 1.0);
}

TEST(OutlineRun, GoesRoundAHoleToo) {
  const PlacedPlate plate = holed_plate();
  const OutlineRun run = outline_run(plate, {4}, {{90, 30, 0}, {110, 30, 0}});
  EXPECT_EQ(run.ring, 1);
  auto points = in_space(plate, run);
  std::ranges::sort(points, {}, [](const Vec3& p) { return p.x(); });
  expect_points(points, {{90, 30, 0}, {110, 30, 0}});
}

TEST(TakeRun, NotesWholeEdgesAndPartsOfThem) {
  const PlacedPlate plate = holed_plate();
  UsedEdges used;
  take(plate, outline_run(plate, {2, 3, 0}, {{150, 100, 0}, {50, 0, 0}}), used);
  EXPECT_THAT(used.whole, ElementsAre(3));
  ASSERT_EQ(used.parts.size(), 2u);
  EXPECT_NEAR(used.parts.at(2).front().first, 0.25, 1e-12);
  EXPECT_EQ(used.parts.at(2).front().second, 1.0);
  EXPECT_EQ(used.parts.at(0).front().first, 0.0);
  EXPECT_NEAR(used.parts.at(0).front().second, 0.25, 1e-12);
  used = {};
  take(plate, outline_run(plate, {0}, {{0, 0, 0}, {200, 0, 0}}), used);
  EXPECT_THAT(used.whole, ElementsAre(0));
  EXPECT_TRUE(used.parts.empty());
}

/// Two plates at a right angle: x of the frame runs along the edge that they could share.
struct FreeChains {
  PlacedPlate a = laid(rectangle_plate("A", {0, 0, 0}, {200, 0, 0}, {0, 100, 0}));
  PlacedPlate b = laid(rectangle_plate("B", {0, 110, 10}, {200, 0, 0}, {0, 0, 100}));
  BendFrame frame = bend_frames(a, b, PlanePair::crossing).front();
  std::vector<Chain> chains = side_chains(a, frame, 0);

  /// The x of the ends of what is left of an edge, from the lower to the higher, each from the
  /// lowest of all.
  std::vector<std::pair<double, double>> left_of(int edge, const EdgeParts& taken,
                                                 double least) const {
    double low = 1e9;
    for (const Chain& chain : chains)
      for (const Vec2& p : chain.corners)
        low = std::min(low, p.x());
    std::vector<std::pair<double, double>> left;
    for (const Chain& chain : free_chains(chains, {{edge, taken}}, a, frame, 0, least))
      for (size_t j = 0; j < chain.edges.size(); ++j)
        if (chain.edges[j] == edge)
          left.emplace_back(chain.corners[j].x() - low, chain.corners[j + 1].x() - low);
    std::ranges::sort(left);
    return left;
  }
};

TEST(FreeRuns, AreWhatIsLeftOfAnEdgeOnBothSidesOfWhatIsTaken) {
  const FreeChains free;
  const bool forward = (free.frame.local(0, free.a.corner(3)) -
                        free.frame.local(0, free.a.corner(2)))
                           .x() > 0;  // edge 2, which faces the other plate
  const auto at = [&](double share) { return 200 * (forward ? share : 1 - share); };
  const auto left = free.left_of(2, {{0.2, 0.5}}, 1.0);
  ASSERT_EQ(left.size(), 2u);
  std::vector<double> ends{left[0].first, left[0].second, left[1].first, left[1].second};
  std::vector<double> expected{at(0), at(0.2), at(0.5), at(1)};
  std::ranges::sort(expected);
  for (int i = 0; i < 4; ++i)
    EXPECT_NEAR(ends[i], expected[i], 1e-9);
  EXPECT_EQ(free.left_of(2, {{0.2, 0.5}}, 50.0).size(), 1u) << "40 is less than asked";
  EXPECT_EQ(free.left_of(2, {{0.2, 0.5}, {0.4, 0.6}, {0.8, 0.9}}, 1.0).size(), 3u);
  EXPECT_EQ(free.left_of(2, {{0.0, 0.4}, {0.4, 1.0}}, 1.0).size(), 0u);
  EXPECT_EQ(free.left_of(2, {{0.5, 1.0}}, 1.0).size(), 1u);
  EXPECT_EQ(free_chains(free.chains, {}, free.a, free.frame, 0, 1.0).size(), free.chains.size());
}

TEST(LocalRings, LieWhereTheSurfaceHasThem) {
  const PlacedPlate plate = holed_plate();
  BendSurface surface;
  surface.tangents[1] = {{10, 100, 0}, Vec3::UnitX(), -Vec3::UnitY()};
  const auto rings = local_rings(plate, surface, 1);
  ASSERT_EQ(rings.size(), 2u);
  ASSERT_EQ(rings[0].size(), 4u);
  for (int i = 0; i < 4; ++i) {
    const Vec3 p = plate.corner(i);
    EXPECT_NEAR((rings[0][i] - Vec2(p.x() - 10, 100 - p.y())).norm(), 0.0, 1e-9);
  }
}

}  // namespace
}  // namespace planish::test
