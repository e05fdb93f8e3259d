#pragma once

#include <planish/base/result.hpp>
#include <planish/sheet/flat_pattern.hpp>

namespace planish {

/// How the slits of a sheet are cut.
struct SlotOptions {
  double kerf = 0.0;        ///< width of the cut, mm; 0: a line, cut once
  double stop_hole = 0.0;   ///< diameter of the holes at ends inside the material, mm; 0: round
                            ///< ends without holes
  double tolerance = 1e-5;  ///< mm: the two banks of a slit lie this close together
  double curve_tolerance = 0.01;  ///< mm, within which slits drawn as chains of lines become arcs
};

/// The pattern as cut. In a flat pattern, slits between touching parts are openings, or stretches
/// of a contour, whose two banks coincide; openings with a width stay as they are.
///
/// Lines that go on where another ends are one slit; where they turn little they are a curve.
///
/// With kerf 0 every slit becomes one line in `slits`, or lines and arcs in turn, from stop hole to
/// stop hole if there are any, and leaves the contours. Otherwise it becomes a slot: the material
/// within half the kerf of the slit is removed, with a hole at each end inside the material. A slit
/// that runs out of the sheet or into an opening is open there, and its banks become part of that
/// contour. Bend and tangent lines end at slots and holes; `area`, `perimeter` and the bends'
/// lengths are measured again. What describes the sheet before it is cut (`placement`,
/// `face_outlines`, …) stays; new curves have no origins. So certify before cutting.
///
/// Errors: `bad_option` (an option negative or not finite, a stop hole narrower than the kerf,
/// slots or holes that run into one another or into a contour: the kerf is too wide),
/// `unsupported_shape` (a slit that branches, or ends at a curved contour). Accuracy: rounding;
/// both banks are moved onto one line, by less than the tolerance. O((slits + contour curves)²).
Result<FlatPattern> cut_slits(FlatPattern pattern, const SlotOptions& options = {});

}  // namespace planish
