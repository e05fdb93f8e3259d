#include "connect/random_sides.hpp"
#include "connect_oracle/milp.hpp"

#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <random>

// The exact search against the mixed-integer programs of the thesis (bibliography.md#thesis),
// solved by an independent program.

namespace planish::oracle {
namespace {

using Sides = std::array<std::vector<Chain>, 2>;

/// Agreement asked for, as a share of the extent.
constexpr double kAgreement = 1e-7;

struct Reference {
  double length = 0.0;
  EdgeKind kind = EdgeKind::facing;
  Corners corners;
};

template <typename Visit>
void for_each_pair(const Sides& sides, Angle beta, const Visit& visit) {
  for (const Chain& a : sides[0])
    for (const Chain& b : sides[1])
      if (a.kind == b.kind) visit(a, b, arc_factor(beta, a.kind, kLinearisedSlope));
}

std::optional<Reference> shortest_of(const Sides& sides, Angle beta) {
  std::optional<Reference> best;
  for_each_pair(sides, beta, [&](const Chain& a, const Chain& b, double psi) {
    const MilpReference found = minimum_length_bend(a, b, psi);
    ASSERT_NE(found.outcome, Outcome::stopped);
    if (found.outcome == Outcome::infeasible || (best && best->length <= found.length)) return;
    best = {found.length,
            a.kind,
            {corners_of(a, found.edges[0], found.edges[0]),
             corners_of(b, found.edges[1], found.edges[1])}};
  });
  return best;
}

MilpTopology widest_of(const Sides& sides, Angle beta, const Wanted& wanted) {
  MilpTopology best;
  for_each_pair(sides, beta, [&](const Chain& a, const Chain& b, double psi) {
    const MilpTopology found = widest_bend(a, b, psi, wanted);
    ASSERT_NE(found.outcome, Outcome::stopped);
    if (found.outcome == Outcome::optimal && found.width > best.width) best = found;
  });
  return best;
}

double extent_of(const Sides& sides) {
  double low = 1e300, high = -1e300;
  for (const auto& side : sides)
    for (const Chain& chain : side)
      for (const Vec2& p : chain.corners) {
        low = std::min({low, p.x(), 0.0});
        high = std::max({high, p.x(), p.y()});
      }
  return high - low;
}

Corners corners_of_choice(const Sides& sides, const EdgeChoice& choice) {
  Corners corners;
  for (std::size_t i = 0; i < 2; ++i) {
    const Run& run = choice.runs[i];
    corners[i] = corners_of(sides[i][run.chain], run.first, run.last);
  }
  return corners;
}

/// Of references of one length either may be meant: that of the search, if it is as short by the
/// oracle's own reckoning.
void settle_tie(Reference& reference, const Sides& sides, const EdgeSearch& found, Angle beta,
                double close) {
  const Corners theirs = corners_of_choice(sides, found.reference);
  const double length = smallest_length(theirs, found.reference.kind,
                                        arc_factor(beta, found.reference.kind, kLinearisedSlope));
  ASSERT_NEAR(length, reference.length, close) << "the reference is not the shortest bend";
  reference = {length, found.reference.kind, theirs};
}

void expect_agreement(const Sides& sides, Angle beta, double trade_off) {
  const double close = kAgreement * extent_of(sides);
  const auto found = search_edges(
      sides, beta, {.trade_off = trade_off, .line = {}, .edges = {}, .alternatives = 0});
  auto reference = shortest_of(sides, beta);
  ASSERT_EQ(found.has_value(), reference.has_value());
  if (!reference) return;
  EXPECT_NEAR(found->reference_length, reference->length, close);
  ASSERT_NO_FATAL_FAILURE(settle_tie(*reference, sides, *found, beta, close));
  const double psi = arc_factor(beta, reference->kind, kLinearisedSlope);
  const Wanted wanted{smallest_span(reference->corners, reference->kind, psi),
                      width_of(reference->corners), trade_off};
  EXPECT_NEAR(found->reference.span, wanted.reference_span, close);
  EXPECT_NEAR(found->reference.width, wanted.reference_width, close);
  const MilpTopology widest = widest_of(sides, beta, wanted);
  EXPECT_NEAR(found->best.width, widest.width, close);
  EXPECT_LE(found->best.span, widest.span + close)
      << "of several as wide, the search has one that is longer";
  const auto same_run = [&](std::size_t i) {
    return found->best.runs[i].first == widest.runs[i].first &&
           found->best.runs[i].last == widest.runs[i].last;
  };
  if (same_run(0) && same_run(1)) {
    EXPECT_NEAR(found->best.span, widest.span, close);
  }
}

std::vector<Chain> random_chains(std::mt19937& random, int fewest, int most) {
  std::uniform_int_distribution<int> count(fewest, most);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const auto chance = [&](double share) { return unit(random) < share; };
  test::OutlineStyle style;
  style.edges = count(random);
  style.roughness = 40.0 * unit(random);
  style.lean = 0.4 * unit(random) - 0.2;
  style.convex = chance(0.4);
  style.equal = chance(0.2);
  return viable_chains(test::random_outline(random, style));
}

struct Size {
  int fewest, most;  ///< edges a side
};

/// Every seed with each γ in turn: a pair of sides of one kind.
void expect_agreement_of(EdgeKind kind, Size size, unsigned first_seed, unsigned pairs) {
  constexpr std::array trade_offs{0.0, 0.3, 1.0, 2.0, 5.0};
  for (unsigned seed = first_seed; seed < first_seed + pairs; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    Sides sides;
    for (auto& side : sides)
      side = test::only(random_chains(random, size.fewest, size.most), kind);
    const Angle beta = Angle::degrees(std::uniform_real_distribution<double>(20.0, 170.0)(random));
    expect_agreement(sides, beta, trade_offs[seed % trade_offs.size()]);
    if (testing::Test::HasFatalFailure()) return;
  }
}

TEST(EdgeSearchOracle, AgreesOnFacingPairsOfTwoToFourEdges) {
  expect_agreement_of(EdgeKind::facing, {2, 4}, 1000, 150);
}

TEST(EdgeSearchOracle, AgreesOnAvertedPairsOfTwoToFourEdges) {
  expect_agreement_of(EdgeKind::averted, {2, 4}, 2000, 150);
}

TEST(EdgeSearchOracle, AgreesOnFacingPairsOfFiveToEightEdges) {
  expect_agreement_of(EdgeKind::facing, {5, 8}, 3000, 100);
}

TEST(EdgeSearchOracle, AgreesOnAvertedPairsOfFiveToEightEdges) {
  expect_agreement_of(EdgeKind::averted, {5, 8}, 4000, 80);
}

TEST(EdgeSearchOracle, AgreesOnFacingPairsOfNineToTwelveEdges) {
  expect_agreement_of(EdgeKind::facing, {9, 12}, 5000, 20);
}

TEST(EdgeSearchOracle, AgreesOnAvertedPairsOfNineToTwelveEdges) {
  expect_agreement_of(EdgeKind::averted, {9, 12}, 6000, 20);
}

TEST(EdgeSearchOracle, AgreesOnWholePlatesWithChainsOfBothKinds) {
  for (unsigned seed = 7000; seed < 7060; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    const Sides sides{random_chains(random, 1, 4), random_chains(random, 1, 4)};
    expect_agreement(sides, Angle::degrees(20.0 + 2.5 * (seed - 7000)), 0.5 * (seed % 7));
  }
}

}  // namespace
}  // namespace planish::oracle
