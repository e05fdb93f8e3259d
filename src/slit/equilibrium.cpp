// What strips at rest bear, what holds them, and which of them stay (math.md#standing).
#include "equilibrium.hpp"

#include "bend_energy.hpp"
#include "contacts.hpp"
#include "coupling.hpp"
#include "design_load.hpp"
#include "resting_strip.hpp"
#include "stability.hpp"

#include <optional>
#include <utility>

namespace planish::slit_detail {
namespace {

bool is_bent(const Snapshot& now, int strip) { return now.slot(strip).p.size() > 0; }

/// What bonds between strips do to one.
std::vector<PointForce> bound_on(const Snapshot& now, int strip) {
  std::vector<PointForce> all;
  if (!now.design->coupling) return all;
  std::vector<StripProblem> problems;
  std::vector<StripFold> folds;
  for (int i = 0; i < now.count(); ++i) {
    if (!is_bent(now, i)) return all;
    problems.push_back(problem_of(now, i));
    folds.push_back(folded(problems.back().base, now.slot(i).p));
  }
  for (const Bond& bond : bonds_of(problems, now.design->coupling->smooth))
    for (std::size_t i = 0; i < bond.points.size(); ++i)
      if (bond.points[i].strip == strip)
        all.push_back(
            {bond.points[i], -bond.stiffness * Bond::kShares[i] * bond.difference(folds)});
  return all;
}

std::vector<PointForce> pressed_on(const Snapshot& now, int strip) {
  std::vector<PointForce> all = bound_on(now, strip);
  for (const Contact& contact : now.pressing.contacts) {
    const Vec3 force = contact.multiplier / now.pressing.unit * contact.normal;
    if (contact.here.strip == strip) all.push_back({contact.here, force});
    if (contact.there.strip == strip) all.push_back({contact.there, -force});
  }
  return all;
}

/// Where strips press each other, and where neighbours touch.
std::vector<Contact> all_contacts(const Snapshot& now) {
  constexpr double kTouch = 0.01;  // of the thickness
  const double thickness = now.design->sheet.thickness;
  std::vector<Contact> all = now.pressing.contacts;
  for (int left = 0; left + 1 < now.count(); ++left) {
    const int right = left + 1;
    if (!is_bent(now, left) || !is_bent(now, right)) continue;
    const FoldedStrip a = folded_of(now, left), b = folded_of(now, right);
    const StripFold fold_a = folded(base_of(now, left), now.slot(left).p),
                    fold_b = folded(base_of(now, right), now.slot(right).p);
    const auto at = [&](const StripPoint& point) {
      return point.in(point.strip == left ? fold_a : fold_b);
    };
    for (Contact& contact :
         contacts_of(nearest_pair(left, right, a, b, thickness), a, b, thickness)) {
      const double apart = contact.normal.dot(at(contact.here) - at(contact.there));
      if (apart - contact.offset < kTouch * thickness) all.push_back(std::move(contact));
    }
  }
  return all;
}

/// In which contacts count, also where none was needed.
double unit_of(const Snapshot& now) {
  return now.pressing.unit > 0.0 ? now.pressing.unit : base_of(now, 0).unit();
}

/// What a strip bears whatever holds it.
void add_stress(SlitEquilibrium& all, const Snapshot& now, int strip) {
  const SlitDesign& design = *now.design;
  const double thickness = design.sheet.thickness;
  const double curvature = is_bent(now, strip)
                               ? largest_curvature(problem_of(now, strip), now.slot(strip).p)
                               : 0.0;
  all.stress.push_back(design.material->stress(thickness, curvature));
  const double kept = design.material->yield && curvature > 0.0
                          ? design.material->kept_curvature(thickness, curvature)
                          : 0.0;
  all.kept_radius.push_back(kept > 0.0 ? std::optional(1.0 / kept) : std::nullopt);
}

/// Strips that have no shape yet are left out: they bear nothing, and stay.
void add_rest(SlitEquilibrium& all, const Snapshot& now) {
  const SlitDesign& design = *now.design;
  std::vector<RestingStrip> resting;
  std::vector<int> member(now.count(), -1);
  for (int strip = 0; strip < now.count(); ++strip) {
    if (!is_bent(now, strip)) continue;
    member[strip] = static_cast<int>(resting.size());
    resting.emplace_back(problem_of(now, strip), now.slot(strip).p, pressed_on(now, strip),
                         least_height(now, strip));
    const double to_newtons = design.material->rigidity(design.sheet.thickness) /
                              energy_scale(resting.back().problem().base);
    for (SlitReaction& reaction : resting.back().reactions(strip, to_newtons))
      all.reactions.push_back(std::move(reaction));
  }
  std::vector<Contact> contacts = all_contacts(now);
  for (Contact& contact : contacts) {
    contact.here.strip = member[contact.here.strip];
    contact.there.strip = member[contact.there.strip];
  }
  const std::vector<bool> stay = those_that_stay(resting, contacts, unit_of(now),
                                                 design.sheet.symmetric);
  for (const int of_strip : member)
    all.is_stable.push_back(of_strip < 0 || stay[of_strip]);
}

}  // namespace

std::optional<SlitEquilibrium> equilibrium_of(const Snapshot& now) {
  if (!now.design->material) return std::nullopt;
  SlitEquilibrium all;
  for (int strip = 0; strip < now.count(); ++strip)
    add_stress(all, now, strip);
  if (now.design->objective == SlitObjective::energy) add_rest(all, now);
  all.standing = standing_of(folded_sheet(now), *now.design);
  return all;
}

}  // namespace planish::slit_detail
