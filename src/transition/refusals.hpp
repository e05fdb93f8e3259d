#pragma once

#include <planish/base/message.hpp>
#include <planish/transition/codes.hpp>

/// The sentences with which transition refuses.
namespace planish::refuse {

constexpr Refusal cancelled{code::cancelled, "Making the transition was cancelled."};

// Values of the request and of options.
constexpr Refusal bad_value{code::invalid_input, "{name} is {value:6}, which is out of range.",
                            "Set it to {range}."};
constexpr Refusal bad_transition_option{
    code::bad_option, "{name} is {value}, which is out of range.", "Set it to {range}."};
constexpr Refusal bad_press_lines{code::invalid_input,
                                  "The press lines have no count, largest angle or chord above 0.",
                                  "Set one of them."};
constexpr Refusal too_many_press_lines{
    code::invalid_input, "A bend would be pressed on {lines:line}; at most {most} are possible.",
    "Set a smaller count, or a larger angle or chord."};
constexpr Refusal frame_not_finite{code::invalid_input,
                                   "A coordinate of the frame is not a finite number.",
                                   "Give it finite numbers."};
constexpr Refusal too_large{
    code::invalid_input,
    "The profiles are {size} wide or apart, more than the {most} that is possible.",
    "Check the unit of the file."};

// Profiles. Their points are in their own plane.
constexpr Refusal few_points{code::too_few_corners,
                             "The profile has {points:point}; it needs 3 or more.",
                             "Add the missing points."};
constexpr Refusal ridge_first{code::too_few_corners,
                              "The first profile has {points:point}; only the second one may be a "
                              "ridge or an apex.",
                              "Exchange from and to."};
constexpr Refusal point_not_finite{code::invalid_input,
                                   "A coordinate of point {point} is not a finite number.",
                                   "Give each point two finite numbers."};
constexpr Refusal point_repeated{code::repeated_corner,
                                 "Points {point} and {next} lie at the same place, ({x:6}, {y:6}).",
                                 "Leave one of them out; profiles close by themselves."};
constexpr Refusal profile_crosses_itself{code::self_crossing,
                                         "The profile crosses itself at ({x:6}, {y:6}).",
                                         "Move its points, or put them in order."};
constexpr Refusal no_area{code::invalid_input, "The profile encloses no area.",
                          "Move its points apart."};
constexpr Refusal turns_inwards{
    code::profile_not_convex,
    "The profile is not convex: at corner {corner}, ({x:6}, {y:6}), it turns inwards by {angle}.",
    "Divide it into convex profiles."};
constexpr Refusal spline_turns_inwards{
    code::profile_not_convex,
    "The spline is not convex at ({x:6}, {y:6}), between points {point} and {next}.",
    "Move or add points."};
constexpr Refusal radius_too_large{
    code::invalid_input, "The radius of the corners is {radius:6}, which is out of range.",
    "Set it to a value from 0 to half of the shorter side, {most:6}."};
constexpr Refusal obround_too_short{
    code::invalid_input,
    "The length of {length:6}, over both half circles, is less than the width of {width:6}.",
    "Swap them, or set a larger length."};

// Seams.
constexpr Refusal no_such_edge{code::unknown_seam,
                               "The first profile has no edge {number}: its edges are 0 to {last}.",
                               "Name one of these."};
constexpr Refusal no_edges{code::unknown_seam, "The first profile has no edges.",
                           "Place the seam by a parameter from 0 to 1."};
constexpr Refusal no_such_corner{
    code::unknown_seam, "The first profile has no corner {number}: its corners are 0 to {last}.",
    "Name one of these."};
constexpr Refusal no_corners{code::unknown_seam, "The first profile has no corners.",
                             "Place the seam by a parameter from 0 to 1."};
constexpr Refusal bad_parameter{code::unknown_seam,
                                "The seam's parameter is {value:6}, which is out of range.",
                                "Set it to a value from 0 to 1."};
constexpr Refusal no_sides{code::invalid_input,
                           "The first profile has no sides, so there is no piece for each.",
                           "Make 1 or 2 pieces."};

// Where the profiles lie.
constexpr Refusal in_one_plane{code::profiles_meet, "Both profiles lie in the same plane.",
                               "Set their frames apart."};
constexpr Refusal touches_plane{code::profiles_meet,
                                "The {which} profile touches the plane of the other at {@at}.",
                                "Move them apart."};
constexpr Refusal on_both_sides{
    code::profile_hidden,
    "The {which} profile lies on both sides of the plane of the other, by {below} and {above}: a "
    "part of it would be hidden inside the transition.",
    "Move or turn one of them."};
constexpr Refusal one_behind_other{code::profile_hidden,
                                   "The planes that touch both profiles do not follow each other "
                                   "once round: a part of one profile is hidden behind the other.",
                                   "Move or turn one of them."};

// Thickness.
constexpr Refusal thicker_than_radius{
    code::radius_too_small,
    "The thickness is too large: the neutral surface lies {inwards} within the given profile, "
    "whose smallest radius is {radius}.",
    "Use a thinner sheet, or larger radii."};
constexpr Refusal thicker_than_edge{
    code::radius_too_small,
    "The edge from corner {corner} to the next, {length} long, is too short for the thickness: the "
    "neutral surface lies {inwards} within the given polygon.",
    "Use a thinner sheet, or lengthen the edge."};
constexpr Refusal neutral_too_tight{
    code::radius_too_small,
    "The thickness of {thickness} is too large: the neutral surface has a radius of {radius} "
    "and needs more than {least}, the part of the thickness that lies inside it.",
    "Use a thinner sheet, or larger profiles."};
constexpr Refusal no_room_at_corner{
    code::radius_too_small,
    "A sheet of {thickness} is too thick to be folded at {@at}: where bends meet in a corner, they "
    "need {needed} of a line that is {length} long.",
    "Use a thinner sheet."};
constexpr Refusal too_much_cut{
    code::radius_too_small,
    "A sheet of {thickness} is too thick to be folded: corners in which bends meet would have to "
    "be cut until {share} of it is gone.",
    "Use a thinner sheet."};

}  // namespace planish::refuse
