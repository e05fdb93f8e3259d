#pragma once

#include "stage_book.hpp"

#include <array>
#include <map>
#include <set>
#include <unordered_map>
#include <vector>

namespace planish::brake_detail {

/// What the strokes for the lines that are left cost at least, whatever stages allow: the cheapest
/// tour of set-ups in which each line can be pressed in one that it is possible in. Lines possible
/// in the same set-ups at the same cost are one class, so the tour is exact for few classes, by
/// dynamic programming over those left. Of many only the hardest are toured, and beside that the
/// changes are counted that classes without a common side, direction or tools take.
class StrokeBound {
 public:
  /// `refuted`: rows of `problem.possible` that are none any more.
  StrokeBound(const StrokeProblem& problem, const StrokeWeights& weights,
              const std::set<std::size_t>& refuted = {});

  /// From a set-up on; null: from the start. Infinite if a line is possible nowhere.
  double operator()(const LineSet& formed, const SetUp* from);
  /// Lines that are possible nowhere.
  const std::vector<int>& hopeless() const { return hopeless_; }

 private:
  using Costs = std::vector<double>;  ///< by place in the grid; infinite: not possible
  using Counts = std::vector<std::uint16_t>;
  struct CountsHash {
    std::size_t operator()(const Counts& counts) const;
  };
  struct LineClass {
    Costs above;                               ///< of one line, beyond `least`
    double least = 0.0;                        ///< in the cheapest set-up
    std::array<std::vector<bool>, 3> at = {};  ///< whether it is possible there, along each axis
  };
  using Rows = std::vector<const StrokeChoice*>;

  std::vector<Costs> line_costs(const Rows& rows) const;
  void merge_tools(std::vector<Costs>& lines);
  void classify(const std::vector<Costs>& lines);
  LineClass class_of(const Costs& costs) const;
  std::size_t place_of(const SetUp& set_up) const;
  std::size_t places() const { return size_[0] * size_[1] * size_[2]; }
  std::size_t place(std::size_t side, std::size_t direction, std::size_t tools) const {
    return (side * size_[1] + direction) * size_[2] + tools;
  }

  const Costs& costs(const Counts& counts);
  void tour(Costs& least, const Counts& counts) const;
  void spread(Costs& costs) const;
  void count_changes(Costs& least, const Counts& counts) const;
  std::vector<double> changes(const Counts& counts, int axis) const;

  StrokeWeights weights_;
  bool knows_ = false;                        ///< `possible` was given
  std::array<std::size_t, 3> size_{1, 1, 1};  ///< sides, directions, tools
  std::map<bool, std::size_t> sides_;
  std::map<int, std::size_t> directions_;
  std::map<std::pair<int, int>, std::size_t> tools_;
  std::vector<LineClass> classes_;  ///< those possible in the fewest places first
  std::vector<int> class_of_line_;
  std::size_t toured_ = 0;  ///< classes that tours visit: the first ones
  std::vector<int> hopeless_;
  std::unordered_map<Counts, Costs, CountsHash> known_;
};

}  // namespace planish::brake_detail
