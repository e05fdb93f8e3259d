#pragma once

#include "lay_flat.hpp"

#include <planish/base/result.hpp>
#include <planish/connect/connect.hpp>
#include <planish/job/connect.hpp>

namespace planish::job {

/// The rest of `connect_plates` once the plates are joined: adds folded solid, flat pattern,
/// certificate and findings to the report.
std::optional<Error> finish(ConnectReport& report, Connection connection,
                            const AllowanceRule& allowance, const PatternChecks& checks,
                            const Progress& progress);

/// The rule for K: the request's, the file's, or the default.
AllowanceRule allowance_of(const PlatesFile& file, const Request& request);

}  // namespace planish::job
