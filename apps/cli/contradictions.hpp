#pragma once

#include "arguments.hpp"

#include <optional>
#include <string>

namespace planish::cli {

/// What is wrong with arguments that are each right by themselves, in one sentence; empty where
/// nothing is. What options of a request say together is left to `OptionValues`.
std::optional<std::string> contradiction_in(const job::Catalogue& catalogue,
                                            const Arguments& arguments);

}  // namespace planish::cli
