#pragma once

#include <iosfwd>
#include <string_view>

namespace planish {

/// The status a program ends with (formats.md#exit-status).
enum class ExitStatus { done = 0, internal = 1, usage = 2, unreadable = 3, refused = 4 };

/// What went wrong, as a name that scripts branch on. A module declares its own in
/// `planish/<module>/codes.hpp`; those that several modules use are below. Two codes are the same
/// if their names are. Reports, documentation and schemas print `name` and `meaning`
/// (formats.md#reason).
struct ErrorCode {
  std::string_view name;
  ExitStatus status = ExitStatus::internal;
  std::string_view meaning = {};

  friend constexpr bool operator==(const ErrorCode& a, const ErrorCode& b) {
    return a.name == b.name;
  }
  template <typename Traits>
  friend auto& operator<<(std::basic_ostream<char, Traits>& stream, const ErrorCode& code) {
    return stream << code.name;
  }
};

/// Name of a code as reports spell it, e.g. "not_a_sheet".
constexpr std::string_view code_name(const ErrorCode& code) { return code.name; }

/// Exit status of a program that ends with this error.
constexpr int exit_status(const ErrorCode& code) { return static_cast<int>(code.status); }

namespace code {

// The request is wrong.
inline constexpr ErrorCode bad_option{"bad_option", ExitStatus::usage,
                                      "an option's value is unknown or out of range"};
// The input cannot be read or is invalid.
inline constexpr ErrorCode cannot_read{"cannot_read", ExitStatus::unreadable,
                                       "the file is missing or may not be read"};
inline constexpr ErrorCode cannot_write{"cannot_write", ExitStatus::unreadable,
                                        "an output file cannot be written"};
inline constexpr ErrorCode invalid_input{"invalid_input", ExitStatus::unreadable,
                                         "the file is understood but breaks its format"};
inline constexpr ErrorCode too_few_corners{"too_few_corners", ExitStatus::unreadable,
                                           "a polygon has fewer than three corners"};
inline constexpr ErrorCode repeated_corner{"repeated_corner", ExitStatus::unreadable,
                                           "two corners of a polygon coincide"};
inline constexpr ErrorCode self_crossing{"self_crossing", ExitStatus::unreadable,
                                         "a polygon crosses itself"};
inline constexpr ErrorCode crashed{"crashed", ExitStatus::unreadable,
                                   "work in a separate process crashed"};
// Understood, but no flat pattern exists.
inline constexpr ErrorCode radius_too_small{"radius_too_small", ExitStatus::refused,
                                            "the sheet is too thick for the radius of a bend"};
inline constexpr ErrorCode unsupported_shape{
    "unsupported_shape", ExitStatus::refused,
    "the shape is a sheet, but Planish cannot unfold or draw it yet"};
inline constexpr ErrorCode out_of_time{"out_of_time", ExitStatus::refused,
                                       "the allowed time has passed"};
inline constexpr ErrorCode out_of_memory{"out_of_memory", ExitStatus::refused,
                                         "the allowed memory is not enough"};
// Others.
inline constexpr ErrorCode cancelled{"cancelled", ExitStatus::internal, "you asked to stop"};
inline constexpr ErrorCode internal{"internal", ExitStatus::internal,
                                    "a defect of Planish or of its CAD kernel"};

}  // namespace code
}  // namespace planish
