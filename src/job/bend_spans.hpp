#pragma once

#include <planish/job/connect.hpp>

#include <vector>

namespace planish::job {

/// Bends that hold but that a shop would ask about, with figures and their places in the pattern:
/// `round_the_back`, `long_span`, `unused_edge`, `edges_beside` (formats.md#checks).
std::vector<Finding> span_findings(const ConnectReport& report);

}  // namespace planish::job
