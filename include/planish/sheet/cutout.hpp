#pragma once

#include <planish/sheet/flat_pattern.hpp>

namespace planish {

/// Two lines this near to each other are one, mm: as near as contours are recognised.
inline constexpr double kDrawnOnce = 1e-5;
/// Half the kerf of a laser, mm: a shorter slit cannot be cut, and is noise of the model.
inline constexpr double kShortestSlit = 0.1;

/// A rectangle, its corners rounded if wanted, that is taken out of a pattern.
struct Cutout {
  Vec2 middle = Vec2::Zero();
  Vec2 along = Vec2::UnitX();  ///< unit vector along its first side
  Vec2 half = Vec2::Zero();    ///< half of its sides, along and across
  double corner_radius = 0.0;  ///< at most the shorter of `half`
  /// A corner that stays sharp, counted counter-clockwise from that along and across; −1: none.
  int sharp_corner = -1;

  /// Distance of a point from its outline, below 0 inside.
  double distance(const Vec2& p) const;
  /// Its outline, counter-clockwise.
  Loop outline() const;
};

/// The pattern without the material within the cutout. Contours that enter it go on along its
/// outline, what lies inside vanishes, and where two stretches of material covered each other
/// inside, they do so no more; within the material it is an opening. Straight slits, bend and
/// tangent lines end at it; area, perimeter and lengths are measured again; new curves have no
/// origins. Errors: `unsupported_shape` (contours that meet the outline in another order than in
/// and out, so that material is covered twice there; a pattern that falls into pieces). Sides of
/// the cutout go on from contours that lie along them within `tolerance`, mm, as one curve.
/// Accuracy: that. O(contour curves).
Result<FlatPattern> without_cutout(FlatPattern pattern, const Cutout& cutout,
                                   double tolerance = kDrawnOnce);

/// The slits that run there and back along the same line within contours, drawn once each in
/// `slits`; contours that are only slits stay. The area stays, the perimeter counts slits once.
/// `tolerance`: the two banks lie this close together, mm. Those shorter than `kShortestSlit`
/// vanish.
FlatPattern with_slits_drawn_once(FlatPattern pattern, double tolerance = kDrawnOnce);

}  // namespace planish
