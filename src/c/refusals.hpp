#pragma once

#include <planish/base/result.hpp>

/// The sentences with which `c` refuses.
namespace planish::refuse {

constexpr Refusal options_too_short{
    code::bad_option, "The member planish_options.size must be at least {least}, not {size}.",
    "Begin with PLANISH_OPTIONS_INIT."};
constexpr Refusal where_unknown{
    code::bad_option, "The member planish_options.where must be PLANISH_APART or PLANISH_HERE."};
constexpr Refusal time_limit_wrong{
    code::bad_option,
    "The member planish_options.time_limit must be a number of seconds, at least 0."};
constexpr Refusal no_memory{code::out_of_memory, "There is no memory for a result."};
constexpr Refusal defect{code::internal, "{reason}."};
constexpr Refusal no_request{code::invalid_input, "The request is a null pointer, not JSON."};

}  // namespace planish::refuse
