#pragma once

#include "lay_flat.hpp"

#include <planish/base/result.hpp>
#include <planish/connect/connect.hpp>
#include <planish/job/connect.hpp>

#include <string>

namespace planish::job {

/// What `connect_plates` does once the plates are joined: folded solid, flat pattern, certificate
/// and findings, all entered in the report.
std::optional<Error> finish(ConnectReport& report, Connection connection,
                            const AllowanceRule& allowance, const PatternChecks& checks,
                            const Progress& progress);

/// The rule for K: of the request, of the file, or the default.
AllowanceRule allowance_of(const PlatesFile& file, const Request& request);

}  // namespace planish::job
