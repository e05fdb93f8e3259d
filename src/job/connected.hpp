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

/// What `connect_plates` does once the plates are joined: folded solid, flat pattern, certificate
/// and findings, all entered in the report.
std::optional<Error> finish(ConnectReport& report, Connection connection,
                            const AllowanceRule& allowance, const PatternChecks& checks,
                            const Progress& progress);

/// The rule for K: of the request, of the file, or the default.
AllowanceRule allowance_of(const PlatesFile& file, const ConnectRequest& request);

}  // namespace planish::job
