#pragma once

#include "lay_flat.hpp"

#include <planish/base/result.hpp>
#include <planish/connect/connect.hpp>
#include <planish/job/connect.hpp>

#include <string>

namespace planish::job {

/// A report that says no more than what was asked; lengths in `unit` where the request leaves it
/// open.
ConnectReport begun(const ConnectRequest& request, LengthUnit unit);

/// A solid made of a sheet: its STEP text, and its volume as the kernel measures it when it reads
/// that text.
struct FoldedSolid {
  std::string step;
  double volume = 0.0;  ///< mm³
};

/// Errors: those of `folded_solid_step` and `read_step_text`.
Result<FoldedSolid> folded_solid(const Sheet& sheet, const std::string& name,
                                 const Progress& progress);

/// What `connect_plates` does once the plates are joined: folded solid, flat pattern, certificate
/// and findings, all entered in the report.
std::optional<Error> finish(ConnectReport& report, Connection connection,
                            const AllowanceRule& allowance, const PatternChecks& checks,
                            const Progress& progress);

/// The rule for K: of the request, of the file, or the default.
AllowanceRule allowance_of(const PlatesFile& file, const ConnectRequest& request);

/// The error with the place in the file (a JSON pointer) behind the file's name.
Error placed(Error error, const std::string& name);

}  // namespace planish::job
