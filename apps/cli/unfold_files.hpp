#pragma once

#include "unfold_plan.hpp"

#include <planish/job/unfold.hpp>

#include <optional>
#include <vector>

namespace planish::cli {

/// Composes and writes the pattern of a report as `planned.targets` say and enters the names in
/// `report.files`. Nothing is written unless all of them can be composed.
std::optional<Error> write_pattern(job::UnfoldReport& report, const UnfoldPlan& plan);

/// The same for every body that has a pattern, into `plan.folder`.
std::optional<Error> write_patterns(std::vector<job::UnfoldReport>& reports,
                                    const UnfoldPlan& plan);

}  // namespace planish::cli
