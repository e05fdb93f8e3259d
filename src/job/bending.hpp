#pragma once

#include <planish/base/progress.hpp>
#include <planish/job/report.hpp>
#include <planish/job/request.hpp>

#include <optional>

namespace planish::job {

/// Plans how the sheet of a report is bent, if that is asked for, and stores the plan, or only what
/// speaks against bending it, in the report. Returns why the part is refused, or why the request
/// cannot be met.
std::optional<Error> plan_strokes(Report& report, const Bending& bending, const Progress& progress);

}  // namespace planish::job
