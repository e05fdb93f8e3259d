#pragma once

#include <planish/base/result.hpp>

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace planish {

/// σ = strength · ε^exponent (Ludwik, Hollomon); an exponent of 0 is a perfectly plastic material.
struct PowerLaw {
  double strength = 0.0;  ///< N/mm², above 0
  double exponent = 0.0;  ///< 0 to 1
};

/// Stress at strains as they were measured: straight from (0, 0) to the first point and between
/// points; beyond the last one the stress stays.
struct MeasuredCurve {
  struct Point {
    double strain = 0.0;  ///< engineering strain, at least 0, ascending; two may be equal (a step)
    double stress = 0.0;  ///< N/mm², at least 0
  };
  std::vector<Point> points;  ///< at least one, one of them above 0 in strain and in stress
};

/// Magnitude of stress by magnitude of strain.
using StressStrain = std::variant<PowerLaw, MeasuredCurve>;

/// What a material does when it is bent beyond its yield point (math.md#plastic-bending).
struct MaterialCurves {
  std::string name;  ///< for reports
  StressStrain tension, compression;
  /// As far as the file states them: N/mm², a ratio, kg/dm³, N/mm².
  std::optional<double> young = {}, poisson = {}, density = {}, yield = {};
};

/// `bad_option` for a curve that breaks a rule of its type.
Result<void> check(const MaterialCurves& material);

/// ∫ σ dε from 0 to `strain`, exact.
double work_of(const StressStrain& curve, double strain);

/// K of a bend whose inside radius is `ratio` thicknesses: the neutral surface of pure bending, at
/// which the forces of the stretched and of the compressed side balance [thesis 1–5]. 1/2 where
/// both curves are the same. `ratio` ≥ 0. Accurate to 1e-12.
double plastic_k(const MaterialCurves& material, double ratio);

/// The largest strains of such a bend, of the outside (tension) and of the inside (compression).
struct BendStrains {
  double tension = 0.0, compression = 0.0;
};
BendStrains bend_strains(double k, double ratio);

/// Strains up to which a curve is known; infinite for power laws.
double known_to(const StressStrain& curve);

}  // namespace planish
