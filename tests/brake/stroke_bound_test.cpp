#include "stroke_bound.hpp"

#include "brake/stroke_tables.hpp"

#include <gtest/gtest.h>

#include <random>

namespace planish::test {
namespace {

using namespace brake_detail;

constexpr double kNever = std::numeric_limits<double>::infinity();

/// What is possible anywhere, whatever stages allow: each line alone, in random set-ups.
struct FreeStrokes {
  int lines = 0;
  std::vector<StrokeChoice> possible;

  StrokeProblem problem() const {
    StrokeProblem problem;
    problem.lines = lines;
    problem.choices = [](const LineSet&) { return std::vector<StrokeChoice>(); };
    problem.possible = possible;
    return problem;
  }
};

FreeStrokes free_strokes(std::mt19937& random, int lines, unsigned punches = 3) {
  FreeStrokes made{lines, {}};
  for (int line = 0; line < lines; ++line) {
    const int ways = 1 + static_cast<int>(random() % 3);
    for (int way = 0; way < ways; ++way)
      made.possible.push_back({{std::uint64_t{1} << line},
                               static_cast<int>(random() % punches),
                               static_cast<int>(random() % 2 * (punches - 1)),
                               random() % 2 == 0,
                               static_cast<int>(random() % 3),
                               random() % 3 != 0});
  }
  return made;
}

/// By stage and set-up what is left costs at least: from the last stage back.
std::vector<std::map<SetUpKey, double>> least_costs(const FreeStrokes& free,
                                                    const StrokeWeights& weights) {
  const std::size_t stages = std::size_t{1} << free.lines;
  std::set<SetUpKey> keys;
  for (const StrokeChoice& choice : free.possible)
    keys.insert(set_up_of(choice));
  std::vector<std::map<SetUpKey, double>> least(stages);
  for (std::size_t stage = stages; stage-- > 0;)
    for (const SetUpKey& from : keys) {
      double cost = stage + 1 == stages ? 0.0 : kNever;
      for (const StrokeChoice& choice : free.possible) {
        if (choice.lines[0] & stage) continue;
        const SetUpKey to = set_up_of(choice);
        cost = std::min(cost, change_cost(from, to, weights) + stroke_cost(choice, weights) +
                                  least[stage | choice.lines[0]][to]);
      }
      least[stage][from] = cost;
    }
  return least;
}

/// Where strokes never exclude each other the bound is what they cost: from the start of each
/// stage, and with one pair of tools from each set-up. (Tools that are never better count as
/// those.)
TEST(StrokeBound, IsExactWhereStrokesDoNotExcludeEachOther) {
  std::mt19937 random(12);
  for (int run = 0; run < 150; ++run) {
    const bool one_pair = run % 2 == 0;
    const FreeStrokes free = free_strokes(random, 1 + run % 6, one_pair ? 1 : 3);
    const auto weight = [&] { return 0.5 * static_cast<double>(random() % 9); };
    const StrokeWeights weights{weight(), weight(), weight(), weight(), weight()};
    const auto least = least_costs(free, weights);
    const StrokeProblem problem = free.problem();
    StrokeBound bound(problem, weights);
    EXPECT_TRUE(bound.hopeless().empty());
    for (std::size_t stage = 0; stage < least.size(); ++stage) {
      double cheapest = kNever;
      for (const auto& [from, cost] : least[stage]) {
        const auto& [punch, die, side, direction] = from;
        const brake_detail::SetUp set_up{punch, die, side, direction};
        const double told = bound(LineSet{stage}, &set_up);
        EXPECT_LE(told, cost + 1e-9) << run << " " << stage;
        if (one_pair) {
          EXPECT_GE(told, cost - 1e-9) << run << " " << stage;
        }
        cheapest = std::min(cheapest, cost);
      }
      EXPECT_NEAR(bound(LineSet{stage}, nullptr), cheapest, 1e-9);
    }
  }
}

/// Of lines pressed together each bears its share; several for one cost no more than each alone.
TEST(StrokeBound, SharesTheCostOfLinesPressedTogether) {
  FreeStrokes free{3, {{{0b111}, 0, 0, true, 0, true}}};
  StrokeBound bound(free.problem(), {});
  EXPECT_NEAR(bound({0}, nullptr), 1.0, 1e-12);
  EXPECT_NEAR(bound({0b001}, nullptr), 2.0 / 3.0, 1e-12);
  free.possible.push_back({{0b001}, 1, 0, true, 0, true});
  StrokeBound with_more(free.problem(), {});
  EXPECT_NEAR(with_more({0}, nullptr), 1.0, 1e-12);
}

/// More classes than tours visit: lines each of which has a side, direction and tools of its own
/// take a change of the tools each, and what else changes on the way.
TEST(StrokeBound, CountsTheChangesOfManyClasses) {
  constexpr int kMany = 14;
  FreeStrokes tools{kMany, {}}, directions{kMany, {}};
  for (int line = 0; line < kMany; ++line) {
    tools.possible.push_back({{std::uint64_t{1} << line}, line, 0, true, 0, true});
    directions.possible.push_back({{std::uint64_t{1} << line}, 0, 0, true, line, false});
  }
  const StrokeWeights weights;
  StrokeBound by_tools(tools.problem(), weights), by_directions(directions.problem(), weights);
  EXPECT_NEAR(by_tools({0}, nullptr), kMany * weights.stroke + (kMany - 1) * weights.tool_change,
              1e-9);
  EXPECT_NEAR(by_directions({0}, nullptr),
              kMany * (weights.stroke + weights.ungauged) + (kMany - 1) * weights.rotate, 1e-9);
  // From one of their set-ups, with that line formed, each of the others takes a change.
  const brake_detail::SetUp first{0, 0, true, 0};
  EXPECT_NEAR(by_tools({1}, &first), (kMany - 1) * (weights.stroke + weights.tool_change), 1e-9);
}

/// Never more than what strokes cost that are free in every stage, with many classes too.
TEST(StrokeBound, IsNeverMoreThanTheCost) {
  std::mt19937 random(21);
  for (int run = 0; run < 6; ++run) {
    const FreeStrokes free = free_strokes(random, 10);
    const auto least = least_costs(free, {});
    const StrokeProblem problem = free.problem();
    StrokeBound bound(problem, {});
    for (std::size_t stage = 0; stage < least.size(); stage += 7)
      for (const auto& [from, cost] : least[stage]) {
        const auto& [punch, die, side, direction] = from;
        const brake_detail::SetUp set_up{punch, die, side, direction};
        EXPECT_LE(bound(LineSet{stage}, &set_up), cost + 1e-9);
        EXPECT_GE(bound(LineSet{stage}, &set_up), 10.0 - count({stage}));
      }
  }
}

TEST(StrokeBound, NamesLinesThatAreLeftWithoutAWay) {
  FreeStrokes free{3, {}};
  for (int line = 0; line < 3; ++line)
    free.possible.push_back({{std::uint64_t{1} << line}, 0, 0, true, 0, true});
  const StrokeProblem problem = free.problem();
  StrokeBound bound(problem, {}, {1});
  EXPECT_EQ(bound.hopeless(), std::vector<int>{1});
  EXPECT_EQ(bound({0}, nullptr), kNever);
  // Nothing known: a stroke for what is left, and none for nothing.
  StrokeProblem unknown = problem;
  unknown.possible.clear();
  StrokeBound least(unknown, {});
  EXPECT_EQ(least({0}, nullptr), 1.0);
  EXPECT_EQ(least({0b111}, nullptr), 0.0);
}

}  // namespace
}  // namespace planish::test
