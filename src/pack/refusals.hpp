#pragma once

#include <planish/base/result.hpp>

/// The sentences with which `pack` refuses.
namespace planish::refuse {

// Parts and files.
constexpr Refusal quantity_twice{
    code::bad_option,
    "{@line} of `materials` gives the quantity of {part}, and so does the list that names it.",
    "Leave one of them out."};
constexpr Refusal made_already{
    code::bad_option, "`{option}` says how parts are made, but those in {folder} are finished.",
    "Leave it out, or give the inputs of that batch."};
constexpr Refusal piece_unread{code::cannot_read, "{folder}: {reason}", "Run the batch again."};
constexpr Refusal zip_too_large{
    code::cannot_write,
    "The pack is too large for a zip file, which holds at most 4 GB and 65,535 files.",
    "Leave out --zip."};
constexpr Refusal not_deflated{code::internal, "Zlib could not deflate a file of the pack."};

}  // namespace planish::refuse
