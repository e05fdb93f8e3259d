#pragma once

#include <planish/base/code.hpp>

/// The codes with which this module refuses (formats.md#reason).
namespace planish::code {

inline constexpr ErrorCode no_input{"no_input", ExitStatus::unreadable,
                                    "a batch has nothing to work on"};
inline constexpr ErrorCode worker_died{"worker_died", ExitStatus::unreadable,
                                       "the process that worked on a part of a batch ended"};
inline constexpr ErrorCode time_limit{"time_limit", ExitStatus::refused,
                                      "a part of a batch took longer than its time limit"};

}  // namespace planish::code
