#pragma once

#include "strip_problem.hpp"

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

/// Whether a contact is a limit of the gap where strips end. Of the most the direction is that of
/// the points from each other, and turns with them: they stay in a ball.
enum class GapLimit { none, least, most };

/// A point of one strip must stay beyond one of another: normal · (here − there) ≥ offset, mm. The
/// direction stays as it is during a descent.
struct Contact {
  StripPoint here, there;
  Vec3 normal = Vec3::Zero();
  double offset = 0.0;
  double multiplier = 0.0;
  GapLimit of_gap = GapLimit::none;
};

/// A wish that three neighbours' points lie evenly: half its stiffness times the square of their
/// second difference.
struct Bond {
  static constexpr std::array<double, 3> kShares{1.0, -2.0, 1.0};
  std::array<StripPoint, 3> points;
  double stiffness = 0.0;  ///< in the unit of the objective, per mm²

  Vec3 difference(const std::vector<StripFold>& folds) const;
};

/// Strips whose shapes are sought together, as they touch.
struct StripSystem {
  std::vector<StripProblem> strips;
  std::vector<bool> held;  ///< by strip: it stays as it is
  std::vector<Contact> contacts;
  std::vector<Bond> bonds = {};
  double penalty = 0.0;  ///< of violated contacts, for the augmented Lagrangian

  int count() const { return static_cast<int>(strips.size()); }
  /// In which contacts count, mm: the mean of the strips' lengths.
  double unit() const;
};

using Shapes = std::vector<StripParameters>;  ///< of the strips of a system

/// The direction in which a contact acts if its points are that far apart.
Vec3 direction_of(const Contact& contact, const Vec3& apart);

/// How contacts of a system count, whose unit is a sum over its strips: found once for all of them.
struct ContactMeasure {
  explicit ContactMeasure(const StripSystem& system)
      : penalty(system.penalty), unit(system.unit()) {}

  /// By how much a contact is violated, in units of the system, if its points are that far apart.
  double violation(const Contact& contact, const Vec3& apart) const;
  /// With what its multiplier adds, at least 0.
  double counted(const Contact& contact, const Vec3& apart) const;

  double penalty = 0.0, unit = 0.0;
};

/// Violations of the contacts, negative where they hold.
Eigen::VectorXd contact_values(const StripSystem& system, const Shapes& shapes);

/// Multipliers of contacts as a round leaves them, by what is violated at its end.
void raise_contacts(StripSystem& system, const Eigen::VectorXd& values);

/// The sum of the objectives of strips that move, the cost of bonds and the penalty of contacts;
/// infinite where there is no shape.
double objective_of(const StripSystem& system, const Shapes& shapes);

}  // namespace planish::slit_detail
