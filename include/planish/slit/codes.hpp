#pragma once

#include <planish/base/code.hpp>

/// The codes with which this module refuses (formats.md#reason).
namespace planish::code {

inline constexpr ErrorCode unknown_strip{"unknown_strip", ExitStatus::unreadable,
                                         "the slit sheet does not have this strip"};
inline constexpr ErrorCode unknown_ridge{"unknown_ridge", ExitStatus::unreadable,
                                         "the strip does not have this ridge"};
inline constexpr ErrorCode empty_scan{"empty_scan", ExitStatus::unreadable, "a scan has no points"};
inline constexpr ErrorCode scan_too_large{"scan_too_large", ExitStatus::unreadable,
                                          "a scan has more points than are searched"};
inline constexpr ErrorCode curve_too_short{"curve_too_short", ExitStatus::refused,
                                           "a curve is shorter than the slit sheet along it"};
inline constexpr ErrorCode curve_too_long{"curve_too_long", ExitStatus::refused,
                                          "a curve is longer than the slit sheet along it"};
inline constexpr ErrorCode out_of_reach{"out_of_reach", ExitStatus::refused,
                                        "a strip is too short to reach its place"};

}  // namespace planish::code
