#pragma once

#include <planish/base/result.hpp>
#include <planish/slit/folded_slit_sheet.hpp>
#include <planish/slit/slit_sheet.hpp>

#include <vector>

namespace planish::slit_detail {

/// Checks the sheet and the number of ridges. `where` of all errors here is the JSON pointer of the
/// cause.
Result<void> check_sheet(const SlitDesign& design);
/// The design with its leg curves scaled where that is asked for; they are finite and nowhere
/// tighter than the material allows.
Result<SlitDesign> with_fitted_curves(SlitDesign design);

struct Panels {
  std::vector<PanelFacet> first, second;  ///< the second is empty if there is none
};
/// The panels over checked leg curves, if these are as long as the sheet is wide, and the first
/// panel is on one side of the symmetry plane.
Result<Panels> checked_panels(const SlitDesign& design);
/// Checks a design except for its sheet, its leg curves (whose panels are given) and its scans.
Result<void> check_all(const SlitDesign& design, const Panels& panels);

/// Checked scans, grouped by strip; without those that name none.
Result<std::vector<std::vector<Vec3>>> points_by_strip(const SlitDesign& design);

}  // namespace planish::slit_detail
