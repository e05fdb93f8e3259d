#pragma once

#include <planish/base/result.hpp>

/// The sentences with which `drawing` refuses.
namespace planish::refuse {

constexpr Refusal view_damaged{code::invalid_input,
                               "The stored view cannot be read: it is damaged."};

}  // namespace planish::refuse
