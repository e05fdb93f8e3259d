#pragma once

#include <planish/base/result.hpp>
#include <planish/sheet/flat_pattern.hpp>

namespace planish {

/// How the slits of a sheet are cut.
struct SlotOptions {
  double kerf = 0.0;        ///< width of the cut, mm; 0: a line, cut once
  double stop_hole = 0.0;   ///< diameter of the holes at ends inside the material, mm; 0: none
                            ///< (round ends)
  double tolerance = 1e-5;  ///< mm: both banks of a slit lie this near to each other
};

/// The pattern as it is cut. Flattened, slits between parts that touch are openings, or stretches
/// of a contour, whose two banks coincide; openings of a width of their own stay as they are.
///
/// Kerf 0: every slit becomes one line of `slits`, from hole to hole where there are stop holes,
/// and leaves the contours. Otherwise it becomes a slot: the points within half the kerf of the
/// slit, taken out of the material, with a hole at each end inside the material. A slit that runs
/// out of the sheet or into an opening is open there, and its banks belong to that contour. Bend
/// and tangent lines end at slots and holes; `area`, `perimeter` and the bends' lengths are
/// measured again. What describes the sheet before it is cut (`placement`, `face_outlines`, …)
/// stays; curves that no border of the sheet gave have no origins. So certify first, cut then.
///
/// Errors: `bad_option` (an option negative or not finite, a stop hole narrower than the kerf,
/// slots or holes that run into one another or into a contour: the kerf is wider than a strip),
/// `unsupported_shape` (a slit that branches, or is open at a curve). Accuracy: rounding; both
/// banks are moved onto one line, by less than the tolerance. O((slits + contour curves)²).
Result<FlatPattern> cut_slits(FlatPattern pattern, const SlotOptions& options = {});

}  // namespace planish
