#pragma once

#include "workpiece.hpp"

#include <vector>

namespace planish::brake_detail {

/// How far inside a part each line is: of the two parts that it joins, the lines of the one that
/// has fewer.
std::vector<int> line_depths(const Workpiece& work);

}  // namespace planish::brake_detail
