#include "random_sides.hpp"

#include <planish/connect/codes.hpp>
#include <planish/connect/edge_search.hpp>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>

// The exact search against a search of everything, written from math.md#bend-fitting with nothing
// in common with it.

namespace planish::test {
namespace {

using Corners = std::array<std::vector<Vec2>, 2>;
using Sides = std::array<std::vector<Chain>, 2>;

struct Candidate {
  EdgeKind kind = EdgeKind::facing;
  Corners corners;
  double width = 0.0, span = 0.0, length = 0.0;
  bool single = false;
};

double shift_of(const Corners& c) {
  return std::abs(c[0].front().x() - c[1].front().x()) +
         std::abs(c[0].back().x() - c[1].back().x());
}

double span_at(const Corners& c, EdgeKind kind, double psi, double k, double q) {
  double span = shift_of(c);
  for (const auto& side : c) {
    double height = -1e300, extension = -1e300;
    for (const Vec2& p : side) {
      const double h = k * p.x() - q;
      height = std::max(height, h);
      extension = std::max(extension, kind == EdgeKind::facing ? p.y() - h : h - p.y());
    }
    span += 0.5 * psi * height + extension;
  }
  return span;
}

double length_at(const Corners& c, EdgeKind kind, double psi, double k, double q) {
  double length = shift_of(c);
  for (const auto& side : c) {
    double b = 0.0, y = 0.0;
    for (const Vec2& p : side) {
      b += (k * p.x() - q) / static_cast<double>(side.size());
      y += p.y() / static_cast<double>(side.size());
    }
    length += 0.5 * psi * b + (kind == EdgeKind::facing ? y - b : b - y);
  }
  return length;
}

/// Every vertex of the polyhedron of math.md#tangent-lines and of the kinks of the span.
template <typename Cost>
std::optional<double> least(const Corners& c, EdgeKind kind, const Cost& cost) {
  std::vector<Vec2> points;
  for (const auto& side : c)
    for (const Vec2& p : side) {
      points.push_back(p);
      points.emplace_back(p.x(), 0.0);
    }
  std::vector<double> slopes{0.0};
  for (const Vec2& a : points)
    for (const Vec2& b : points)
      if (std::abs(a.x() - b.x()) > 1e-9) slopes.push_back((a.y() - b.y()) / (a.x() - b.x()));
  std::optional<double> best;
  for (const double k : slopes)
    for (const Vec2& at : points) {
      const double q = k * at.x() - at.y();
      bool feasible = true;
      for (const auto& side : c)
        for (const Vec2& p : side) {
          const double h = k * p.x() - q;
          if (h < -1e-9 || (kind == EdgeKind::facing ? h > p.y() + 1e-9 : h < p.y() - 1e-9))
            feasible = false;
        }
      if (!feasible) continue;
      const double value = cost(k, q);
      if (!best || value < *best) best = value;
    }
  return best;
}

std::vector<Candidate> everything(const Sides& sides, Angle beta) {
  std::vector<Candidate> all;
  for (const Chain& a : sides[0])
    for (const Chain& b : sides[1]) {
      if (a.kind != b.kind) continue;
      const double psi = arc_factor(beta, a.kind, kLinearisedSlope);
      const auto runs = [](const Chain& chain) {
        std::vector<std::vector<Vec2>> result;
        for (auto i = chain.corners.begin(); i != chain.corners.end(); ++i)
          for (auto j = i + 1; j != chain.corners.end(); ++j)
            result.emplace_back(i, j + 1);
        return result;
      };
      for (const auto& left : runs(a))
        for (const auto& right : runs(b)) {
          Candidate candidate{a.kind, {left, right}};
          const Corners& c = candidate.corners;
          const auto span = least(
              c, a.kind, [&](double k, double q) { return span_at(c, a.kind, psi, k, q); });
          if (!span) continue;
          candidate.span = *span;
          candidate.width = 0.5 * (left.back().x() - left.front().x() + right.back().x() -
                                   right.front().x());
          candidate.single = left.size() == 2 && right.size() == 2;
          if (candidate.single)
            candidate.length = *least(
                c, a.kind, [&](double k, double q) { return length_at(c, a.kind, psi, k, q); });
          all.push_back(std::move(candidate));
        }
    }
  return all;
}

const Candidate* reference_of(const std::vector<Candidate>& all) {
  const Candidate* best = nullptr;
  for (const Candidate& c : all)
    if (c.single && (best == nullptr || c.length < best->length - 1e-7 ||
                     (c.length < best->length + 1e-7 && c.width > best->width + 1e-7)))
      best = &c;
  return best;
}

const Candidate* best_of(const std::vector<Candidate>& all, const Candidate& reference,
                         double trade_off) {
  const Candidate* best = nullptr;
  for (const Candidate& c : all) {
    if (c.span - reference.span > trade_off * (c.width - reference.width) + 1e-7) continue;
    if (best == nullptr || c.width > best->width + 1e-7 ||
        (c.width > best->width - 1e-7 && c.span < best->span - 1e-7))
      best = &c;
  }
  return best;
}

void expect_optimum(const Sides& sides, Angle beta, double trade_off) {
  const std::vector<Candidate> all = everything(sides, beta);
  const auto found = search_edges(
      sides, beta, {.trade_off = trade_off, .line = {}, .edges = {}, .alternatives = 0});
  const Candidate* reference = reference_of(all);
  if (reference == nullptr) {
    EXPECT_FALSE(found);
    return;
  }
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_NEAR(found->reference_length, reference->length, 1e-7 * 200);
  EXPECT_NEAR(found->reference.width, reference->width, 1e-7 * 200);
  EXPECT_NEAR(found->reference.span, reference->span, 1e-7 * 200);
  const Candidate* best = best_of(all, *reference, trade_off);
  ASSERT_NE(best, nullptr);
  EXPECT_NEAR(found->best.width, best->width, 1e-7 * 200);
  EXPECT_NEAR(found->best.span, best->span, 1e-7 * 200);
}

Sides random_sides(std::mt19937& random, EdgeKind kind, int most) {
  std::uniform_int_distribution<int> count(1, most);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  Sides sides;
  for (auto& side : sides) {
    OutlineStyle style{count(random), 40.0 * unit(random), 0.4 * unit(random) - 0.2,
                       unit(random) < 0.4, unit(random) < 0.3};
    side = only(viable_chains(random_outline(random, style)), kind);
  }
  return sides;
}

RC_GTEST_PROP(EdgeSearch, FindsTheOptimumOfFacingEdges, ()) {
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  const double trade_off = *rc::gen::element(0.0, 0.3, 1.0, 2.0, 5.0);
  const Angle beta = Angle::degrees(*rc::gen::inRange(10, 179));
  expect_optimum(random_sides(random, EdgeKind::facing, 6), beta, trade_off);
  RC_ASSERT(!::testing::Test::HasFailure());
}

RC_GTEST_PROP(EdgeSearch, FindsTheOptimumOfAvertedEdges, ()) {
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  const double trade_off = *rc::gen::element(0.0, 0.3, 1.0, 2.0, 5.0);
  const Angle beta = Angle::degrees(*rc::gen::inRange(10, 179));
  expect_optimum(random_sides(random, EdgeKind::averted, 6), beta, trade_off);
  RC_ASSERT(!::testing::Test::HasFailure());
}

RC_GTEST_PROP(EdgeSearch, FindsTheOptimumOfWholePlates, ()) {
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  Sides sides;
  for (auto& side : sides)
    side = viable_chains(
        random_outline(random, {*rc::gen::inRange(1, 4), 30.0, 0.1, false, false}));
  expect_optimum(sides, Angle::degrees(*rc::gen::inRange(20, 170)),
                 *rc::gen::element(0.5, 1.0, 3.0));
  RC_ASSERT(!::testing::Test::HasFailure());
}

RC_GTEST_PROP(EfficientEdges, AreAllThatNoOtherChoiceSurpasses, ()) {
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  Sides sides;
  for (auto& side : sides)
    side = viable_chains(
        random_outline(random, {*rc::gen::inRange(1, 5), 30.0, 0.1, false, false}));
  const Angle beta = Angle::degrees(*rc::gen::inRange(20, 170));
  std::vector<Candidate> all = everything(sides, beta);
  std::ranges::sort(all, [](const Candidate& a, const Candidate& b) {
    return std::pair{-a.width, a.span} < std::pair{-b.width, b.span};
  });
  constexpr double kSame = 1e-6;
  std::vector<Candidate> front;
  for (const Candidate& each : all)
    if (front.empty() || each.span < front.back().span - kSame) front.push_back(each);
  const auto found = efficient_edges(sides, beta);
  RC_ASSERT(found.size() == front.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    RC_ASSERT(std::abs(found[i].width - front[i].width) < kSame);
    RC_ASSERT(std::abs(found[i].span - front[i].span) < kSame);
  }
}

RC_GTEST_PROP(EdgeSearch, DoesNotDependOnSideHandPlaceOrScale, ()) {
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  const EdgeKind kind = *rc::gen::element(EdgeKind::facing, EdgeKind::averted);
  const Angle beta = Angle::degrees(*rc::gen::inRange(10, 179));
  std::array<std::vector<Vec2>, 2> outlines{random_outline(random, {12, 40.0, 0.1, false, false}),
                                            random_outline(random, {9, 30.0, -0.1, false, false})};
  const EdgeSearchOptions options{.trade_off = 1.5, .line = {}, .edges = {}, .alternatives = 0};
  const auto search = [&](const auto& change, bool swap) {
    Sides sides;
    for (std::size_t i = 0; i < 2; ++i) {
      std::vector<Vec2> outline = outlines[i];
      for (Vec2& p : outline)
        p = change(p);
      sides[swap ? 1 - i : i] = only(viable_chains(outline), kind);
    }
    return search_edges(sides, beta, options);
  };
  const auto same = [](const Vec2& p) { return p; };
  const auto plain = search(same, false);
  const auto expect_same = [&](const Result<EdgeSearch>& other, double scale) {
    RC_ASSERT(other.has_value() == plain.has_value());
    if (!plain) return;
    RC_ASSERT(std::abs(other->best.width - scale * plain->best.width) < 1e-6 * scale);
    RC_ASSERT(std::abs(other->best.span - scale * plain->best.span) < 1e-6 * scale);
    RC_ASSERT(std::abs(other->reference_length - scale * plain->reference_length) < 1e-6 * scale);
  };
  expect_same(search(same, true), 1.0);
  expect_same(search([](const Vec2& p) { return Vec2(-p.x(), p.y()); }, false), 1.0);
  expect_same(search([](const Vec2& p) { return Vec2(p.x() + 1e5, p.y()); }, false), 1.0);
  expect_same(search([](const Vec2& p) { return Vec2(10 * p); }, false), 10.0);
}

TEST(EdgeSearch, TakesEqualEdgesAllAtOnce) {
  // Collinear edges of one length: everything fits, at no cost.
  std::vector<Vec2> outline;
  for (int i = 0; i <= 50; ++i)
    outline.emplace_back(4.0 * i, 30.0);
  outline.emplace_back(200.0, 100.0);
  outline.emplace_back(0.0, 100.0);
  const auto chains = only(viable_chains(outline), EdgeKind::facing);
  const auto found = search_edges({chains, chains}, Angle::degrees(90), {});
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->best.width, 200.0, 1e-9);
  EXPECT_NEAR(found->best.span, std::numbers::pi / 2 * 30.0, 0.02 * 47) << "Ψ̃ is at slope 0.3";
  EXPECT_NEAR(found->best.line.at(100.0), 30.0, 1e-9);
}

TEST(EdgeSearch, KeepsToEdgesThatAreGiven) {
  std::mt19937 random(7);
  const auto a = only(viable_chains(random_outline(random, {8, 20.0, 0.0, false, false})),
                      EdgeKind::facing);
  const auto b = only(viable_chains(random_outline(random, {8, 20.0, 0.0, false, false})),
                      EdgeKind::facing);
  const std::vector<int> wanted{a[0].edges[4], a[0].edges[3]};
  EdgeSearchOptions options;
  options.edges[0] = wanted;
  const auto found = search_edges({a, b}, Angle::degrees(90), options);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->best.runs[0].first, 3);
  EXPECT_EQ(found->best.runs[0].last, 4);
  options.edges[0] = std::vector{a[0].edges[2], a[0].edges[4]};
  const auto apart = search_edges({a, b}, Angle::degrees(90), options);
  ASSERT_FALSE(apart);
  EXPECT_EQ(apart.error().code, code::unknown_edge);
}

TEST(EdgeSearch, KeepsToALineThatIsGiven) {
  std::mt19937 random(11);
  const auto a = only(viable_chains(random_outline(random, {8, 20.0, 0.0, false, false})),
                      EdgeKind::facing);
  const auto b = only(viable_chains(random_outline(random, {8, 20.0, 0.0, false, false})),
                      EdgeKind::facing);
  for (const GivenLine& line :
       {GivenLine{.slope = 0.0}, GivenLine{.slope = 0.02}, GivenLine{.slope = 0.0, .offset = -10.0},
        GivenLine{.apex = -900.0}}) {
    EdgeSearchOptions options;
    options.line = line;
    const auto found = search_edges({a, b}, Angle::degrees(90), options);
    ASSERT_TRUE(found) << found.error().message;
    EXPECT_NEAR(found->best.line.slope, line.slope.value_or(found->best.line.slope), 1e-12);
    EXPECT_NEAR(found->best.line.offset, line.offset.value_or(found->best.line.offset), 1e-9);
    if (line.apex) {
      EXPECT_NEAR(found->best.line.at(*line.apex), 0.0, 1e-9);
    }
  }
  EdgeSearchOptions options;
  options.line = {.slope = 0.0, .offset = -500.0};
  const auto none = search_edges({a, b}, Angle::degrees(90), options);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code, code::no_bend_fits);
}

TEST(ViableChains, SplitsAnOutlineIntoFacingAndAvertedEdges) {
  const std::vector<Vec2> outline{{0, 30}, {50, 20}, {100, 30}, {100, 90}, {0, 90}};
  for (const bool reversed : {false, true}) {
    std::vector<Vec2> corners = outline;
    if (reversed) std::ranges::reverse(corners);
    const auto chains = viable_chains(corners);
    ASSERT_EQ(chains.size(), 2u);
    for (const Chain& chain : chains) {
      EXPECT_EQ(chain.edges.size(), chain.kind == EdgeKind::facing ? 2u : 1u);
      EXPECT_LT(chain.corners.front().x(), chain.corners.back().x());
    }
  }
}

TEST(ViableChains, LeavesOutWhatCrossesTheLineOrRunsUpright) {
  // A plate through the line: only what lies wholly above is of use.
  const std::vector<Vec2> outline{{0, -20}, {40, -20}, {60, 20}, {100, 10}, {100, 90}, {0, 90}};
  const auto chains = viable_chains(outline);
  ASSERT_EQ(chains.size(), 2u);
  EXPECT_EQ(chains[0].edges, std::vector{2});
  EXPECT_EQ(chains[0].kind, EdgeKind::facing);
  EXPECT_EQ(chains[1].edges, std::vector{4});
}

TEST(ViableChains, GoesOverTheFirstCorner) {
  const std::vector<Vec2> outline{{50, 20}, {100, 30}, {100, 90}, {0, 90}, {0, 30}};
  const auto facing = only(viable_chains(outline), EdgeKind::facing);
  ASSERT_EQ(facing.size(), 1u);
  EXPECT_EQ(facing[0].edges, (std::vector{4, 0}));
}

TEST(ArcFactor, IsTheArcOverTheHeight) {
  const double beta = 1.1, alpha = std::numbers::pi - beta;
  EXPECT_NEAR(arc_factor(Angle::radians(beta), EdgeKind::facing, 0.0), alpha / std::tan(alpha / 2),
              1e-12);
  EXPECT_NEAR(arc_factor(Angle::radians(beta), EdgeKind::facing, 1e-6), alpha / std::tan(alpha / 2),
              1e-9);
  // A circle about the cone's axis, from tangent line to tangent line, measured in space.
  const double k = 0.3, phi = std::atan(k), tangent = std::tan(beta / 2);
  const double omega = std::atan(std::sin(phi) * tangent);
  const Vec3 e1(0, std::sin(beta / 2), std::cos(beta / 2)),
      e2(0, -std::sin(beta / 2), std::cos(beta / 2));
  const Vec3 g1 = Vec3(std::cos(phi), 0, 0) + std::sin(phi) * e1,
             g2 = Vec3(std::cos(phi), 0, 0) + std::sin(phi) * e2;
  // The axis makes the angle ω with both rulings, in the plane between them.
  const double psi = std::atan(std::tan(phi) / std::cos(beta / 2));
  const Vec3 a(std::cos(psi), 0, std::sin(psi));
  EXPECT_NEAR(std::acos(a.dot(g1)), omega, 1e-9);
  EXPECT_NEAR(std::acos(a.dot(g2)), omega, 1e-9);
  const Vec3 r1 = g1 - g1.dot(a) * a, r2 = g2 - g2.dot(a) * a;
  const double turn = std::acos(r1.dot(r2) / (r1.norm() * r2.norm()));
  // Height of the ends above the line: sin φ for rulings of length one.
  EXPECT_NEAR(arc_factor(Angle::radians(beta), EdgeKind::facing, k),
              turn * r1.norm() / std::sin(phi), 1e-9);
  EXPECT_NEAR(arc_factor(Angle::radians(beta), EdgeKind::averted, k),
              (2 * std::numbers::pi - turn) * r1.norm() / std::sin(phi), 1e-9);
}

RC_GTEST_PROP(SmallestExtension, IsTheLeastOfAllVertices, ()) {
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  const EdgeKind kind = *rc::gen::element(EdgeKind::facing, EdgeKind::averted);
  const Sides sides = random_sides(random, kind, 9);
  const Corners corners{sides[0].front().corners, sides[1].front().corners};
  const auto fit = smallest_extension(corners, kind);
  const auto brute = least(corners, kind, [&](double k, double q) {
    return extension_area(corners, kind, {k, q});
  });
  RC_ASSERT(fit.has_value() == brute.has_value());
  if (!brute) return;
  RC_ASSERT(std::abs(fit->area - *brute) <= 1e-9 * std::max(1.0, *brute) + 1e-6);
  RC_ASSERT(fit->area >= 0.0);
  RC_ASSERT(std::abs(extension_area(corners, kind, fit->line) - fit->area) < 1e-6);
}

TEST(SmallestExtension, TakesTheLevelLineWhereOthersAreAsGood) {
  // A tip in the middle: every line through it costs the same.
  const std::vector<Vec2> tip{{0, 40}, {50, 20}, {100, 40}};
  const auto fit = smallest_extension({tip, tip}, EdgeKind::facing);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->line.slope, 0.0, 1e-12);
  EXPECT_NEAR(fit->area, 2 * 1000.0, 1e-9);
}

TEST(FeasibleLines, AreThoseBetweenThePlateAndTheIntersectionLine) {
  const std::vector<Vec2> side{{100, 20}, {200, 60}};
  const auto slopes = feasible_slopes({side, side}, EdgeKind::facing);
  ASSERT_TRUE(slopes);
  EXPECT_NEAR(slopes->low, -0.2, 1e-9);
  EXPECT_NEAR(slopes->high, 0.6, 1e-9);
  const auto offsets = feasible_offsets({side, side}, EdgeKind::facing, 0.1);
  ASSERT_TRUE(offsets);
  EXPECT_NEAR(offsets->low, -10.0, 1e-9);
  EXPECT_NEAR(offsets->high, 10.0, 1e-9);
}

}  // namespace
}  // namespace planish::test
