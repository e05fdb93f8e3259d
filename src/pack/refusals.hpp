#pragma once

#include <planish/base/result.hpp>

/// The sentences with which `pack` refuses.
namespace planish::refuse {

// Materials. `file` is their list.
constexpr Refusal no_materials{code::invalid_input, "{file}: the list of materials is empty."};
constexpr Refusal no_columns{
    code::invalid_input,
    "{file}, {@line}: the first row of the materials must name the columns part (or colour) and "
    "material, and may name density."};
constexpr Refusal row_incomplete{
    code::invalid_input, "{file}, {@line}: each row needs a part or a colour, and a material."};
constexpr Refusal bad_colour{
    code::invalid_input, "{file}, {@line}: a colour is written like #c0c0c0, not \"{colour}\"."};
constexpr Refusal bad_density{
    code::invalid_input,
    "{file}, {@line}: the density must be a number above 0, in kg/dm³, not \"{density}\"."};

// Parts and files.
constexpr Refusal piece_unread{code::cannot_read, "{folder}: {reason}", "Run the batch again."};
constexpr Refusal zip_too_large{
    code::cannot_write,
    "The pack is too large for a zip file, which holds at most 4 GB and 65,535 files.",
    "Leave out --zip."};
constexpr Refusal not_deflated{code::internal, "Zlib could not deflate a file of the pack."};

}  // namespace planish::refuse
