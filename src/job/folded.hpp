#pragma once

#include <planish/base/progress.hpp>
#include <planish/base/result.hpp>
#include <planish/job/report.hpp>
#include <planish/sheet/sheet.hpp>

#include <optional>
#include <string>

namespace planish::job {

/// The folded solid of a sheet as STEP text; its volume, as the kernel measures it when it reads
/// that text, is entered in the sheet. Where none can be made the report gets a warning, and the
/// sheet no volume. Comes back only when cancelled.
std::optional<Error> fold(Report& report, Sheet& sheet, const Sheet& to_fold,
                          Result<std::string>& solid, const Progress& progress);

/// Says in the report that there is no solid, and why.
void leave_unfolded(Report& report, const Error& why, Result<std::string>& solid);

/// The error with the place in the file (a JSON pointer) behind the file's name.
Error placed(Error error, const std::string& name);

/// What places in an input file are called: its path, as it was given.
std::string place_name(const std::string& input);

}  // namespace planish::job
