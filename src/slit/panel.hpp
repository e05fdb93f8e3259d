#pragma once

#include <planish/base/result.hpp>
#include <planish/slit/folded_slit_sheet.hpp>

#include <vector>

namespace planish::slit_detail {

/// Share of the sheet's width by which the leg curve may be shorter or longer than the panel on it.
constexpr double kLegTolerance = 0.02;

/// The panel over the leg curve: plane facets whose widths are stepped along the curve as chords,
/// so that the panel is exactly as wide as the sheet and every strip begins on a straight edge of
/// its own width. Errors: `curve_too_short`, `curve_too_long`.
Result<std::vector<PanelFacet>> panel_of(const SlitSheet& sheet, const BezierCurve& leg_curve);

}  // namespace planish::slit_detail
