#pragma once

#include <planish/base/result.hpp>
#include <planish/transition/transition.hpp>

namespace planish::transition_detail {

/// Whether the numbers of a request are usable. Error: `invalid_input`.
Result<void> check_request(const TransitionSpec& spec);

}  // namespace planish::transition_detail
