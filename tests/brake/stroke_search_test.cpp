#include "brake/random_table.hpp"

#include <planish/brake/stroke_search.hpp>

#include <gtest/gtest.h>

#include <chrono>
#include <numeric>

namespace planish {
namespace {

using test::RandomTable;
using test::StrokeTable;

double cost_of(const std::vector<StrokeChoice>& strokes, const StrokeWeights& w) {
  double cost = 0.0;
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    if (i > 0)
      cost += test::change_cost(test::set_up_of(strokes[i - 1]), test::set_up_of(strokes[i]), w);
    cost += test::stroke_cost(strokes[i], w);
  }
  return cost;
}

/// Whether each stroke is one that the table has in its stage, and all lines are formed at the end.
bool can_be_made(const std::vector<StrokeChoice>& strokes, const StrokeTable& table) {
  std::size_t stage = 0;
  for (const StrokeChoice& stroke : strokes) {
    const bool there = std::ranges::any_of(table.by_stage[stage], [&](const StrokeChoice& one) {
      return one.lines == stroke.lines && one.gauged == stroke.gauged &&
             test::set_up_of(one) == test::set_up_of(stroke);
    });
    if (!there) return false;
    stage |= stroke.lines[0];
  }
  return stage == table.full();
}

struct Seen {
  int optimal = 0, infeasible = 0, with_changes = 0, grouped = 0;
};

void hold_against_table(const StrokeProblem& problem, const StrokeTable& table,
                        const StrokeWeights& w, Seen& seen) {
  const auto found = search_strokes(problem, w);
  ASSERT_TRUE(found);
  const auto cheapest = test::cheapest_by_table(table, w);
  ASSERT_EQ(found->status, cheapest ? PlanStatus::optimal : PlanStatus::infeasible);
  if (!cheapest) {
    ++seen.infeasible;
    EXPECT_TRUE(found->strokes.empty());
    EXPECT_TRUE(found->blocked_all);
    EXPECT_EQ(found->blocked, test::blocked_by_table(table));
    return;
  }
  ++seen.optimal;
  EXPECT_NEAR(found->cost, *cheapest, 1e-9);
  EXPECT_NEAR(cost_of(found->strokes, w), *cheapest, 1e-9);
  EXPECT_TRUE(can_be_made(found->strokes, table));
  const double told = w.turn_over * found->turn_overs + w.rotate * found->rotations +
                      w.tool_change * found->tool_changes + w.ungauged * found->ungauged +
                      w.stroke * static_cast<double>(found->strokes.size()) + w.v * found->v_away;
  EXPECT_NEAR(told, *cheapest, 1e-9);
  seen.with_changes += found->turn_overs + found->rotations + found->tool_changes > 0 ? 1 : 0;
  seen.grouped += static_cast<int>(found->strokes.size()) < table.lines ? 1 : 0;
}

TEST(SearchStrokes, TheTwoBruteForcesAgree) {
  int plans = 0;
  for (unsigned seed = 1; seed <= 300; ++seed) {
    const RandomTable random(seed, {.most_lines = 4, .punches = 2, .dies = 1, .feasible = 0.25});
    const auto by_table = test::cheapest_by_table(random.table(), {});
    const auto by_orders = test::cheapest_by_orders(random.table(), {});
    ASSERT_EQ(by_table.has_value(), by_orders.has_value()) << seed;
    EXPECT_NEAR(by_table.value_or(0.0), by_orders.value_or(0.0), 1e-9) << seed;
    plans += by_table ? 1 : 0;
  }
  EXPECT_GT(plans, 50);
  EXPECT_LT(plans, 250);
}

TEST(SearchStrokes, FindsTheCheapestPlanOfRandomTables) {
  Seen seen;
  for (unsigned seed = 1; seed <= 4000; ++seed) {
    const double feasible = std::array{0.06, 0.12, 0.25, 0.6}[seed % 4];
    const RandomTable random(seed, {.feasible = feasible, .sides_fixed = seed % 3 != 0});
    StrokeProblem problem = random.problem();
    if (seed % 5 != 0) problem.possible = random.possible();
    if (seed % 5 != 0 && problem.possible.empty()) continue;
    SCOPED_TRACE(seed);
    hold_against_table(problem, random.table(), {}, seen);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(seen.optimal, 1000);
  EXPECT_GT(seen.infeasible, 300);
  EXPECT_GT(seen.with_changes, 1000);
  EXPECT_GT(seen.grouped, 500);
}

TEST(SearchStrokes, FindsTheCheapestPlanForAnyWeights) {
  Seen seen;
  for (unsigned seed = 1; seed <= 1000; ++seed) {
    const RandomTable random(seed, {.most_lines = 6, .directions = 4, .feasible = 0.2});
    std::mt19937 dice(seed);
    const auto weight = [&] { return 0.5 * std::uniform_int_distribution<int>(0, 8)(dice); };
    const StrokeWeights w{weight(), weight(), weight(), weight(), weight()};
    StrokeProblem problem = random.problem();
    problem.possible = random.possible();
    SCOPED_TRACE(seed);
    hold_against_table(problem, random.table(), w, seen);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(seen.optimal, 300);
}

/// A stroke is infeasible in stages that agree with one of its clauses.
struct Clause {
  std::uint64_t lines = 0, formed = 0;
};

class ClauseProblem {
 public:
  ClauseProblem(unsigned seed, int lines) : random_(seed), most_clauses_(2 + seed % 16) {
    table_.lines = lines;
    for (int line = 0; line < lines; ++line)
      for (int set_up = 0; set_up < 4; ++set_up)
        rows_.push_back({choice(line, set_up), clauses(line)});
    table_.by_stage.resize(std::size_t{1} << lines);
    for (std::size_t stage = 0; stage + 1 < table_.stages(); ++stage)
      for (const Row& row : rows_)
        if (!(stage & row.choice.lines[0]) && !met(row, stage))
          table_.by_stage[stage].push_back(row.choice);
  }

  const StrokeTable& table() const { return table_; }

  StrokeProblem problem() {
    StrokeProblem problem;
    problem.lines = table_.lines;
    for (const Row& row : rows_)
      problem.possible.push_back(row.choice);
    problem.choices = [this](const LineSet& formed) {
      const bool fresh = stages_asked_.insert(formed[0]).second;
      EXPECT_TRUE(fresh || lacks_one(formed)) << "a stage is asked for twice";
      std::vector<StrokeChoice> choices;
      for (const Row& row : rows_)
        if (!(row.choice.lines[0] & formed[0])) choices.push_back(row.choice);
      return choices;
    };
    problem.check = [this](const LineSet& formed, const StrokeChoice& choice) {
      const auto row = std::ranges::find_if(rows_, [&](const Row& one) {
        return one.choice.lines == choice.lines && one.choice.punch == choice.punch &&
               one.choice.direction == choice.direction;
      });
      const bool fresh = asked_.insert({formed[0], row - rows_.begin()}).second;
      EXPECT_TRUE(fresh || lacks_one(formed)) << "asked twice";
      const Clause* clause = met(*row, formed[0]);
      return clause ? StrokeVerdict{false, LineSet{clause->lines}} : StrokeVerdict{};
    };
    return problem;
  }

  std::size_t asked() const { return asked_.size(); }

 private:
  struct Row {
    StrokeChoice choice;
    std::vector<Clause> clauses;
  };

  bool lacks_one(const LineSet& formed) const {
    return std::popcount(formed[0]) == table_.lines - 1;
  }

  int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(random_); }

  static StrokeChoice choice(int line, int set_up) {
    return {{std::uint64_t{1} << line}, set_up / 2, 0, line % 2 == 0, set_up % 2};
  }

  std::vector<Clause> clauses(int line) {
    std::vector<Clause> all;
    const int number = below(most_clauses_);
    for (int i = 0; i < number; ++i) {
      Clause clause;
      for (int k = below(4); k > 0; --k) {
        const std::uint64_t bit = std::uint64_t{1} << below(table_.lines);
        if (bit >> line & 1) continue;
        clause.lines |= bit;
        clause.formed |= below(2) == 0 ? bit : 0;
      }
      clause.formed &= clause.lines;
      if (clause.lines != 0 || below(3) == 0) all.push_back(clause);
    }
    return all;
  }

  static const Clause* met(const Row& row, std::uint64_t formed) {
    for (const Clause& clause : row.clauses)
      if ((formed & clause.lines) == clause.formed) return &clause;
    return nullptr;
  }

  std::mt19937 random_;
  int most_clauses_;
  StrokeTable table_;
  std::vector<Row> rows_;
  std::set<std::uint64_t> stages_asked_;
  std::set<std::pair<std::uint64_t, std::ptrdiff_t>> asked_;
};

TEST(SearchStrokes, LearnsFromWhyAStrokeIsInfeasible) {
  Seen seen;
  for (unsigned seed = 1; seed <= 2000; ++seed) {
    ClauseProblem random(seed, 1 + static_cast<int>(seed % 7));
    SCOPED_TRACE(seed);
    hold_against_table(random.problem(), random.table(), {}, seen);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(seen.optimal, 500);
  EXPECT_GT(seen.infeasible, 200);
}

/// Lines that never exclude each other; `set_ups` are possible for each.
StrokeProblem permissive(int lines, std::function<std::vector<StrokeChoice>(int line)> set_ups) {
  StrokeProblem problem;
  problem.lines = lines;
  for (int line = 0; line < lines; ++line)
    for (const StrokeChoice& choice : set_ups(line))
      problem.possible.push_back(choice);
  problem.choices = [all = problem.possible](const LineSet& formed) {
    std::vector<StrokeChoice> left;
    for (const StrokeChoice& choice : all)
      if ((choice.lines[0] & formed[0]) == 0) left.push_back(choice);
    return left;
  };
  return problem;
}

LineSet one_line(int line) { return {std::uint64_t{1} << line}; }

TEST(SearchStrokes, OrdersAStaircaseOfFortyBendsAtOnce) {
  // Up and down in turns, either edge to the gauge: all of one side, one turn over, all of the
  // other.
  const StrokeProblem problem = permissive(40, [](int line) {
    return std::vector<StrokeChoice>{{one_line(line), 0, 0, line % 2 == 0, 0},
                                     {one_line(line), 0, 0, line % 2 == 0, 1}};
  });
  const auto found = search_strokes(problem);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->status, PlanStatus::optimal);
  EXPECT_EQ(found->cost, 40 * 1.0 + 3.0);
  EXPECT_EQ(found->turn_overs, 1);
  EXPECT_LE(found->stages, 41);
}

TEST(SearchStrokes, KnowsTheShortestTourOfABoxBentBothWays) {
  // Four directions, two sides: up bends along both axes and down bends along both axes take one
  // turning over, and a rotation on each side.
  const StrokeProblem problem = permissive(20, [](int line) {
    const int axis = line / 2 % 2;
    return std::vector<StrokeChoice>{{one_line(line), 0, 0, line % 2 == 0, axis},
                                     {one_line(line), 0, 0, line % 2 == 0, axis + 2}};
  });
  const auto found = search_strokes(problem);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->status, PlanStatus::optimal);
  EXPECT_EQ(found->turn_overs, 1);
  EXPECT_EQ(found->rotations, 2);
  EXPECT_EQ(found->cost, 20.0 + 3.0 + 2 * 2.0);
}

TEST(SearchStrokes, CountsTheDirectionsOfPressLines) {
  const StrokeProblem problem = permissive(30, [](int line) {
    return std::vector<StrokeChoice>{{one_line(line), 0, 0, true, line, false}};
  });
  const auto found = search_strokes(problem);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->status, PlanStatus::optimal);
  EXPECT_EQ(found->cost, 30 * (1.0 + 4.0) + 29 * 2.0);
}

TEST(SearchStrokes, CountsAChangeOfBothToolsOnce) {
  StrokeProblem problem = permissive(2, [](int line) {
    return std::vector<StrokeChoice>{{one_line(line), line, line}};
  });
  EXPECT_EQ(search_strokes(problem)->cost, 2.0 + 5.0);
  EXPECT_EQ(search_strokes(problem)->tool_changes, 1);
}

TEST(SearchStrokes, TakesTheFirstStrokeWithoutAChange) {
  const StrokeProblem problem = permissive(1, [](int line) {
    return std::vector<StrokeChoice>{{one_line(line), 7, 3, false, 5}};
  });
  const auto found = search_strokes(problem);
  EXPECT_EQ(found->cost, 1.0);
  EXPECT_EQ(found->turn_overs + found->rotations + found->tool_changes, 0);
}

TEST(SearchStrokes, NeedsNoStrokesForNoLines) {
  const auto found = search_strokes(permissive(0, nullptr));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->status, PlanStatus::optimal);
  EXPECT_EQ(found->cost, 0.0);
}

/// A chain in which line i is blocked once line i + 1 is formed, so only one order is left.
StrokeProblem chain(int lines) {
  StrokeProblem problem = permissive(lines, [](int line) {
    return std::vector<StrokeChoice>{{one_line(line), 0, 0, true, 0}};
  });
  problem.check = [lines](const LineSet& formed, const StrokeChoice& choice) -> StrokeVerdict {
    const int line = std::countr_zero(choice.lines[0]);
    if (line + 1 == lines || (formed[0] >> (line + 1) & 1) == 0) return {};
    return {false, one_line(line + 1)};
  };
  return problem;
}

TEST(SearchStrokes, FindsTheOnlyOrderOfAChain) {
  const auto found = search_strokes(chain(40));
  ASSERT_TRUE(found);
  ASSERT_EQ(found->status, PlanStatus::optimal);
  for (int i = 0; i < 40; ++i)
    EXPECT_EQ(found->strokes[i].lines, one_line(i));
}

/// Each line may come only after some others, all of them before it in a hidden order; the lines
/// lie on two axes, and half of them are bent the other way.
StrokeProblem with_precedence(int lines, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<int> hidden(lines);
  std::iota(hidden.begin(), hidden.end(), 0);
  std::shuffle(hidden.begin(), hidden.end(), random);
  std::vector<std::uint64_t> before(lines, 0);
  for (int i = 1; i < lines; ++i)
    for (int k = 0; k < 2; ++k)
      before[hidden[i]] |= std::uint64_t{1}
                           << hidden[std::uniform_int_distribution<int>(0, i - 1)(random)];
  StrokeProblem problem = permissive(lines, [](int line) {
    const int axis = line / 2 % 2;
    return std::vector<StrokeChoice>{{one_line(line), 0, 0, line % 3 == 0, axis},
                                     {one_line(line), 0, 0, line % 3 == 0, axis + 2}};
  });
  problem.check = [before](const LineSet& formed, const StrokeChoice& choice) -> StrokeVerdict {
    const std::uint64_t missing = before[std::countr_zero(choice.lines[0])] & ~formed[0];
    if (missing == 0) return {};
    return {false, LineSet{missing & -missing}};
  };
  return problem;
}

TEST(SearchStrokes, OrdersFortyLinesThatWaitForOthersWithinSeconds) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const auto begin = std::chrono::steady_clock::now();
    const auto found = search_strokes(with_precedence(40, seed), {}, {.seconds = 1.0});
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    ASSERT_TRUE(found);
    EXPECT_EQ(found->strokes.size(), 40u);
    EXPECT_LT(took.count(), 2.0);
    EXPECT_LE(found->bound, found->cost);
  }
}

TEST(SearchStrokes, NamesALineThatNothingCanFormAmongMany) {
  StrokeProblem problem = permissive(30, [](int line) {
    return std::vector<StrokeChoice>{{one_line(line), 0, 0, true, 0},
                                     {one_line(line), 0, 0, true, 1}};
  });
  problem.check = [](const LineSet&, const StrokeChoice& choice) -> StrokeVerdict {
    if (choice.lines == one_line(17)) return {false, LineSet{0}};
    return {};
  };
  const auto found = search_strokes(problem);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->status, PlanStatus::infeasible);
  EXPECT_EQ(found->blocked, std::vector{17});
  EXPECT_TRUE(found->blocked_all);
  EXPECT_LE(found->stages, 31);
  EXPECT_EQ(found->furthest[0], ((std::uint64_t{1} << 30) - 1) & ~(std::uint64_t{1} << 17));
}

TEST(SearchStrokes, ProvesThatTwoLinesExcludeEachOther) {
  StrokeProblem problem = permissive(
      3, [](int line) { return std::vector<StrokeChoice>{{one_line(line)}}; });
  problem.check = [](const LineSet& formed, const StrokeChoice& choice) -> StrokeVerdict {
    const std::uint64_t both = 3;
    return {(choice.lines[0] & both) == 0 || (formed[0] & both) == 0, {}};
  };
  const auto found = search_strokes(problem);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->status, PlanStatus::infeasible);
  EXPECT_TRUE(found->blocked.empty());
  EXPECT_EQ(std::popcount(found->furthest[0]), 2);
}

TEST(SearchStrokes, BeginsAsItIsTold) {
  StrokeProblem problem = permissive(5, [](int line) {
    return std::vector<StrokeChoice>{{one_line(line), 0, 0, line % 2 == 0}};
  });
  problem.begin_with = {2, 1};
  const auto found = search_strokes(problem);
  ASSERT_TRUE(found);
  ASSERT_EQ(found->status, PlanStatus::optimal);
  EXPECT_EQ(found->strokes[0].lines, one_line(2));
  EXPECT_EQ(found->strokes[1].lines, one_line(1));
  EXPECT_EQ(found->turn_overs, 2);  // lines 2; 1, 3; 0, 4
}

TEST(SearchStrokes, BeginsAsItIsToldInRandomTables) {
  int constrained = 0;
  for (unsigned seed = 1; seed <= 500; ++seed) {
    const RandomTable random(seed, {.most_lines = 6, .feasible = 0.4});
    StrokeTable table = random.table();
    std::mt19937 dice(seed);
    std::vector<int> order(table.lines);
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), dice);
    order.resize(std::min(table.lines, 2));
    const auto free = test::cheapest_by_table(table, {});
    for (std::size_t stage = 0; stage < table.stages(); ++stage)
      std::erase_if(table.by_stage[stage], [&](const StrokeChoice& choice) {
        for (const int line : order)
          if (!(stage >> line & 1)) return !(choice.lines[0] >> line & 1);
        return false;
      });
    StrokeProblem problem = random.problem();
    problem.possible = random.possible();
    problem.begin_with = order;
    Seen seen;
    SCOPED_TRACE(seed);
    hold_against_table(problem, table, {}, seen);
    constrained += free != test::cheapest_by_table(table, {}) ? 1 : 0;
  }
  EXPECT_GT(constrained, 100);
}

TEST(SearchStrokes, GivesTheBestFoundWhenALimitEndsIt) {
  // Tools that are possible everywhere in principle, but each line takes its own in the end: the
  // bound cannot know, and 2^24 stages are too many.
  StrokeProblem problem = permissive(24, [](int line) {
    std::vector<StrokeChoice> all;
    for (int tool = 0; tool < 6; ++tool)
      all.push_back({one_line(line), tool, 0, true, line % 2});
    return all;
  });
  problem.check = [](const LineSet& formed, const StrokeChoice& choice) -> StrokeVerdict {
    const int line = std::countr_zero(choice.lines[0]);
    return {(line * 7 + std::popcount(formed[0])) % 6 == choice.punch, {}};
  };
  const auto found = search_strokes(problem, {}, {.stages = 3000, .seconds = 1.0});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->status, PlanStatus::feasible);
  EXPECT_EQ(found->strokes.size(), 24u);
  EXPECT_LT(found->bound, found->cost);
}

TEST(SearchStrokes, GivesUpWithoutAPlanWhenALimitEndsIt) {
  // Only the last stroke but one turns out to be impossible.
  StrokeProblem problem = permissive(
      24, [](int line) { return std::vector<StrokeChoice>{{one_line(line)}}; });
  problem.check = [](const LineSet& formed, const StrokeChoice&) -> StrokeVerdict {
    return {std::popcount(formed[0]) != 22, {}};
  };
  const auto found = search_strokes(problem, {}, {.stages = 3000, .seconds = 30.0});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->status, PlanStatus::gave_up);
  EXPECT_TRUE(found->strokes.empty());
  EXPECT_TRUE(found->blocked.empty());
  EXPECT_EQ(std::popcount(found->furthest[0]), 22);
}

TEST(SearchStrokes, ProvesThatNoStrokeCanBeTheLast) {
  // Of so many lines there are too many stages to go to all.
  StrokeProblem problem = permissive(
      40, [](int line) { return std::vector<StrokeChoice>{{one_line(line)}}; });
  problem.check = [](const LineSet& formed, const StrokeChoice&) -> StrokeVerdict {
    return {std::popcount(formed[0]) < 39, {}};
  };
  const auto found = search_strokes(problem, {}, {.stages = 3000, .seconds = 30.0});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->status, PlanStatus::infeasible);
  EXPECT_TRUE(found->none_last);
  EXPECT_LT(found->stages, 3000);
}

TEST(SearchStrokes, EndsAtTheFirstPlanIfThatIsWanted) {
  int cheaper_later = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    const RandomTable random(seed, {.feasible = 0.25});
    const auto cheapest = test::cheapest_by_table(random.table(), {});
    if (!cheapest) continue;
    const auto first = search_strokes(random.problem(), {}, {.first = true});
    ASSERT_TRUE(first);
    EXPECT_TRUE(can_be_made(first->strokes, random.table()));
    EXPECT_GE(first->cost, *cheapest - 1e-9);
    if (first->status == PlanStatus::optimal) {
      EXPECT_NEAR(first->cost, *cheapest, 1e-9);
    }
    cheaper_later += first->status == PlanStatus::feasible ? 1 : 0;
  }
  EXPECT_GT(cheaper_later, 20);
}

TEST(SearchStrokesDeathTest, TakesNoChoiceThatItWasToldIsImpossible) {
  StrokeProblem problem = chain(3);
  problem.possible.pop_back();
  EXPECT_DEATH((void)search_strokes(problem), "is_covered");
}

TEST(SearchStrokes, TriesTheFirstOfEqualStrokesFirst) {
  const auto found = search_strokes(permissive(3, [](int line) {
    return std::vector<StrokeChoice>{{one_line(line), 0, 0}, {one_line(line), 1, 0}};
  }));
  ASSERT_EQ(found->strokes.size(), 3u);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(found->strokes[i].lines, one_line(i));
    EXPECT_EQ(found->strokes[i].punch, 0);
  }
}

TEST(SearchStrokes, StopsWhenItIsCancelled) {
  int asked = 0;
  const Progress progress{.report = {}, .cancelled = [&] { return ++asked > 10; }};
  const auto found = search_strokes(chain(40), {}, {}, progress);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, code::cancelled);
}

TEST(SearchStrokes, RefusesNegativeWeights) {
  const auto found = search_strokes(chain(2), {.rotate = -1.0});
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, code::bad_option);
}

TEST(SearchStrokes, TakesMoreLinesThanAWordHasBits) {
  StrokeProblem problem;
  problem.lines = 100;
  problem.choices = [](const LineSet& formed) {
    std::vector<StrokeChoice> left;
    for (int line = 0; line < 100; ++line) {
      LineSet pressed(2);
      pressed[line / 64] |= std::uint64_t{1} << (line % 64);
      if ((formed[line / 64] & pressed[line / 64]) == 0) left.push_back({pressed});
    }
    return left;
  };
  problem.possible = problem.choices(LineSet(2));
  const auto found = search_strokes(problem);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->status, PlanStatus::optimal);
  EXPECT_EQ(found->cost, 100.0);
}

}  // namespace
}  // namespace planish
