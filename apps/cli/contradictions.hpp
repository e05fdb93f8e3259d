#pragma once

#include "arguments.hpp"

#include <optional>
#include <string>

namespace planish::cli {

/// What contradicts in arguments that are each valid, in one sentence; empty if nothing does.
/// Options of a request are checked by `OptionValues`.
std::optional<std::string> contradiction_in(const job::Catalogue& catalogue,
                                            const Arguments& arguments);

}  // namespace planish::cli
