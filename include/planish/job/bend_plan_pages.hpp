#pragma once

#include <planish/io/pages.hpp>
#include <planish/job/maker.hpp>
#include <planish/job/report.hpp>
#include <planish/job/request.hpp>

#include <vector>

namespace planish::job {

/// The bend plan of a report on pages to hang at the machine: the part and its flat pattern with
/// the bends numbered in order, then each stroke. `bending` is that of its request. A report
/// without strokes gives the first page alone.
std::vector<Page> bend_plan_pages(const Report& report, const Bending& bending);
/// Of all pieces.
std::vector<Page> bend_plan_pages(const Made& made, const Bending& bending);

/// DXF of the flat pattern for the inside radii that the tools of the report's plan leave: the
/// drawn one where they leave the drawn radii. Errors: why there is none for others, `bad_option`
/// if the plan is not over it (`Bending::as_made`).
Result<std::string> dxf_as_made(const Report& report, const Request& request);

}  // namespace planish::job
