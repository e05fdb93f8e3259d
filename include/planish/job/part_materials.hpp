#pragma once

#include <planish/job/request.hpp>

#include <optional>

namespace planish::job {

/// What is wrong with a list of materials for many parts and a shop that does not have one of them.
/// For a single part its own row alone matters.
std::optional<Error> unstocked(const Request& request);

}  // namespace planish::job
