#pragma once

#include <utility>
#include <vector>

namespace planish::oracle {

using Column = int;

/// A linear expression: Σ coefficient · column + constant.
struct Linear {
  std::vector<std::pair<Column, double>> terms;
  double constant = 0.0;

  Linear() = default;
  Linear(double value) : constant(value) {}  // NOLINT: numbers are expressions
  static Linear of(Column column) {
    Linear linear;
    linear.terms.emplace_back(column, 1.0);
    return linear;
  }
  Linear& operator+=(const Linear& other);
  friend Linear operator+(Linear a, const Linear& b) { return a += b; }
  friend Linear operator*(double factor, Linear a);
  friend Linear operator-(Linear a, const Linear& b) { return a += -1.0 * b; }
};

enum class Outcome {
  optimal,     ///< proven
  infeasible,  ///< proven
  stopped      ///< the time was over
};

struct Solution {
  Outcome outcome = Outcome::stopped;
  std::vector<double> values;  ///< by column; empty where nothing was found
  double value(const Linear& linear) const;
};

/// A mixed-integer linear program, handed to COIN-OR Cbc as it stands: no start, no bound, no hint.
class LinearProgram {
 public:
  Column continuous(double low, double high);
  Column binary();
  /// a ≤ b.
  void at_most(const Linear& a, const Linear& b);
  void equal(const Linear& a, const Linear& b);
  void minimise(const Linear& cost) { cost_ = cost; }
  /// Proven to kSolverTolerance. `seconds` is the solver's time limit, none when infinite.
  Solution solve(double seconds) const;

 private:
  struct Row {
    std::vector<std::pair<Column, double>> terms;
    double low, high;
  };
  void add_row(const Linear& difference, bool equality);

  std::vector<double> low_, high_;
  std::vector<Column> binaries_;
  std::vector<Row> rows_;
  Linear cost_;
};

/// Absolute tolerance of the solver, for integers, rows, reduced costs and the gap alike, and so in
/// the unit of the program. Data should be of the order of one.
inline constexpr double kSolverTolerance = 1e-9;

}  // namespace planish::oracle
