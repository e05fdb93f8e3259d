#pragma once

#include <string_view>

/// What findings say, for `tell`: without a capital and without a full stop.
namespace planish::say {

using Sentence = std::string_view;

// The {limit} that a dimension misses, of a warning and of information.
constexpr Sentence needed = "at least {wanted} ({rule}) is needed";
constexpr Sentence usual = "the rule of thumb is {wanted} ({rule})";
constexpr Sentence needed_anyway = "at least {wanted} is needed";
constexpr Sentence usual_anyway = "the rule of thumb is {wanted}";

// How large an opening is.
constexpr Sentence diameter = "Ø {across}";
constexpr Sentence size = "{long:number} × {wide}";

// Flanges and bends.
constexpr Sentence
    low_flange = "the flange at {@bend} is {measured:5} high from the outside of the bend; {limit}";
constexpr Sentence low_web =
    "the flange between {@bend} is {measured:5} high from the outside of the bend; {limit}";
constexpr Sentence small_radius = "the inside radius of {@bend} is {measured:5}; {limit}";
constexpr Sentence narrow_hem = "the hem at {@bend} is {measured:5} wide inside; {limit}";
constexpr Sentence short_return =
    "the return of the hem at {@bend} is {measured:5} long from the outside of the bend; {limit}";
constexpr Sentence odd_k =
    "{@bend} has a K-factor of {measured}{source}; measured ones lie between {low} and {high}";
constexpr Sentence odd_k_of_many =
    "{count:bend} ({@bend} is the first) have a K-factor of {measured}{source}; measured ones lie "
    "between {low} and {high}";

// Reliefs.
constexpr Sentence
    flush_bend = "{@bend} ends flush with an edge at {@at}, where the corner bulges a little";
constexpr Sentence no_relief_at_flush_edge =
    "{@bend} ends flush with an edge at {@at} without relief; it needs one {wanted_width} "
    "({width_rule}) wide and, from the outside of the bend, {wanted_depth} ({depth_rule}) deep";
constexpr Sentence no_relief =
    "{@bend} ends inside an edge at {@at} without relief; it needs one {wanted_width} "
    "({width_rule}) wide and, from the outside of the bend, {wanted_depth} ({depth_rule}) deep";
constexpr Sentence narrow_relief = "the relief of {@bend} at {@at} is {measured:5} wide; {limit}";
constexpr Sentence shallow_relief =
    "the relief of {@bend} at {@at} is {measured:5} deep from the outside of the bend; {limit}";

// Openings.
constexpr Sentence opening_through_bend =
    "the opening {size} at {@opening} is cut through {@bend}; its edges in the bend will be "
    "distorted";
constexpr Sentence opening_in_bend =
    "the opening {size} at {@opening} reaches into {@bend}, where it will be distorted; move it "
    "away or extend it through the whole bend";
constexpr Sentence opening_near_bend =
    "the opening {size} at {@opening} is {measured:5} from the tangent line of {@bend}; {limit}";
constexpr Sentence opening_near_edge =
    "the opening {size} at {@opening} is {measured:5} from the outer edge; {limit}";
constexpr Sentence openings_near =
    "the opening {size} at {@opening} is {measured:5} from the opening {other_size} at {@other}; "
    "{limit}";
constexpr Sentence openings_near_in_thin_sheet =
    "the opening {size} at {@opening} is {measured:5} from the opening {other_size} at {@other}; "
    "{limit}";
constexpr Sentence small_opening = "the opening {size} at {@opening} is {measured:5} wide; {limit}";

// Overlaps.
constexpr Sentence overlaps_itself = "{@part} overlaps itself by {area} in the flat pattern";
constexpr Sentence overlap = "{@part} overlap by {area} in the flat pattern";
constexpr Sentence overlaps_itself_often =
    "{@part} overlaps itself by {area} in {count:place} in the flat "
    "pattern";
constexpr Sentence overlap_often = "{@part} overlap by {area} in {count:place} in the flat pattern";
constexpr Sentence outer_crosses = "the outer contour crosses itself at {@at} in the flat pattern";
constexpr Sentence outer_crosses_often =
    "the outer contour crosses itself at {@at} and {more:more place} in the flat pattern";
constexpr Sentence
    opening_crosses = "the opening at {@opening} crosses itself at {@at} in the flat pattern";
constexpr Sentence opening_crosses_often =
    "the opening at {@opening} crosses itself at {@at} and {more:more place} in the flat pattern";

}  // namespace planish::say
