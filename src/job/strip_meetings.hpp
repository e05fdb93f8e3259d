#pragma once

#include <planish/inspect/findings.hpp>
#include <planish/job/slit.hpp>
#include <planish/sheet/sheet.hpp>

#include <vector>

namespace planish::job {

/// Where strips of a slit sheet, which are bent as if they had no thickness, need the same space
/// with it: errors "self_intersection", one for each two parts of which one runs through the other,
/// with the depth; and at most one info "strips_press" for those that overlap less, as the edges
/// of neighbours do that tilt towards each other. Less than a quarter of the thickness is left to
/// the kerf. A mirrored pair is named once. Requires `sheet_of` and layout of the report.
std::vector<Finding> strip_meetings(const SlitReport& report, const Sheet& sheet);

}  // namespace planish::job
