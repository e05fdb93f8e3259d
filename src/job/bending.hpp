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

/// The press brake and its tools: those given, or the common ones.
const BrakeTools& tools_of(const Bending& bending);

/// The bends of these ids. Errors: `bad_option` for one that the pattern does not have.
Result<std::vector<BendId>> bends_named(const Report& report,
                                        const std::vector<std::string>& names);

/// Why there is no plan: no order is possible, or none was found.
Told cannot_be_bent(const Report& report, const Plan& plan, const Bending& bending);
Told no_plan_found(const Plan& plan);

}  // namespace planish::job
