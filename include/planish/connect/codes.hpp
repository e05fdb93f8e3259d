#pragma once

#include <planish/base/code.hpp>

/// The codes with which this module refuses (formats.md#reason).
namespace planish::code {

inline constexpr ErrorCode not_planar{"not_planar", ExitStatus::unreadable,
                                      "the corners of a plate do not lie in one plane"};
inline constexpr ErrorCode unknown_plate{"unknown_plate", ExitStatus::unreadable,
                                         "no plate has this id"};
inline constexpr ErrorCode unknown_edge{
    "unknown_edge", ExitStatus::unreadable,
    "a plate does not have these edges, or they cannot carry one bend together"};
inline constexpr ErrorCode bend_loop{"bend_loop", ExitStatus::unreadable,
                                     "the given bends close a loop of plates"};
inline constexpr ErrorCode not_connected{"not_connected", ExitStatus::unreadable,
                                         "the given bends leave a plate unconnected"};
inline constexpr ErrorCode plates_intersect{"plates_intersect", ExitStatus::refused,
                                            "two plates pass through each other"};
inline constexpr ErrorCode plates_touch{
    "plates_touch", ExitStatus::refused,
    "two plates meet where the bend between them would have to be"};
inline constexpr ErrorCode plates_coplanar{"plates_coplanar", ExitStatus::refused,
                                           "two plates to be joined by a bend lie in one plane"};
inline constexpr ErrorCode plates_offset{"plates_offset", ExitStatus::refused,
                                         "no half-turn joins two plates in parallel planes"};
inline constexpr ErrorCode no_bend_fits{
    "no_bend_fits", ExitStatus::refused,
    "no tangent line leaves both plates whole under the given conditions"};
inline constexpr ErrorCode apex_in_span{"apex_in_span", ExitStatus::refused,
                                        "the apex of a cone lies between its edges"};
inline constexpr ErrorCode no_common_width{
    "no_common_width", ExitStatus::refused,
    "a bend would run over the interior of a plate along its whole width"};
inline constexpr ErrorCode too_far_apart{
    "too_far_apart", ExitStatus::refused,
    "only a bend longer than the largest span would join the plates"};

}  // namespace planish::code
