// The neutral surface of plastic bending (math.md#plastic-bending, [thesis 1]): K is where the
// forces of tension and compression over the thickness cancel. Their difference falls all the way
// from K = 0 to K = 1, so it is found by halving.

#include "refusals.hpp"

#include <planish/base/assert.hpp>
#include <planish/sheet/material.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

// K by pure bending (math.md#plastic-bending): where the forces of the stretched and of the
// compressed side balance [thesis 1–5]. The force of a side is the integral of stress over strain,
// exact for both kinds of curve; the surplus of tension falls all the way from k = 0 to 1, so
// bisection finds its zero, to the last bit.

namespace planish {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::infinity();

bool is_regular(const PowerLaw& law) {
  return law.strength > 0.0 && std::isfinite(law.strength) && law.exponent >= 0.0 &&
         law.exponent <= 1.0;
}

bool is_regular(const MeasuredCurve& curve) {
  double before = 0.0;
  for (const MeasuredCurve::Point& point : curve.points) {
    const bool fine = point.strain >= before && std::isfinite(point.strain) &&
                      point.stress >= 0.0 && std::isfinite(point.stress);
    if (!fine) return false;
    before = point.strain;
  }
  return !curve.points.empty() && curve.points.back().strain > 0.0 &&
         std::ranges::any_of(curve.points, [](const auto& point) { return point.stress > 0.0; });
}

double work(const PowerLaw& law, double strain) {
  return law.strength * std::pow(strain, law.exponent + 1.0) / (law.exponent + 1.0);
}

double work(const MeasuredCurve& curve, double strain) {
  double sum = 0.0;
  MeasuredCurve::Point from;
  for (const MeasuredCurve::Point& to : curve.points) {
    const double end = std::min(to.strain, strain);
    if (end > from.strain) {
      const double share = (end - from.strain) / (to.strain - from.strain);
      sum += (end - from.strain) * (from.stress + 0.5 * share * (to.stress - from.stress));
    }
    if (to.strain >= strain) return sum;
    from = to;
  }
  return sum + (strain - from.strain) * from.stress;
}

double end_of(const PowerLaw&) { return kUnknown; }
double end_of(const MeasuredCurve& curve) { return curve.points.back().strain; }

}  // namespace

Result<void> check(const MaterialCurves& material) {
  for (const StressStrain* curve : {&material.tension, &material.compression})
    if (!std::visit([](const auto& c) { return is_regular(c); }, *curve))
      return fail(refuse::material_curve,
                  {{"material", material.name},
                   {"side", curve == &material.tension ? "tension" : "compression"}});
  return {};
}

double work_of(const StressStrain& curve, double strain) {
  return std::visit([&](const auto& c) { return work(c, strain); }, curve);
}

double known_to(const StressStrain& curve) {
  return std::visit([](const auto& c) { return end_of(c); }, curve);
}

BendStrains bend_strains(double k, double ratio) {
  return {(1.0 - k) / (ratio + k), k / (ratio + k)};
}

double plastic_k(const MaterialCurves& material, double ratio) {
  PLANISH_ASSERT(check(material).has_value());
  PLANISH_ASSERT(ratio >= 0.0 && std::isfinite(ratio));
  // The surplus of tension falls all the way from k = 0 to k = 1.
  double low = 0.0, high = 1.0;
  for (double k = 0.5; low < k && k < high; k = 0.5 * (low + high)) {
    const BendStrains strains = bend_strains(k, ratio);
    const double surplus = work_of(material.tension, strains.tension) -
                           work_of(material.compression, strains.compression);
    if (surplus == 0.0) return k;
    (surplus > 0.0 ? low : high) = k;
  }
  return 0.5 * (low + high);
}

}  // namespace planish
