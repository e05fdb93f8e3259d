#pragma once

#include <planish/base/result.hpp>
#include <planish/slit/mould.hpp>

#include <array>
#include <vector>

namespace planish::slit_detail {

/// A strip from one end to the other: ridges in space, left then right, and a normal for each quad,
/// towards the mould.
struct WholeStrip {
  std::vector<std::array<Vec3, 2>> ridges;
  std::vector<Vec3> towards_mould;
  int first = 0;  ///< number of its first quad
};

/// From a ridge to where the facets beside it meet, half the thickness from both quads.
inline Vec3 mitre(const Vec3& a, const Vec3& b) { return (a + b) / (1.0 + a.dot(b)); }

/// Checks that ribs stand apart and none comes up through the sheet; they may stand below it, even
/// below parts that they do not carry. `strips`: by strip, whole or both halves; `offset`: half the
/// thickness. Error: `unsupported_shape`.
Result<void> check_clear(const Mould& mould, const std::vector<std::vector<WholeStrip>>& strips,
                         double offset);

}  // namespace planish::slit_detail
