#pragma once

#include "checks.hpp"

#include <string>
#include <vector>

namespace planish::slit_detail {

/// Whether the sheet has the strip; `where` is the JSON pointer of the number. Error:
/// `unknown_strip`.
Result<void> check_strip_number(const SlitDesign& design, int strip, const std::string& where);

/// Whether the sheet can reach an anchor, given the first panel. Errors: `unknown_strip`,
/// `unknown_ridge`, `invalid_input`, `out_of_reach`.
Result<void> check_anchor(const SlitDesign& design, const std::vector<PanelFacet>& panel,
                          int anchor);

/// Whether a strip can end as placed. Errors: `unknown_strip`, `bad_option`, `invalid_input`,
/// `out_of_reach`.
Result<void> check_end(const SlitDesign& design, const std::vector<PanelFacet>& panel, int strip);

/// Whether the strips reach the second panel. Error: `out_of_reach`.
Result<void> check_second_panel(const SlitDesign& design, const Panels& panels);

}  // namespace planish::slit_detail
