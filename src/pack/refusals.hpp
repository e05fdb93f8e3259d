#pragma once

#include <planish/base/result.hpp>

/// The sentences with which `pack` refuses.
namespace planish::refuse {

// Rates. `file` is their file.
constexpr Refusal rates_no_object{code::invalid_input, "{file}: the rates file is no JSON object."};
constexpr Refusal not_rates{
    code::invalid_input,
    "{file}: {@field} is wrong: a rates file has \"format\": \"planish/rates\", \"version\": 1."};
constexpr Refusal unknown_rates_key{
    code::invalid_input, "{file}: {@field} is an unknown key or of the wrong type.",
    "The keys are format, version, currency (a text) and materials (an object)."};
constexpr Refusal row_no_object{code::invalid_input,
                                "{file}: {@field} must be an object with the rates of a material."};
constexpr Refusal unknown_rate{code::invalid_input, "{file}: {@field} is an unknown key.",
                               "The rates are {known}."};
constexpr Refusal bad_rate{code::invalid_input, "{file}: {@field} must be a number of at least 0."};
constexpr Refusal no_rates{code::invalid_input, "{file}: {@field} holds no rates."};
constexpr Refusal no_rates_of{
    code::bad_option,
    "{file} has no rates for the material \"{material}\" of {part}; it has {known}."};
constexpr Refusal mass_unknown{code::bad_option,
                               "The mass of {part} is not known, and {file} asks for its kg.",
                               "Give the density of {material} by --materials or --density."};

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
constexpr Refusal pack_unwritten{code::cannot_write, "Cannot write {file}."};
constexpr Refusal zip_too_large{
    code::cannot_write, "The pack is too large for one zip file, which holds 4 GB and 65535 files.",
    "Leave out --zip."};
constexpr Refusal not_deflated{code::internal, "Zlib could not deflate a file of the pack."};

}  // namespace planish::refuse
