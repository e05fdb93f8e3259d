#pragma once

#include <planish/base/code.hpp>

/// The codes with which this module refuses (formats.md#reason).
namespace planish::code {

inline constexpr ErrorCode cannot_draw{"cannot_draw", ExitStatus::unreadable,
                                       "pages cannot be drawn: a library or a font is missing"};

}  // namespace planish::code
