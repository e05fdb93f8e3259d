#pragma once

#include <planish/base/result.hpp>

/// The sentences with which the Python module refuses.
namespace planish::refuse {

constexpr Refusal not_written_by{code::bad_option,
                                 "{maker} cannot write \"{format}\"; it writes {known}."};

}  // namespace planish::refuse
