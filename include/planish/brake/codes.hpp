#pragma once

#include <planish/base/code.hpp>

/// The codes with which this module refuses (formats.md#reason).
namespace planish::code {

inline constexpr ErrorCode bad_tools{
    "bad_tools", ExitStatus::unreadable,
    "the tools of a press brake contradict each other or are out of range"};
inline constexpr ErrorCode no_straight_bend{
    "no_straight_bend", ExitStatus::refused,
    "no bend has a straight line that a press brake could press"};
inline constexpr ErrorCode no_tool{"no_tool", ExitStatus::refused,
                                   "no tool suits this thickness, radius or hem"};
inline constexpr ErrorCode press_too_small{
    "press_too_small", ExitStatus::refused,
    "the press brake is not long or not strong enough for a bend"};
inline constexpr ErrorCode cannot_bend{"cannot_bend", ExitStatus::refused,
                                       "no order of strokes forms all bends with these tools"};

}  // namespace planish::code
