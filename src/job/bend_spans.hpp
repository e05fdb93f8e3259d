#pragma once

#include <planish/job/connect.hpp>

#include <vector>

namespace planish::job {

/// Bends that hold but that a shop would ask about, with figures and their places in the pattern:
/// `round_the_back`, `long_span`, `unused_edge`, `edges_beside`, `shorter_bend`
/// (formats.md#checks).
std::vector<Finding> span_findings(const ConnectReport& report);

/// What was cut off plates that touch, and where they touch without being joined:
/// `plates_trimmed`, `joint_left_open`.
std::vector<Finding> trim_findings(const Connection& connection);

}  // namespace planish::job
