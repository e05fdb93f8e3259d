#pragma once

#include "schema.hpp"

#include <planish/job/artifact.hpp>
#include <planish/job/run.hpp>

#include <vector>

namespace planish::job {

/// An object with options of any maker; each may be null, as if it were left out.
Schema options_schema(OptionFiles files);
/// A request to `run`.
Schema request_schema(const Catalogue& catalogue);

/// Enters the members of a checked "options" object.
OptionValues values_of(const Json& options);

}  // namespace planish::job
