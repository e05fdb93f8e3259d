#pragma once

#include <planish/base/progress.hpp>
#include <planish/base/result.hpp>
#include <planish/brep/step.hpp>
#include <planish/job/report.hpp>
#include <planish/sheet/sheet.hpp>

#include <optional>
#include <string>

namespace planish::job {

/// Makes the folded solid of a sheet; its volume is stored in the sheet. If no solid can be made,
/// `solid` says why, the report gets a warning and the sheet no volume. Returns an error only if
/// cancelled.
std::optional<Error> fold(Report& report, Sheet& sheet, const Sheet& to_fold, Result<Body>& solid,
                          const Progress& progress);

/// Notes in the report that there is no solid, and why.
void leave_unfolded(Report& report, const Error& why, Result<Body>& solid);

/// The solid as STEP text, which has been read back and has its volume; or why there is none.
Result<std::string> checked_step(const Result<Body>& solid);

/// The error, its place in the file (a JSON pointer) preceded by the file's name.
Error placed(Error error, const std::string& name);

/// The name of an input file in places: its path as given.
std::string place_name(const std::string& input);

}  // namespace planish::job
