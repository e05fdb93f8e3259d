// The objective of a strip to second order: bending energy and the potential of its load, both
// scaled alike (math.md#bending-energy), and the squares of its wishes.
#include "strip_objective.hpp"

#include "load_potential.hpp"

namespace planish::slit_detail {
namespace {

/// Adds JᵀJ, row by row: most have few neighbouring entries.
void add_squares(const RowMatrix& jacobian, Eigen::MatrixXd& sum) {
  for (Eigen::Index i = 0; i < jacobian.rows(); ++i) {
    const auto row = jacobian.row(i);
    Eigen::Index first = 0, last = row.size();
    while (first < last && row[first] == 0.0)
      ++first;
    while (last > first && row[last - 1] == 0.0)
      --last;
    const auto part = row.segment(first, last - first);
    sum.block(first, first, part.size(), part.size()).noalias() += part.transpose() * part;
  }
}

void add_load(SecondOrder& energy, const StripProblem& problem, const StripParameters& p) {
  if (problem.load.empty()) return;
  const SecondOrder load = load_potential_derivatives(problem, p);
  energy.value += load.value;
  energy.gradient += load.gradient;
  energy.hessian += load.hessian;
}

}  // namespace

double load_part(const StripProblem& problem, const StripParameters& p) {
  return problem.load.empty() ? 0.0 : energy_scale(problem.base) * load_potential(problem, p);
}

SecondOrder objective_derivatives(const StripProblem& problem, const StripParameters& p) {
  SecondOrder model = bend_energy_derivatives(problem, p);
  add_load(model, problem, p);
  const double scale = energy_scale(problem.base);
  Eigen::VectorXd residuals(problem.residuals());
  RowMatrix jacobian(problem.residuals(), problem.parameters());
  Eigen::Ref<RowMatrix> ref(jacobian);
  evaluate(problem, p, residuals, &ref);
  model.value = scale * model.value + 0.5 * residuals.squaredNorm();
  model.gradient = scale * model.gradient + jacobian.transpose() * residuals;
  model.hessian *= scale;
  add_squares(jacobian, model.hessian);
  return model;
}

Eigen::VectorXd units_of(const StripBase& base) {
  Eigen::VectorXd units = Eigen::VectorXd::Constant(parameter_count(base.quads), 1.0 / base.quads);
  units.head(base.quads).setOnes();
  return units;
}

}  // namespace planish::slit_detail
