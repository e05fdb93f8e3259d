#pragma once

#include <planish/base/result.hpp>

/// The sentences with which the studio refuses.
namespace planish::refuse {

// Its server.
constexpr Refusal no_random_numbers{code::internal, "The system supplies no random numbers."};
constexpr Refusal file_too_large{code::cannot_read, "{file} is larger than {most}."};
constexpr Refusal file_is_device{code::cannot_read, "{file} is a device, not a file."};
constexpr Refusal not_read{code::cannot_read, "{file} is not read: it has no plain name."};
constexpr Refusal port_taken{
    code::bad_option,
    "The port {port} of {host} is not available: another program uses it, or "
    "it is reserved."};
constexpr Refusal no_answer{code::internal, "The worker gave no answer."};

// Documents and requests about them.
constexpr Refusal no_plain_name{
    code::invalid_input,
    "{kind}: {@field} must name a file that was added to the document, without folders."};
constexpr Refusal file_not_added{code::cannot_read,
                                 "The file {file} was not added to the document."};
constexpr Refusal no_spec{code::bad_option,
                          "The request has no {@field}, which this kind of document needs."};
constexpr Refusal no_such_file{
    code::bad_option,
    "Files of the format \"{format}\" cannot be made from this kind of document."};
constexpr Refusal nested_too_deep{code::invalid_input, "{what} is nested more than {most} deep."};
constexpr Refusal number_too_large{code::invalid_input,
                                   "{what} is not JSON: a number is too large."};
constexpr Refusal request_no_object{code::invalid_input, "The request must be an object."};
constexpr Refusal chord_no_number{code::invalid_input, "{@field} must be a number, not {value}."};
constexpr Refusal chord_out_of_range{code::invalid_input,
                                     "{@field} is {chord}; it must be from {least} to {most}."};
constexpr Refusal unknown_key{code::invalid_input, "A request has no {@field}."};

}  // namespace planish::refuse
