#pragma once

#include <planish/base/code.hpp>

/// The codes with which this module refuses (formats.md#reason).
namespace planish::code {

inline constexpr ErrorCode no_such_body{"no_such_body", ExitStatus::usage,
                                        "`body` names a body that the file does not hold"};

}  // namespace planish::code
