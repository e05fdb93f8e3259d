#pragma once

#include "make_arguments.hpp"
#include "unfold_arguments.hpp"

#include <planish/base/result.hpp>
#include <planish/job/connect.hpp>
#include <planish/job/unfold.hpp>

namespace planish::cli {

/// The request of a command line, with bend table and rules file read. Errors: `cannot_read`,
/// `invalid_input`.
Result<job::UnfoldRequest> request_of(const UnfoldArguments& arguments);
Result<job::MakeRequest> request_of(const MakeArguments& arguments);

}  // namespace planish::cli
