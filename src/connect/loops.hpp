#pragma once

#include "assemble.hpp"

#include <planish/base/result.hpp>

namespace planish::connect_detail {

/// Bends that close a loop of plates are kept if the loop lies flat. Error: `bend_loop`, at the
/// first bend that closes one that does not.
Result<void> check_loops(const Parts& parts, const Assembled& made, double k_factor);

}  // namespace planish::connect_detail
