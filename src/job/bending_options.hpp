#pragma once

#include <planish/job/options.hpp>

#include <vector>

namespace planish::job {

/// Options of bending on a press brake: a part of `options()`.
const std::vector<Option>& bending_options();

}  // namespace planish::job
