#include "stage_book.hpp"

#include "brake/stroke_tables.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace planish::test {
namespace {

using namespace brake_detail;

struct Rule {
  std::uint64_t lines = 0, formed = 0;  ///< infeasible where these are formed like this
};

/// One way for each line, infeasible by rules; counts what is asked.
struct Ruled {
  int lines = 0;
  std::vector<std::vector<Rule>> rules;
  std::map<std::pair<std::uint64_t, int>, int> asked = {};
  std::map<std::uint64_t, int> listed = {};

  const Rule* met(int line, std::uint64_t stage) const {
    for (const Rule& rule : rules[line])
      if ((stage & rule.lines) == rule.formed) return &rule;
    return nullptr;
  }
  static StrokeChoice way(int line) { return {{std::uint64_t{1} << line}, 0, 0, true, 0, true}; }
  StrokeProblem problem() {
    StrokeProblem problem;
    problem.lines = lines;
    for (int line = 0; line < lines; ++line)
      problem.possible.push_back(way(line));
    problem.choices = [this](const LineSet& formed) {
      ++listed[formed[0]];
      std::vector<StrokeChoice> choices;
      for (int line = 0; line < lines; ++line)
        if (!holds(formed, line)) choices.push_back(way(line));
      return choices;
    };
    problem.check = [this](const LineSet& formed, const StrokeChoice& choice) {
      const int line = first_line(choice.lines);
      ++asked[{formed[0], line}];
      const Rule* rule = met(line, formed[0]);
      return rule ? StrokeVerdict{false, LineSet{rule->lines}} : StrokeVerdict{};
    };
    return problem;
  }
};

Ruled random_rules(std::mt19937& random, int lines) {
  Ruled ruled{lines, std::vector<std::vector<Rule>>(lines)};
  for (int line = 0; line < lines; ++line)
    for (std::size_t i = random() % 6; i > 0; --i) {
      const std::uint64_t others = random() % (1u << lines) & random() & ~(1u << line);
      ruled.rules[line].push_back({others, others & random()});
    }
  return ruled;
}

/// Looked at in every stage, an offer is what its rules say; nothing is asked twice; a line is
/// refuted exactly if some rule holds in each stage without it.
TEST(StageBook, LearnsWhatRulesHold) {
  std::mt19937 random(31);
  int refuted = 0, blocked = 0;
  for (int run = 0; run < 120; ++run) {
    Ruled ruled = random_rules(random, 5);
    const StrokeProblem problem = ruled.problem();
    StageBook book(problem, {});
    for (int again = 0; again < 2; ++again)
      for (std::uint64_t stage = 0; stage < 32; ++stage) {
        const int number = book.stage_of({stage});
        EXPECT_EQ(book.is_full(number), stage == 31);
        if (book.is_full(number)) continue;
        for (std::size_t i = 0; i < book.offers(number).size(); ++i) {
          const int line = first_line(book.choice(book.offers(number)[i].choice).choice.lines);
          EXPECT_EQ(book.feasible(number, i), !ruled.met(line, stage)) << run;
        }
      }
    for (const auto& [question, times] : ruled.asked)
      EXPECT_EQ(times, 1);
    for (const auto& [stage, times] : ruled.listed)
      EXPECT_EQ(times, 1);
    EXPECT_EQ(count(book.furthest()), 5);
    for (int line = 0; line < 5; ++line) {
      bool everywhere = true, possible = false;
      for (std::uint64_t stage = 0; stage < 32; ++stage) {
        if (stage >> line & 1) continue;
        everywhere = everywhere && ruled.met(line, stage);
        possible = possible || !ruled.met(line, stage);
      }
      EXPECT_EQ(book.is_refuted(Ruled::way(line)), everywhere);
      EXPECT_EQ(book.seen(line), possible);
      refuted += everywhere ? 1 : 0;
    }
    // From a dead stage nothing leads to the end: by all orders.
    for (std::uint64_t stage = 0; stage < 32; ++stage) {
      if (!book.is_dead({stage})) continue;
      ++blocked;
      std::vector<bool> reached(32, false);
      reached[stage] = true;
      for (std::uint64_t at = stage; at < 32; ++at)
        for (int line = 0; line < 5 && reached[at]; ++line)
          if (!(at >> line & 1) && !ruled.met(line, at)) reached[at | 1u << line] = true;
      EXPECT_FALSE(reached[31]) << run << " " << stage;
    }
  }
  EXPECT_GT(refuted, 5);
  EXPECT_GT(blocked, 100);
}

TEST(StageBook, ReckonsChangesBetweenSetUps) {
  StrokeProblem problem;
  problem.lines = 1;
  problem.choices = [](const LineSet&) { return std::vector<StrokeChoice>(); };
  const StrokeWeights weights{3, 5, 7, 11, 13};
  StageBook book(problem, weights);
  std::mt19937 random(2);
  const auto any = [&] {
    return brake_detail::SetUp{static_cast<int>(random() % 2), static_cast<int>(random() % 2),
                               random() % 2 == 0, static_cast<int>(random() % 2)};
  };
  for (int run = 0; run < 200; ++run) {
    const brake_detail::SetUp a = any(), b = any();
    const int from = book.set_up_of(a), to = book.set_up_of(b);
    EXPECT_EQ(book.set_up(from), a);
    EXPECT_EQ(from == to, a == b);
    EXPECT_EQ(book.change(from, to),
              change_cost({a.punch, a.die, a.reference_up, a.direction},
                          {b.punch, b.die, b.reference_up, b.direction}, weights));
    EXPECT_EQ(book.change(kNoSetUp, to), 0.0);
  }
}

TEST(StageBook, MarksStagesDead) {
  Ruled ruled{2, std::vector<std::vector<Rule>>(2)};
  const StrokeProblem problem = ruled.problem();
  StageBook book(problem, {});
  EXPECT_FALSE(book.find({1}));
  const int stage = book.stage_of({1});
  EXPECT_EQ(book.find({1}), std::optional<int>(stage));
  EXPECT_FALSE(book.is_dead({1}));
  book.mark_dead(stage);
  EXPECT_TRUE(book.is_dead({1}));
  EXPECT_FALSE(book.is_dead({2}));
}

}  // namespace
}  // namespace planish::test
