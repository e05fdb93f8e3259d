#pragma once

#include <planish/base/code.hpp>

/// The codes with which this module refuses (formats.md#reason).
namespace planish::code {

inline constexpr ErrorCode no_such_body{"no_such_body", ExitStatus::usage,
                                        "`body` names a body that the file does not hold"};
inline constexpr ErrorCode lost_opening{
    "lost_opening", ExitStatus::refused,
    "the solid has openings that the pattern neither cuts nor lists"};
inline constexpr ErrorCode extra_opening{"extra_opening", ExitStatus::refused,
                                         "the pattern has openings that the solid does not have"};
inline constexpr ErrorCode self_intersection{"self_intersection", ExitStatus::refused,
                                             "the folded sheet runs through itself"};

}  // namespace planish::code
