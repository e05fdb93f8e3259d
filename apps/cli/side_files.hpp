#pragma once

#include "unfold_arguments.hpp"

#include <planish/base/result.hpp>
#include <planish/job/unfold.hpp>

#include <string>

namespace planish::cli {

/// The request of a command line, with bend table and rules file read. Errors: `cannot_read`,
/// `invalid_input`.
Result<job::UnfoldRequest> request_of(const UnfoldArguments& arguments);

}  // namespace planish::cli
