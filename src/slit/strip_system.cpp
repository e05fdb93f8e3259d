// Several strips and where they touch: a contact is an inequality between points of two of them,
// counted as an augmented Lagrangian does (math.md#strip-contact).
#include "strip_system.hpp"

#include "descend.hpp"

#include <algorithm>

namespace planish::slit_detail {

Vec3 StripPoint::in(const StripFold& fold) const {
  Vec3 point = Vec3::Zero();
  for (const Share& share : shares)
    point += share.weight * fold.end(share.side, share.ridge);
  return point;
}

double StripSystem::unit() const {
  double sum = 0.0;
  for (const StripProblem& problem : strips)
    sum += problem.base.unit();
  return sum / count();
}

Eigen::VectorXd contact_values(const StripSystem& system, const Shapes& shapes) {
  std::vector<StripFold> folds;
  for (int strip = 0; strip < system.count(); ++strip)
    folds.push_back(folded(system.strips[strip].base, shapes[strip]));
  Eigen::VectorXd values(std::ssize(system.contacts));
  const ContactMeasure measure(system);
  for (int i = 0; i < std::ssize(system.contacts); ++i) {
    const Contact& contact = system.contacts[i];
    values[i] = measure.violation(contact, contact.here.in(folds[contact.here.strip]) -
                                               contact.there.in(folds[contact.there.strip]));
  }
  return values;
}

double ContactMeasure::violation(const Contact& contact, const Vec3& apart) const {
  return (contact.offset - direction_of(contact, apart).dot(apart)) / unit;
}
Vec3 direction_of(const Contact& contact, const Vec3& apart) {
  const bool turns = contact.of_gap == GapLimit::most && !apart.isZero(0.0);
  return turns ? Vec3(-apart.normalized()) : contact.normal;
}
double ContactMeasure::counted(const Contact& contact, const Vec3& apart) const {
  if (penalty == 0.0) return 0.0;
  return std::max(0.0, violation(contact, apart) + contact.multiplier / penalty);
}

void raise_contacts(StripSystem& system, const Eigen::VectorXd& values) {
  for (int i = 0; i < std::ssize(system.contacts); ++i) {
    double& multiplier = system.contacts[i].multiplier;
    multiplier = std::max(0.0, multiplier + system.penalty * values[i]);
  }
}

Vec3 Bond::difference(const std::vector<StripFold>& folds) const {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < points.size(); ++i)
    sum += kShares[i] * points[i].in(folds[points[i].strip]);
  return sum;
}

double objective_of(const StripSystem& system, const Shapes& shapes) {
  double sum = 0.0;
  std::vector<StripFold> folds;
  for (int strip = 0; strip < system.count(); ++strip) {
    if (!system.held[strip]) sum += whole_objective(system.strips[strip], shapes[strip]);
    if (!system.contacts.empty() || !system.bonds.empty())
      folds.push_back(folded(system.strips[strip].base, shapes[strip]));
  }
  const ContactMeasure measure(system);
  for (const Contact& contact : system.contacts) {
    const double violated = measure.counted(
        contact,
        contact.here.in(folds[contact.here.strip]) - contact.there.in(folds[contact.there.strip]));
    sum += 0.5 * system.penalty * violated * violated;
  }
  for (const Bond& bond : system.bonds)
    sum += 0.5 * bond.stiffness * bond.difference(folds).squaredNorm();
  return sum;
}

}  // namespace planish::slit_detail
