#include "connect_oracle/linear_program.hpp"

#include <coin/Cbc_C_Interface.h>
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <string>

namespace planish::oracle {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::max();  // Clp takes it for infinite

using Model = std::unique_ptr<Cbc_Model, decltype(&Cbc_deleteModel)>;

Model quiet_exact_model(double seconds) {
  Model model(Cbc_newModel(), &Cbc_deleteModel);
  const std::string tolerance = fmt::format("{:g}", kSolverTolerance);
  // "increment" is what a solution must be better by to be looked for: 1e-5 unless told.
  for (const char* name :
       {"primalTolerance", "dualTolerance", "integerTolerance", "increment", "allowableGap"})
    Cbc_setParameter(model.get(), name, tolerance.c_str());
  Cbc_setParameter(model.get(), "ratioGap", "0");
  // With rows of big M neither cuts nor heuristics are worth their time here: four times slower.
  for (const char* name : {"cuts", "heuristics"})
    Cbc_setParameter(model.get(), name, "off");
  Cbc_setParameter(model.get(), "log", "0");
  Cbc_setLogLevel(model.get(), 0);
  if (std::isfinite(seconds)) {
    Cbc_setParameter(model.get(), "timeMode", "elapsed");
    Cbc_setMaximumSeconds(model.get(), seconds);
  }
  return model;
}

Outcome outcome_of(Cbc_Model* model) {
  if (Cbc_isProvenInfeasible(model)) return Outcome::infeasible;
  return Cbc_isProvenOptimal(model) ? Outcome::optimal : Outcome::stopped;
}

}  // namespace

Linear& Linear::operator+=(const Linear& other) {
  terms.insert(terms.end(), other.terms.begin(), other.terms.end());
  constant += other.constant;
  return *this;
}

Linear operator*(double factor, Linear a) {
  for (auto& term : a.terms)
    term.second *= factor;
  a.constant *= factor;
  return a;
}

double Solution::value(const Linear& linear) const {
  double sum = linear.constant;
  for (const auto& [column, factor] : linear.terms)
    sum += factor * values[column];
  return sum;
}

Column LinearProgram::continuous(double low, double high) {
  low_.push_back(low);
  high_.push_back(high);
  return static_cast<Column>(low_.size()) - 1;
}

Column LinearProgram::binary() {
  binaries_.push_back(continuous(0.0, 1.0));
  return binaries_.back();
}

void LinearProgram::at_most(const Linear& a, const Linear& b) { add_row(a - b, false); }

void LinearProgram::equal(const Linear& a, const Linear& b) { add_row(a - b, true); }

void LinearProgram::add_row(const Linear& difference, bool equality) {
  std::map<Column, double> sums;  // a column may stand in an expression twice, not in a row
  for (const auto& [column, factor] : difference.terms)
    sums[column] += factor;
  Row row{{}, equality ? -difference.constant : -kInfinity, -difference.constant};
  for (const auto& [column, factor] : sums)
    if (factor != 0.0) row.terms.emplace_back(column, factor);
  rows_.push_back(std::move(row));
}

Solution LinearProgram::solve(double seconds) const {
  const std::size_t columns = low_.size();
  std::vector<std::vector<std::pair<int, double>>> by_column(columns);
  std::vector<double> row_low, row_high, cost(columns, 0.0);
  for (const Row& row : rows_) {
    for (const auto& [column, factor] : row.terms)
      by_column[column].emplace_back(static_cast<int>(row_low.size()), factor);
    row_low.push_back(row.low);
    row_high.push_back(row.high);
  }
  for (const auto& [column, factor] : cost_.terms)
    cost[column] += factor;
  std::vector<CoinBigIndex> start{0};
  std::vector<int> index;
  std::vector<double> factors;
  for (const auto& entries : by_column) {
    for (const auto& [row, factor] : entries) {
      index.push_back(row);
      factors.push_back(factor);
    }
    start.push_back(static_cast<CoinBigIndex>(index.size()));
  }
  const Model model = quiet_exact_model(seconds);
  Cbc_loadProblem(model.get(), static_cast<int>(columns), static_cast<int>(rows_.size()),
                  start.data(), index.data(), factors.data(), low_.data(), high_.data(),
                  cost.data(), row_low.data(), row_high.data());
  for (const Column column : binaries_)
    Cbc_setInteger(model.get(), column);
  Cbc_solve(model.get());
  Solution solution{outcome_of(model.get()), {}};
  // A relaxation's values are no solution: only what branch and bound kept counts.
  const double* values = binaries_.empty() ? Cbc_getColSolution(model.get())
                                           : Cbc_bestSolution(model.get());
  if (values != nullptr && solution.outcome != Outcome::infeasible)
    solution.values.assign(values, values + columns);
  return solution;
}

}  // namespace planish::oracle
