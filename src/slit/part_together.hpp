#pragma once

#include "descend.hpp"
#include "snapshot.hpp"

#include <vector>

namespace planish::slit_detail {

/// Parts strips that run into each other, at least one of which has moved: those that have moved
/// give way together, where they overlap one lies on the other. Returns the iterations taken.
int part_together(Snapshot& now, const std::vector<int>& moved, const DescentOptions& options);

}  // namespace planish::slit_detail
