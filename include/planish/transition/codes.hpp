#pragma once

#include <planish/base/code.hpp>

/// The codes with which this module refuses (formats.md#reason).
namespace planish::code {

inline constexpr ErrorCode unknown_seam{
    "unknown_seam", ExitStatus::unreadable,
    "the profile does not have the edge or corner named for the seam"};
inline constexpr ErrorCode profile_not_convex{"profile_not_convex", ExitStatus::refused,
                                              "a profile turns inwards somewhere"};
inline constexpr ErrorCode profiles_meet{"profiles_meet", ExitStatus::refused,
                                         "a profile touches the plane of the other, or lies in it"};
inline constexpr ErrorCode profile_hidden{
    "profile_hidden", ExitStatus::refused,
    "a part of a profile would be hidden inside the transition"};

}  // namespace planish::code
