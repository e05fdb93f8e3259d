#pragma once

#include <planish/base/progress.hpp>
#include <planish/base/result.hpp>
#include <planish/brep/step.hpp>

#include <filesystem>
#include <string>

namespace planish::job {

/// Reads the STEP file, or standard input for "-".
Result<StepFile> read_input(const std::filesystem::path& input, const Progress& progress);

/// Index in `file.bodies` of the body that `wanted` names by number (1-based) or by name; empty
/// means the only one. Errors: `no_such_body`, whose message lists the bodies.
Result<int> choose_body(const StepFile& file, const std::string& wanted);

}  // namespace planish::job
