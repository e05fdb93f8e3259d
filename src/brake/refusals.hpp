#pragma once

#include <planish/base/message.hpp>
#include <planish/brake/codes.hpp>

/// The sentences with which brake refuses.
namespace planish::refuse {

constexpr Refusal checking_cancelled{code::cancelled, "Checking the bend order was cancelled."};
constexpr Refusal ordering_cancelled{code::cancelled, "Ordering the strokes was cancelled."};

// Options.
constexpr Refusal bad_plan_option{code::bad_option, "`{option}` is {value}, which is out of range.",
                                  "Set it to {range}."};
constexpr Refusal begins_with_unknown{code::bad_option,
                                      "`begin_with` names {@bend}, which the sheet does not have.",
                                      "Name bends of the sheet."};
constexpr Refusal no_gauge{code::bad_option,
                           "`gauge_openings` needs a back gauge, and the tools have none.",
                           "Give the tools file machine.gauge, with a nose for small openings."};
constexpr Refusal bad_weight{code::bad_option, "A weight is {value}, which is out of range.",
                             "Set it to 0 or more."};

// An order that is checked.
constexpr Refusal stroke_of_no_bend{code::bad_option, "{@stroke} names no bend.",
                                    "Name the bends that it presses."};
constexpr Refusal no_such_stroke{
    code::bad_option,
    "{@stroke} of the order is impossible: no stroke presses {@bend} in this way.",
    "Use strokes of a plan of this sheet."};
constexpr Refusal pressed_twice{code::bad_option, "{@stroke} presses {@bend} again.",
                                "Press each bend once."};

// Sheets.
constexpr Refusal no_line_to_strike{
    code::no_straight_bend,
    "{@bend} is neither a cylinder nor a cone and has no press lines, so a press brake has no line "
    "to strike.",
    "Give it press lines, or make it a cylinder or a cone."};
constexpr Refusal closes_loop{
    code::unsupported_shape,
    "{@bend} closes a loop of flanges: it could only be bent together with a bend on another line.",
    "Open the loop, or divide the part."};
constexpr Refusal no_tool_bears{
    code::no_tool,
    "{@bend} turns {angle} at an inside radius of {radius} in {thickness}, but there is {why}.",
    "Add such a tool, or change the bend."};
constexpr Refusal rows_slightly_short{
    code::no_tool,
    "{@bend} turns {angle} at an inside radius of {radius} in {thickness}, but there is {why}.",
    "Let the tools be {short} short of each end (`--shortfall`), or add segments.", "shortfall",
    "{shortfall}"};
constexpr Refusal no_tool_bears_large{
    code::no_tool,
    "{@bend} turns {angle} at an inside radius of {radius} in {thickness}, but there is {why}.",
    "Roll it, or add such a tool.", "large_radii", "roll"};

constexpr Refusal press_too_short{code::press_too_small,
                                  "{@bend} is {length} long, but there is {why}.",
                                  "Bend it on a longer press, or divide the part."};
constexpr Refusal press_too_weak{
    code::press_too_small,
    "{@bend}, {length} long in {thickness}, turns {angle}, but there is {why}.",
    "Bend it on a stronger press."};
constexpr Refusal press_too_weak_over_wide{
    code::press_too_small,
    "{@bend}, {length} long in {thickness}, turns {angle}, but there is {why}.",
    "Bend it on a stronger press, or over such a V if its larger radius will do."};
constexpr Refusal press_too_weak_over_usual{
    code::press_too_small,
    "{@bend}, {length} long in {thickness}, turns {angle}, but there is {why}.",
    "Take that V if its larger radius will do, or bend it on a stronger press.", "opening", "{v}"};
constexpr Refusal press_too_weak_for_hem{
    code::press_too_small, "{@bend}, {length} long in {thickness}, is a hem, but there is {why}.",
    "Close it on a stronger press, or leave it open."};
constexpr Refusal press_too_weak_over_wanted{
    code::press_too_small,
    "{@bend}, {length} long in {thickness}, turns {angle}, but there is {why}.",
    "Take a wider V (`--opening`, or `--v choice`), or a stronger press."};

// Tools. `subject` is 'The opening of die "V16"' or 'Die "V16"', since tools are no places; the
// place is the pointer.
constexpr Refusal bad_tool_value{code::bad_tools, "{subject} is {value:6}, which is out of range.",
                                 "Set it to {range}."};
constexpr Refusal no_segments{code::bad_tools, "{subject} has no segments.",
                              "List the lengths of its segments."};
constexpr Refusal no_ears{code::bad_tools, "{subject} has ears of length 0.",
                          "Give the length of the left or the right one, or leave them out."};
constexpr Refusal flat_punch_ears{code::bad_tools, "{subject} is flat and has ears.",
                                  "Leave them out: a hem is closed without."};
constexpr Refusal high_ears{
    code::bad_tools, "{subject} has ears whose feet are {height:6} high, and it is {top:6} itself.",
    "Give the height up to which an ear reaches to its end."};
constexpr Refusal short_ear{
    code::bad_tools, "{subject} has an ear of {length:6} whose body stands back by {reach:6}.",
    "Make the reach no longer than the ear."};
constexpr Refusal no_id{code::bad_tools, "{subject} has no id.", "Give each tool a different id."};
constexpr Refusal same_tool_id{code::bad_tools, "{subject} appears twice.",
                               "Give each tool a different id."};
constexpr Refusal no_tools{code::bad_tools, "There is no {kind}.", "List at least one."};
constexpr Refusal below_tip{code::bad_tools,
                            "{subject} reaches down to z = {z:6}, lower than the tip.",
                            "Keep all of it at z = 0 or above."};
constexpr Refusal above_top{code::bad_tools,
                            "{subject} reaches up to z = {z:6}, higher than its top.",
                            "Keep all of it at z = 0 or below."};
constexpr Refusal no_tip{code::bad_tools, "{subject} has no corner at (0, 0), where the tip is.",
                         "Move it so that its tip is there."};
constexpr Refusal second_corner{code::bad_tools,
                                "{subject} has a second corner at z = 0, ({x:6}, {z:6}).",
                                "Keep the tip alone there, or set the angle to 180°."};
constexpr Refusal not_through_origin{code::bad_tools,
                                     "{subject} does not pass through (0, 0), where the sheet "
                                     "touches it.",
                                     "Move it there."};
constexpr Refusal no_shoulder{
    code::bad_tools, "{subject} is {opening:6}, but its profile has no corner at ({half:6}, 0).",
    "Correct the opening or the profile."};
constexpr Refusal no_left_shoulder{
    code::bad_tools, "{subject} is {opening:6}, but its profile has no corner at (−{half:6}, 0).",
    "Correct the opening or the profile."};
constexpr Refusal not_open{code::bad_tools,
                           "{subject} is {opening:6}, but its profile is not open between "
                           "(−{half:6}, 0) and ({half:6}, 0).",
                           "Correct the opening or the profile."};
constexpr Refusal flat_die_opens{code::bad_tools,
                                 "{subject} is {opening:6}, but a die of 180° is flat.",
                                 "Set the opening to 0, or another angle."};
constexpr Refusal range_ends_early{
    code::bad_tools, "{subject} ends at {to:6}, before it begins at {from:6}.", "Swap them."};
constexpr Refusal few_profile_corners{code::bad_tools,
                                      "{subject} has {corners:corner}; an outline has at least 3.",
                                      "Add the missing corners."};
constexpr Refusal corner_nowhere{code::bad_tools,
                                 "{subject} has a corner that is not finite or lies beyond 10 km.",
                                 "Give its corners finite numbers."};
constexpr Refusal corner_again{code::bad_tools,
                               "{subject} has two corners in a row at ({x:6}, {z:6}).",
                               "Leave one of them out."};
constexpr Refusal profile_crosses{code::bad_tools,
                                  "{subject} crosses or touches itself near ({x:6}, {z:6}).",
                                  "Move its corners, or put them in order."};
constexpr Refusal runs_clockwise{code::bad_tools, "{subject} runs clockwise.",
                                 "List its corners counter-clockwise."};
constexpr Refusal radius_takes_edges{
    code::bad_tools,
    "{subject} is {radius}, which takes {taken} of the edges beside the corner that it rounds; the "
    "profile has {edge} there.",
    "Set a smaller radius."};

}  // namespace planish::refuse
