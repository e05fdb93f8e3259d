#pragma once

#include "arguments.hpp"

#include <planish/base/result.hpp>

#include <optional>

namespace planish::cli {

/// What contradicts in arguments that are each valid; empty if nothing does. Options of a request
/// are checked by `OptionValues`.
std::optional<Error> contradiction_in(const job::Catalogue& catalogue, const Arguments& arguments);

}  // namespace planish::cli
