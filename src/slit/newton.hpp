#pragma once

#include "descend.hpp"

#include <vector>

namespace planish::slit_detail {

/// A point of a strip: a combination of ends of its ridges, whose weights add up to 1.
struct StripPoint {
  struct Share {
    int side = 0;
    int ridge = 0;
    double weight = 1.0;
  };
  int strip = 0;  ///< of the system
  std::vector<Share> shares;

  Vec3 in(const StripFold& fold) const;
};

/// A point of one strip must stay beyond one of another: normal · (here − there) ≥ offset, mm. The
/// direction stays as it is during a descent.
struct Contact {
  StripPoint here, there;
  Vec3 normal = Vec3::Zero();
  double offset = 0.0;
  double multiplier = 0.0;
};

/// Strips whose shapes are sought together, as they touch.
struct StripSystem {
  std::vector<StripProblem> strips;
  std::vector<bool> held;  ///< by strip: it stays as it is
  std::vector<Contact> contacts;
  double penalty = 0.0;  ///< of violated contacts, for the augmented Lagrangian

  int count() const { return static_cast<int>(strips.size()); }
  /// In which contacts count, mm: the mean of the strips' lengths.
  double unit() const;
};

using Shapes = std::vector<StripParameters>;  ///< of the strips of a system

/// Values g ≤ 0 of the contacts, in units of the system.
Eigen::VectorXd contact_values(const StripSystem& system, const Shapes& shapes);

/// The best shapes so far.
struct SystemDescent {
  Shapes shapes;
  double objective = 0.0;
  int iterations = 0;
  bool converged = false;
};

/// Lowers the sum of the strips' objectives with bending energy, and the penalty of contacts, among
/// shapes that meet the end conditions, by Newton's method within a reach: exact second derivatives
/// of the energy, the conditions and what draws at ridge ends. Quadratic near the minimum;
/// O(strips × quads³) for a step.
SystemDescent descend_by_newton(const StripSystem& system, Shapes from,
                                const DescentOptions& options);

/// The same of a strip by itself.
Descent descend_by_newton(const StripProblem& problem, const StripParameters& from,
                          const DescentOptions& options);

}  // namespace planish::slit_detail
