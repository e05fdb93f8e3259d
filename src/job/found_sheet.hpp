#pragma once

#include <planish/base/progress.hpp>
#include <planish/brep/step.hpp>

#include <vector>

namespace planish::job {

/// `recognize`, where a refusal names a rip only if rips lead to a pattern that does not cover
/// itself. Errors: those of `recognize`, `cancelled`.
Result<Recognized> found_sheet(const Body& body, const std::vector<int>& rips = {},
                               const Progress& progress = {});

}  // namespace planish::job
