#pragma once

#include "seams.hpp"

#include <planish/base/result.hpp>

#include <vector>

namespace planish::transition_detail {

/// The press lines of a part of a patch, from `from` to `to`; none if it is rolled.
std::vector<RuledPatch::Press> presses_of(const RuledPatch& patch, double from, double to,
                                          const Pressing& pressing);

/// Error: `invalid_input` for more than 2000 lines in one bend, far more than anyone presses.
Result<void> check_presses(const Ring& ring, const std::vector<std::vector<PatchPart>>& pieces,
                           const Pressing& pressing);

}  // namespace planish::transition_detail
