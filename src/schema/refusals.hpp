#pragma once

#include <planish/base/result.hpp>

/// The sentences with which `schema` refuses. `what` is "The plates file" or the name of a file.
namespace planish::refuse {

constexpr Refusal cannot_read{code::cannot_read, "Cannot read the {what} {file}: {reason}."};

// Text that is no JSON document of ours.
constexpr Refusal not_json{code::invalid_input,
                           "{what} is not JSON: there is a mistake in {@line}, column {column}.",
                           "Correct it there."};
constexpr Refusal is_step{code::invalid_input, "{what} is not JSON: it is a STEP file."};
constexpr Refusal parser_refuses{code::invalid_input, "{what} is not JSON: {reason}."};
constexpr Refusal too_deep{code::invalid_input,
                           "{what} is nested more than {most} deep in {@line}, column {column}.",
                           "Nest it less deeply."};
constexpr Refusal repeated_key{code::invalid_input,
                               "{what} has the key \"{key}\" twice in one object.",
                               "Keep only one of them."};
constexpr Refusal no_object{code::invalid_input, "{what} must hold one JSON object."};

// Values that break the schema.
constexpr Refusal must_be{code::invalid_input, "{@field} must be {wanted}, not {value}."};
constexpr Refusal must_be_list{code::invalid_input, "{@field} must be a list, not {value}."};
constexpr Refusal wrong_length{code::invalid_input,
                               "{@field} must be {wanted}, not a list of {count}."};
constexpr Refusal must_be_one_of{code::invalid_input, "{@field} must be one of {keys}."};
constexpr Refusal key_missing{code::invalid_input, "{@field} is missing."};
constexpr Refusal unknown_key{code::invalid_input, "{@field} is not a known key.",
                              "The keys known here are {keys}."};
constexpr Refusal too_far{code::invalid_input, "{@field} is more than 1,000 km from the origin.",
                          "Move the parts to the origin."};
constexpr Refusal no_direction{code::invalid_input,
                               "{@field} is [0, 0, 0], which has no direction."};

}  // namespace planish::refuse
