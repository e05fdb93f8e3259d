#pragma once

#include <planish/base/result.hpp>

/// The sentences with which the program refuses.
namespace planish::refuse {

constexpr Refusal or_all_bodies{code::bad_option, "Or take all of them with --all -o FOLDER/."};
constexpr Refusal bad_stock{
    code::bad_option,
    "--nest must be like 3000x1500, length and width of a sheet in mm, not \"{text}\"."};
constexpr Refusal stock_unsaid{code::bad_option,
                               "--gap and --grain belong to --nest, which is not given."};
constexpr Refusal bad_format{code::bad_option, "--format {format} is unknown.",
                             "Choose from these: {known}."};
constexpr Refusal bad_shard{code::bad_option, "--shard must be like 3/64: which one, of how many."};
constexpr Refusal no_such_name{code::bad_option,
                               "There is no {what} \"{name}\"; there are {known}."};
constexpr Refusal no_standard_output{code::cannot_write, "Cannot write to standard output."};
constexpr Refusal no_studio{code::internal,
                            "The studio cannot be started, {reason} ({program}). It must lie "
                            "beside planish, and is not built with PLANISH_STUDIO=OFF."};
constexpr Refusal program_defect{code::internal, "{reason}."};

}  // namespace planish::refuse
