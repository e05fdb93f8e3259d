#pragma once

#include <TopoDS_Solid.hxx>

#include <array>

namespace planish::brep {

/// Numbers that agree for congruent solids of the same hand, wherever they lie: counts, and moments
/// of the edges' points about their centroid, one of which changes sign in a mirror.
struct Fingerprint {
  std::array<int, 3> counts{};
  std::array<double, 8> moments{};
};

Fingerprint fingerprint_of(const TopoDS_Solid& solid);

/// Equal within the rounding of placed copies (1e-6 of the solid's size).
bool identical(const Fingerprint& a, const Fingerprint& b);

}  // namespace planish::brep
