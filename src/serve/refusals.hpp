#pragma once

#include <planish/base/result.hpp>

/// The sentences with which `serve` refuses.
namespace planish::refuse {

constexpr Refusal stopped{code::cancelled, "Cancelled."};
constexpr Refusal worker_defect{code::internal, "{reason}."};
constexpr Refusal maker_given{code::invalid_input,
                              "{@field} must be left out: the method names the maker."};
constexpr Refusal writes_nothing{code::bad_option, "{tool} writes no files.",
                                 "Leave {@field} out."};
constexpr Refusal writes_no_object{code::invalid_input,
                                   "{@field} must be an object with the path of each artifact."};
constexpr Refusal no_path{code::invalid_input, "{@field} must be the path of a file."};
constexpr Refusal standard_input_taken{
    code::bad_option,
    "{@field} must be the path of a file or its content: standard input carries the requests."};
constexpr Refusal too_long{code::invalid_input, "The message is longer than 256 MiB.",
                           "Give the path of the file instead of its content."};
constexpr Refusal no_length{code::invalid_input,
                            "The headers have no Content-Length, so the next message cannot be "
                            "found and no more are read."};
constexpr Refusal no_such_schema{code::bad_option, "There is no schema {name}.",
                                 "Name one of these: {known}."};

}  // namespace planish::refuse
