#pragma once

#include <planish/base/result.hpp>
#include <planish/slit/folded_slit_sheet.hpp>
#include <planish/slit/slit_sheet.hpp>

#include <array>

namespace planish {

/// The material that is bent with a fold: how far it goes at the left and the right end of the
/// ridge, at right angles to it, mm (math.md#bending-energy).
using BentWidths = std::array<double, 2>;
/// That of a ridge of a strip.
BentWidths bent_widths(const FoldedStrip& strip, int ridge);

/// What a fold keeps when it is let go: its springback is that of the moment of an elastic,
/// perfectly plastic sheet (math.md#standing). The material needs a yield stress. 0 below it.
/// Accuracy: 1e-12 for equal widths.
Angle kept_fold(const SlitMaterial& material, double thickness, const BentWidths& bent, Angle fold);

/// The fold that keeps another when it is let go, by bisection to rounding, at most half a turn:
/// where that keeps less, half a turn is the answer. 0 keeps 0.
Angle overbent_fold(const SlitMaterial& material, double thickness, const BentWidths& bent,
                    Angle kept);

/// A folded sheet whose strips are bent so far that they keep the folds of `folded` when they are
/// let go. Each strip lies where its end does: at the symmetry plane or at what joins it there,
/// else where it begins; so strips do not meet their panels. Errors: `bad_option` (no yield
/// stress), `radius_too_small` (a fold would have to be more than half a turn).
Result<FoldedSlitSheet> overbent(const FoldedSlitSheet& folded, const SlitMaterial& material);

}  // namespace planish
