#pragma once

#include <planish/job/task.hpp>

namespace planish::job {

/// The task of docs/extending.md: counts the bends of whatever a maker makes of the input, or with
/// "openings": true its openings.
Task count_task();

}  // namespace planish::job
