#pragma once

#include "make_arguments.hpp"
#include "unfold_arguments.hpp"

#include <optional>
#include <string>

namespace planish::cli {

/// What is wrong with options that are each right by themselves, in one sentence; none if nothing.
std::optional<std::string> contradiction_in(const UnfoldArguments& arguments);
std::optional<std::string> contradiction_in(const MakeArguments& arguments);

}  // namespace planish::cli
