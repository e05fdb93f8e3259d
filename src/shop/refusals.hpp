#pragma once

#include <planish/base/result.hpp>

#include <string_view>

/// The sentences with which `shop` refuses, and its findings.
namespace planish::refuse {

// Shop profiles.
constexpr Refusal one_of_k{code::invalid_input,
                           "{@field} must have exactly one of k, deduction and allowance."};
constexpr Refusal impossible_k{
    code::invalid_input, "{@field} gives a K-factor of {k}, but K must be from 0 to 1.",
    "Check it, the angle of {angle}, the inside radius and the thickness."};
constexpr Refusal same_gauge{code::invalid_input,
                             "{@field} is {thickness}, too close to the gauge of {other} to tell "
                             "them apart with a thickness_tolerance of {tolerance}.",
                             "Give one of them, or a smaller tolerance."};
constexpr Refusal same_material{code::invalid_input,
                                "{@field} is \"{name}\", the name of another material.",
                                "Give each material a different name."};
constexpr Refusal no_layer_name{code::invalid_input,
                                "{@field} is \"{name}\", which cannot be the name of a layer.",
                                "Use up to {most} ASCII characters, none of {forbidden}."};
constexpr Refusal cut_and_uncut{
    code::invalid_input, "{@field} put lines that are not cut on layer \"{layer}\", which is cut.",
    "Name different layers."};
constexpr Refusal k_range_reversed{code::invalid_input,
                                   "{@field} have k_low {low} above k_high {high}.", "Swap them."};
constexpr Refusal no_built_in_tool{code::invalid_input,
                                   "{@field} is \"{name}\", which is not a built-in tool.",
                                   "Choose from these: {known}."};
constexpr Refusal no_tool_named{code::invalid_input, "{@field} must name a tool."};

// Rules and materials.
constexpr Refusal k_low_too_high{code::invalid_input,
                                 "{@field} is {low}, above k_high, which is {high}.", "Swap them."};
constexpr Refusal strain_falls{code::invalid_input,
                               "{@field} has a smaller strain than the point before it.",
                               "List the points by growing strain."};
constexpr Refusal flat_curve{code::invalid_input,
                             "{@field} must reach a strain and a stress above 0."};

// Lists of materials. `file` is the list.
constexpr Refusal no_materials{code::invalid_input, "{file}: the list of materials is empty."};
constexpr Refusal no_columns{
    code::invalid_input,
    "{file}, {@line}: the first row of the materials must name the columns part (or colour) and "
    "material, and may name density and quantity."};
constexpr Refusal unknown_column{code::invalid_input,
                                 "{file}, {@line}: a list of materials has no column \"{column}\".",
                                 "The columns are {known}: rename this one, or leave it out."};
constexpr Refusal column_twice{code::invalid_input,
                               "{file}, {@line}: the column {column} is there twice.",
                               "Leave one of them out."};
constexpr Refusal field_without_column{
    code::invalid_input, "{file}, {@line}: \"{text}\" is in a column without a name.",
    "Name the column in the first row, or quote a text that holds the separator."};
constexpr Refusal row_incomplete{
    code::invalid_input, "{file}, {@line}: each row needs a part or a colour, and a material."};
constexpr Refusal bad_colour{
    code::invalid_input, "{file}, {@line}: a colour is written like #c0c0c0, not \"{colour}\"."};
constexpr Refusal bad_density{
    code::invalid_input,
    "{file}, {@line}: the density must be a number above 0, in kg/dm³, not \"{density}\"."};
constexpr Refusal bad_quantity{
    code::invalid_input,
    "{file}, {@line}: the quantity must be a whole number from 1 to {most}, not \"{quantity}\"."};

// Rates. `file` is their file.
constexpr Refusal rates_no_object{code::invalid_input,
                                  "{file}: the rates file is not a JSON object."};
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
                               "The mass of {part} is not known, but {file} has a rate per kg.",
                               "Give the density of {material} by --materials or --density."};

}  // namespace planish::refuse

/// Findings have no full stop, since lists show them.
namespace planish::say {

constexpr std::string_view gauge_not_stocked =
    "{shop} does not stock {material} of {thickness}; the nearest {verb} {nearest}, so K is not "
    "the shop's";
constexpr std::string_view other_radius =
    "{@bend} has an inside radius of {radius}, but the radius of {shop} for {gauge} of {material} "
    "is {usual}";
constexpr std::string_view other_radii = "{count:bend}: {worst}";
constexpr std::string_view blank_too_large =
    "the blank of {length} × {width} does not fit on the largest sheet of {shop}, {most_length} × "
    "{most_width}";
constexpr std::string_view blank_too_small =
    "the blank of {length} × {width} is smaller than the smallest part of {shop}, {least_length} × "
    "{least_width}";
constexpr std::string_view
    too_many_bends = "the part has {count:bend}, but {shop} makes at most {most}";
constexpr std::string_view
    bend_too_long = "{@bend} is {length} long, but {shop} bends at most {most}";

}  // namespace planish::say
