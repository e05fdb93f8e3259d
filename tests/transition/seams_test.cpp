#include "seams.hpp"

#include "sample_rings.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace planish::test {
namespace {

using namespace transition_detail;

std::vector<Cut> cuts(const Ring& ring, const std::optional<Seam>& seam,
                      Division pieces = Division::one) {
  const auto found = cuts_of(ring, seam, pieces);
  EXPECT_TRUE(found) << (found ? "" : found.error().message);
  return found ? *found : std::vector<Cut>{};
}

/// Where a cut leaves the first profile.
Vec3 start(const Ring& ring, const Cut& cut) { return ring.patch(cut.patch).ruling(cut.at)[0]; }

TEST(CutsOf, AnEdgeAreInItsMiddle) {
  for (const Ring& ring : {pyramid(), square_to_circle()}) {
    EXPECT_LT((start(ring, cuts(ring, SeamEdge{0})[0]) - Vec3(0, -50, 0)).norm(), 1e-7);
    EXPECT_LT((start(ring, cuts(ring, SeamEdge{3})[0]) - Vec3(-50, 0, 0)).norm(), 1e-7);
  }
}

TEST(CutsOf, ACornerAreInTheMiddleOfWhatTurnsThere) {
  const Ring ring = square_to_circle();
  const Cut cut = cuts(ring, SeamCorner{1})[0];
  EXPECT_LT((start(ring, cut) - Vec3(50, -50, 0)).norm(), 1e-9);
  const RuledPatch& cone = ring.patch(cut.patch);
  EXPECT_NEAR(cone.turn(0.0, cut.at), 0.5 * cone.turn(0.0, 1.0), 1e-9);
  EXPECT_EQ(cuts(pyramid(), SeamCorner{1})[0].at, 0.0) << "a fold is not divided";
}

TEST(CutsOf, AParameterAreAtThatShareOfTheProfile) {
  const Ring ring = frustum();
  for (const double share : {0.0, 0.2, 0.7}) {
    const Vec3 expected(50 * std::cos(2 * kPi * share), 50 * std::sin(2 * kPi * share), 0);
    EXPECT_LT((start(ring, cuts(ring, SeamParameter{share})[0]) - expected).norm(), 1e-7);
  }
}

TEST(CutsOf, AParameterBesideACornerAreAtTheCorner) {
  const Ring ring = pyramid();
  const Cut cut = cuts(ring, SeamParameter{0.25 + 1e-12})[0];
  EXPECT_EQ(cut.at, 0.0);
  EXPECT_LT((start(ring, cut) - Vec3(50, -50, 0)).norm(), 1e-9);
}

TEST(CutsOf, NothingGivenAreWhereTheWeldIsShortest) {
  // The upper square is nearest to the side at x = 50, and there to its middle.
  const Ring ring = ring_between(rectangle(100, 100), rectangle(60, 60), {10, 0, 80});
  const auto found = cuts(ring, std::nullopt);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_LT((start(ring, found[0]) - Vec3(50, 0, 0)).norm(), 1e-9);
  // Of a leaning cone the ruling on the side to which it leans.
  const Ring cone = ring_between(EllipseProfile{50, 50}, EllipseProfile{20, 20}, {0, 10, 80});
  EXPECT_LT((start(cone, cuts(cone, std::nullopt)[0]) - Vec3(0, 50, 0)).norm(), 1e-3);
}

TEST(CutsOf, TwoPiecesAreOppositeByLength) {
  const Ring ring = pyramid();
  const auto found = cuts(ring, SeamEdge{0}, Division::two);
  ASSERT_EQ(found.size(), 2u);
  double y = 0.0;
  for (const Cut& cut : found) {
    EXPECT_NEAR(start(ring, cut).x(), 0.0, 1e-7);
    y += start(ring, cut).y();
  }
  EXPECT_NEAR(y, 0.0, 1e-7);
}

TEST(CutsOf, APieceForEachSideAreAtCornersOrInTheMiddleOfWhatIsRound) {
  EXPECT_EQ(cuts(pyramid(), std::nullopt, Division::per_side).size(), 4u);
  const Ring round = ring_between(RoundedRectangleProfile{100, 100, 20}, EllipseProfile{30, 30},
                                  {0, 0, 80});
  const auto found = cuts(round, std::nullopt, Division::per_side);
  ASSERT_EQ(found.size(), 4u);
  for (const Cut& cut : found) {
    const Vec3 p = start(round, cut);
    EXPECT_NEAR(std::abs(p.x()), 30 + 20 * std::sqrt(0.5), 1e-6);
    EXPECT_NEAR(std::abs(p.y()), 30 + 20 * std::sqrt(0.5), 1e-6);
  }
}

TEST(PartsBetween, RunOverTheEndOfTheRing) {
  const Ring ring = antiprism();
  const auto parts = parts_between(ring, {6, 0.25}, {1, 0.5});
  ASSERT_EQ(parts.size(), 4u);
  EXPECT_EQ(parts[0].patch, 6);
  EXPECT_EQ(parts[0].from, 0.25);
  EXPECT_EQ(parts[2].patch, 0);
  EXPECT_EQ(parts[3].to, 0.5);
  EXPECT_EQ(parts_between(ring, {2, 0.1}, {2, 0.4}).size(), 1u);
  EXPECT_EQ(parts_between(ring, {2, 0.4}, {2, 0.1}).size(), 9u) << "once round";
}

TEST(BegunAt, ARulingOfAClosedPatchStartsThere) {
  const Ring ring = ring_between(EllipseProfile{50, 30}, EllipseProfile{20, 40}, {10, 5, 80});
  const Ring moved = begun_at(ring, 0.3, 1e-9);
  ASSERT_EQ(moved.count(), 1);
  for (int side = 0; side < 2; ++side) {
    const Vec3 there = ring.patch(0).ruling(0.3)[side];
    EXPECT_LT((moved.patch(0).ruling(0.0)[side] - there).norm(), 1e-9);
    EXPECT_LT((moved.patch(0).ruling(1.0)[side] - there).norm(), 1e-9);
  }
  EXPECT_NEAR(moved.patch(0).area(0.0, 1.0), ring.patch(0).area(0.0, 1.0), 1e-7);
}

TEST(FoldBetween, IsTheAngleOfTheNormalsOrZero) {
  // Normals lean upwards by atan(20 / 80) and are a quarter turn apart.
  EXPECT_NEAR(fold_between(pyramid(), {0, 0, 1}, {1, 0, 1}), std::acos(1.0 / 17.0), 1e-12);
  const Ring smooth = square_to_circle();
  for (int i = 0; i < smooth.count(); ++i)
    EXPECT_EQ(fold_between(smooth, {i, 0, 1}, {(i + 1) % smooth.count(), 0, 1}), 0.0);
}

TEST(OpenSeam, TakesAHundredthOfAMillimetreFromTheWiderProfile) {
  const Ring ring = pyramid();
  const Cut cut = cuts(ring, SeamEdge{0})[0];
  auto parts = parts_between(ring, cut, cut);
  const double missing = open_seam(ring, parts);
  const Vec3 a = ring.patch(parts.front().patch).ruling(parts.front().from)[0],
             b = ring.patch(parts.back().patch).ruling(parts.back().to)[0];
  EXPECT_NEAR((a - b).norm(), 0.01, 1e-9);
  // Two slices, 0.005 wide below and 0.003 above.
  EXPECT_NEAR(missing, 0.008 * std::hypot(80, 20), 1e-9);
}

}  // namespace
}  // namespace planish::test
