#pragma once

#include "brake/stroke_tables.hpp"

#include <bit>
#include <random>
#include <set>

namespace planish::test {

/// How a random table is made.
struct TableKind {
  int most_lines = 7;
  int punches = 2, dies = 2, directions = 2;
  double feasible = 0.3;  ///< share of the set-ups that a line can be pressed in, in a stage
  bool sides_fixed = true;
};

class RandomTable {
 public:
  RandomTable(unsigned seed, const TableKind& kind) : random_(seed), kind_(kind) {
    table_.lines = 1 + below(kind.most_lines);
    for (int line = 0; line < table_.lines; ++line) {
      group_.push_back(below(table_.lines + 1));
      up_.push_back(below(2) == 0);
    }
    table_.by_stage.resize(std::size_t{1} << table_.lines);
    for (std::size_t stage = 0; stage + 1 < table_.stages(); ++stage)
      fill(stage);
  }

  const StrokeTable& table() const { return table_; }

  StrokeProblem problem() const {
    StrokeProblem problem;
    problem.lines = table_.lines;
    problem.choices = [this](const LineSet& formed) { return table_.by_stage[formed[0]]; };
    return problem;
  }

  /// Every set-up that the table has for a group of lines, as if all of them were pressed.
  std::vector<StrokeChoice> possible() const {
    std::map<std::pair<int, SetUpKey>, StrokeChoice> rows;
    for (const auto& choices : table_.by_stage)
      for (const StrokeChoice& choice : choices) {
        const int group = group_[std::countr_zero(choice.lines[0])];
        StrokeChoice& row = rows.try_emplace({group, set_up_of(choice)}, choice).first->second;
        row.lines[0] |= choice.lines[0];
        row.gauged = row.gauged || choice.gauged;
      }
    std::vector<StrokeChoice> all;
    for (const auto& [key, row] : rows)
      all.push_back(row);
    return all;
  }

 private:
  int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(random_); }
  bool chance(double share) { return std::uniform_real_distribution<>(0.0, 1.0)(random_) < share; }

  /// Lines of one group are pressed together if they are left, or some of them are.
  void fill(std::size_t stage) {
    std::set<std::uint64_t> pressed;
    for (int line = 0; line < table_.lines; ++line) {
      if (stage >> line & 1) continue;
      std::uint64_t lines = std::uint64_t{1} << line;
      for (int other = 0; other < table_.lines; ++other)
        if (group_[other] == group_[line] && !(stage >> other & 1) && chance(0.7))
          lines |= std::uint64_t{1} << other;
      if (pressed.insert(lines).second) add_choices(stage, lines, up_[group_[line] % up_.size()]);
    }
  }

  void add_choices(std::size_t stage, std::uint64_t lines, bool up) {
    for (int punch = 0; punch < kind_.punches; ++punch)
      for (int die = 0; die < kind_.dies; ++die)
        for (int direction = 0; direction < kind_.directions; ++direction) {
          if (!chance(kind_.feasible)) continue;
          const bool side = kind_.sides_fixed ? up : chance(0.5);
          // The V of the second die and of each after it is a size farther from the wanted one.
          table_.by_stage[stage].push_back(
              {{lines}, punch, die, side, direction, chance(0.8), die});
        }
  }

  std::mt19937 random_;
  TableKind kind_;
  StrokeTable table_;
  std::vector<int> group_;
  std::vector<bool> up_;
};

}  // namespace planish::test
