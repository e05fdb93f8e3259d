#pragma once

#include <planish/base/code.hpp>

/// The codes with which this module refuses (formats.md#reason).
namespace planish::code {

inline constexpr ErrorCode no_such_face{"no_such_face", ExitStatus::usage,
                                        "the option names a face that the body does not have"};
inline constexpr ErrorCode closed_loop{
    "closed_loop", ExitStatus::refused,
    "flanges and bends form a closed loop, and nothing opens it"};
inline constexpr ErrorCode not_a_sheet{
    "not_a_sheet", ExitStatus::refused,
    "no two skins lie at a constant distance: a solid block, a casting, a machined part"};
inline constexpr ErrorCode overlap{"overlap", ExitStatus::refused,
                                   "the flat pattern covers itself"};
inline constexpr ErrorCode pattern_wrong{
    "pattern_wrong", ExitStatus::refused,
    "the pattern disagrees with the solid by more than can be trusted"};
inline constexpr ErrorCode invalid_sheet{"invalid_sheet", ExitStatus::internal,
                                         "a sheet breaks a rule of `check`: a defect of its maker"};

}  // namespace planish::code
