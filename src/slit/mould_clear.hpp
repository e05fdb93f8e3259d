#pragma once

#include <planish/base/result.hpp>
#include <planish/slit/mould.hpp>

#include <array>
#include <iterator>
#include <span>
#include <vector>

namespace planish::slit_detail {

/// A strip from one end to the other: ridges in space, left then right, and a normal for each quad,
/// towards the mould.
struct WholeStrip {
  std::vector<std::array<Vec3, 2>> ridges;
  std::vector<Vec3> towards_mould;
  int first = 0;  ///< number of its first quad
  /// Of each quad's width what its rib leaves to other strips, left and right; both 1: all of it.
  /// Empty: nothing of any.
  std::vector<std::array<double, 2>> left_to_others = {};
};

/// From a ridge to where the facets beside it meet, half the thickness from both quads: of the
/// ridge `at` of these normals and one more.
inline Vec3 mitre(std::span<const Vec3> normals, int at) {
  if (at == 0) return normals.front();
  if (at == std::ssize(normals)) return normals.back();
  const Vec3 &a = normals[at - 1], &b = normals[at];
  return (a + b) / (1.0 + a.dot(b));
}

/// A ridge on the skin towards the mould, `offset` from the middle of the sheet.
inline std::array<Vec3, 2> skin_ridge(const WholeStrip& strip, int at, double offset) {
  const Vec3 step = offset * mitre(strip.towards_mould, at);
  return {strip.ridges[at][0] + step, strip.ridges[at][1] + step};
}

/// The image in the plane of symmetry.
inline Vec3 mirrored(const Vec3& v) { return {-v.x(), v.y(), v.z()}; }

/// Where a facet of a rib comes up through a strip.
struct RibThrough {
  StripQuad rib, strip;
  std::vector<Vec2> around = {};  ///< of the part of the facet above the strip, seen from above
  double height = 0.0;            ///< by which it is above the strip at most…
  Vec3 at = Vec3::Zero();         ///< …and where on the strip
};

/// Places where ribs come up through the sheet; they may stand below it, even below parts that they
/// do not carry. `strips`: by strip, whole or both halves; `offset`: half the thickness.
std::vector<RibThrough> ribs_through(const Mould& mould,
                                     const std::vector<std::vector<WholeStrip>>& strips,
                                     double offset);

/// The refusal of such a rib.
tl::unexpected<Error> refused(const RibThrough& rib);

/// Checks that ribs, and walls, stand apart as seen from above. Error: `unsupported_shape`.
Result<void> check_apart(const Mould& mould);

}  // namespace planish::slit_detail
