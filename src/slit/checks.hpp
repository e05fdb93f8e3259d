#pragma once

#include <planish/base/result.hpp>
#include <planish/slit/folded_slit_sheet.hpp>
#include <planish/slit/slit_sheet.hpp>

#include <vector>

namespace planish::slit_detail {

/// Checks the sheet and the number of ridges. `where` of all errors here is the JSON pointer of the
/// cause.
Result<void> check_sheet(const SlitDesign& design);
/// The panel over the leg curve, if the curve is finite, on one side of the symmetry plane, nowhere
/// tighter than the material allows, and as long as the sheet is wide.
Result<std::vector<PanelFacet>> checked_panel(const SlitDesign& design);
/// Checks a design except for its sheet, its leg curve (whose panel is given) and its scans.
Result<void> check_all(const SlitDesign& design, const std::vector<PanelFacet>& panel);

/// Checked scans, grouped by strip.
Result<std::vector<std::vector<Vec3>>> points_by_strip(const SlitDesign& design);

}  // namespace planish::slit_detail
