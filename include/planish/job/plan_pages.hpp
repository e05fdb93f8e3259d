#pragma once

#include <planish/brake/tools.hpp>
#include <planish/io/page.hpp>
#include <planish/job/report.hpp>

#include <vector>

namespace planish::job {

/// What hangs at the machine: the part with its flat pattern, sizes and numbered bends, the table
/// of strokes; then for each stroke how the sheet lies, what is bent already, where the gauge
/// touches, and the tools. A report without a plan gives the first page alone.
std::vector<Page> plan_pages(const Report& report, const BrakeTools& tools);

}  // namespace planish::job
