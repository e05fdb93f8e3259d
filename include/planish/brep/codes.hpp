#pragma once

#include <planish/base/code.hpp>

/// The codes with which this module refuses (formats.md#reason).
namespace planish::code {

inline constexpr ErrorCode empty_file{"empty_file", ExitStatus::unreadable,
                                      "the file has no content"};
inline constexpr ErrorCode not_step{"not_step", ExitStatus::unreadable,
                                    "the content is not ISO 10303-21 (STEP)"};
inline constexpr ErrorCode truncated_file{"truncated_file", ExitStatus::unreadable,
                                          "the file starts as STEP but ends early"};
inline constexpr ErrorCode no_solid{"no_solid", ExitStatus::unreadable,
                                    "the file holds no solid body, only wires, points or nothing"};
inline constexpr ErrorCode shell_not_solid{"shell_not_solid", ExitStatus::unreadable,
                                           "the file holds only surfaces or open shells"};
inline constexpr ErrorCode too_far_away{"too_far_away", ExitStatus::unreadable,
                                        "coordinates are too large to compute with"};
inline constexpr ErrorCode kernel_failed{"kernel_failed", ExitStatus::unreadable,
                                         "the CAD kernel gave up with an exception"};
inline constexpr ErrorCode thickness_not_constant{
    "thickness_not_constant", ExitStatus::refused,
    "the body has two skins, but their distance varies"};
inline constexpr ErrorCode doubly_curved{
    "doubly_curved", ExitStatus::refused,
    "a bend or flange curves in two directions: drawn, not bent"};

}  // namespace planish::code
