#pragma once

#include <planish/base/result.hpp>

#include <string_view>

/// The sentences with which `shop` refuses, and its findings.
namespace planish::refuse {

// Shop profiles.
constexpr Refusal one_of_k{code::invalid_input,
                           "{@field} must have exactly one of k, deduction and allowance."};
constexpr Refusal impossible_k{
    code::invalid_input, "{@field} gives a K-factor of {k}, and K is from 0 to 1.",
    "Check it, the angle of {angle}, the inside radius and the thickness."};
constexpr Refusal same_gauge{
    code::invalid_input,
    "{@field} is {thickness}, which cannot be told from the gauge of {other} with a "
    "thickness_tolerance of {tolerance}.",
    "Give one of them, or a smaller tolerance."};
constexpr Refusal same_material{code::invalid_input,
                                "{@field} is \"{name}\", the name of another material too.",
                                "Give each material a name of its own."};
constexpr Refusal no_layer_name{
    code::invalid_input, "{@field} is \"{name}\", which cannot be the name of a layer.",
    "Use up to {most} letters, digits and signs other than {forbidden}."};
constexpr Refusal cut_and_uncut{
    code::invalid_input,
    "{@field} put something that is not cut on \"{layer}\", which has a contour that is cut.",
    "Name different layers."};
constexpr Refusal k_range_reversed{
    code::invalid_input, "{@field} have k_low {low} above k_high {high}.", "Exchange them."};
constexpr Refusal no_built_in_tool{code::invalid_input,
                                   "{@field} is \"{name}\", which is not a built-in tool.",
                                   "Choose from these: {known}."};
constexpr Refusal no_tool_named{code::invalid_input, "{@field} must name a tool."};

// Rules and materials.
constexpr Refusal k_low_too_high{
    code::invalid_input, "{@field} is {low}, above k_high, which is {high}.", "Exchange them."};
constexpr Refusal strain_falls{code::invalid_input,
                               "{@field} has a smaller strain than the point before it.",
                               "List the points by growing strain."};
constexpr Refusal flat_curve{code::invalid_input,
                             "{@field} must reach a strain and a stress above 0."};

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

}  // namespace planish::refuse

/// Findings have no full stop, since lists show them.
namespace planish::say {

constexpr std::string_view gauge_not_stocked =
    "{shop} does not stock {material} of {thickness}; the nearest {verb} {nearest}, and K is not "
    "the shop's";
constexpr std::string_view other_radius =
    "{@bend} has an inside radius of {radius}, but the radius of {shop} for {gauge} of {material} "
    "is {usual}";
constexpr std::string_view other_radii = "{count:bend}: {worst}";
constexpr std::string_view blank_too_large =
    "the blank of {length} × {width} does not lie on the largest sheet of {shop}, {most_length} × "
    "{most_width}";
constexpr std::string_view blank_too_small =
    "the blank of {length} × {width} is smaller than {shop} cuts, {least_length} × {least_width}";
constexpr std::string_view
    too_many_bends = "the part has {count:bend}, and {shop} makes {most} at most";
constexpr std::string_view
    bend_too_long = "{@bend} is {length} long, and {shop} bends {most} at most";

}  // namespace planish::say
