#pragma once

#include <planish/base/result.hpp>
#include <planish/slit/folded_slit_sheet.hpp>

#include <string>
#include <vector>

namespace planish::slit_detail {

/// Share of the sheet's width by which the leg curve may be shorter or longer than the panel on it.
constexpr double kLegTolerance = 0.02;

/// The panel over the leg curve: plane facets whose widths are stepped along the curve as chords,
/// so that the panel is exactly as wide as the sheet and every strip begins on a straight edge of
/// its own width. A panel that leans is turned as a whole about the line through the ends of the
/// curve. Errors: `curve_too_short`, `curve_too_long`.
Result<std::vector<PanelFacet>> panel_of(const SlitSheet& sheet, const BezierCurve& leg_curve,
                                         Angle lean = {});
/// The panel at the far ends of the strips, likewise.
Result<std::vector<PanelFacet>> second_panel_of(const SlitSheet& sheet, const SecondPanel& panel);

/// Of the two panels, that where the strips start or that where they end.
enum class PanelAt { start, end };

/// The curve scaled about its start so that the chords of the sheet end at its end; the curve
/// itself if they do so within rounding. Error: `invalid_input` if no scale does.
Result<BezierCurve> fitted(const SlitSheet& sheet, const BezierCurve& curve, PanelAt at,
                           const std::string& where);

}  // namespace planish::slit_detail
