#pragma once

#include <planish/base/message.hpp>
#include <planish/sheet/codes.hpp>

/// The sentences with which the sheet refuses. Rules of `check` stand beside their tests.
namespace planish::refuse {

// ---- layout and flat pattern

constexpr Refusal root_unknown{code::no_such_face,
                               "The root is face {root} of the sheet, which has {count:face}.",
                               "Name one of them."};
constexpr Refusal k_for_no_bend{code::bad_option,
                                "A K-factor is given for {@bend}, but the sheet has {count:bend}.",
                                "Leave it out."};
constexpr Refusal radius_takes_flanges{
    code::bad_option,
    "Made with an inside radius of {radius}, {@bend} needs {short} less sheet than its flanges "
    "have up to their drawn edges.",
    "Draw it with that radius, or cut it as drawn: it gets that much longer."};
constexpr Refusal tolerance_not_positive{code::bad_option,
                                         "The tolerances of a flat pattern must be above 0 mm."};
constexpr Refusal loop_misses{
    code::closed_loop,
    "The flanges and bends form a closed loop that does not lie flat: it misses by {gap}."};
constexpr Refusal no_outer_contour{
    code::closed_loop, "The sheet has no outer contour: its bends close on themselves."};
constexpr Refusal unconnected{
    code::not_a_sheet, "No bend leads to {@face}: the flanges of the sheet are not all connected."};
constexpr Refusal no_neutral_radius{
    code::bad_option,
    "The neutral surface of {@bend} has no radius: the bend has an inside radius of {radius} and a "
    "K-factor of {k}.",
    "Give it a larger K-factor."};
constexpr Refusal no_room_for_setback{
    code::unsupported_shape,
    "{@face} has no room for the setback of {setback} that its sharp bend of {angle} needs.",
    "Model the bend with a radius."};
constexpr Refusal form_at_rim{
    code::unsupported_shape,
    "A feature ({kind}) reaches the outer contour, where a flat pattern cannot show it."};

// ---- rips

constexpr Refusal no_edge_to_rip{code::bad_option,
                                 "No two faces of the skin that is unfolded meet at {@edge}.",
                                 "Rip an edge at which they do."};
constexpr Refusal rip_in_corner{
    code::bad_option,
    "Walls meet by their outside at {@edge}, so a rip would leave both of them in the corner.",
    "Rip another edge."};
constexpr Refusal rips_part{code::bad_option,
                            "The rips at {@edge} cut the sheet into several parts.",
                            "Leave one of them out."};
constexpr Refusal rip_parts{
    code::bad_option, "The rip at {@edge} cuts the sheet into several parts.", "Rip another edge."};
constexpr Refusal no_rips{code::closed_loop, "No rips along its edges open it."};
constexpr Refusal rips_overlap{code::closed_loop,
                               "Rips along its edges leave a pattern that covers itself.",
                               "In one piece its walls fold out onto each other: make one of them "
                               "a part of its own."};
constexpr Refusal one_rip{code::closed_loop, {}, "Rip {@edge} to open it.", "rip_edges", "{edges}"};
constexpr Refusal many_rips{code::closed_loop,
                            {},
                            "Rip {count:edge} to open it, the first of them {@edge}.",
                            "rip_edges",
                            "{edges}"};

// ---- certificate

constexpr Refusal pattern_empty{code::pattern_wrong, "The flat pattern has no outer contour."};
constexpr Refusal pattern_root_unknown{
    code::pattern_wrong,
    "The root of the flat pattern is face {root} of a sheet that has {count:face}."};
constexpr Refusal pattern_lacks_bend{code::pattern_wrong, "The flat pattern leaves out {@bend}."};
constexpr Refusal curve_tolerance{code::bad_option,
                                  "The curve tolerance is {tolerance}; it must be above 0 mm."};

// ---- cut-outs and slits

constexpr Refusal relief_parts_nothing{code::unsupported_shape,
                                       "The relief at {@at} does not part the material there."};
constexpr Refusal kerf_negative{code::bad_option, "The kerf is {kerf}; it must be 0 mm or more."};
constexpr Refusal stop_hole_negative{
    code::bad_option, "The diameter of the stop holes is {stop_hole}; it must be 0 mm or more."};
constexpr Refusal slit_tolerance{code::bad_option,
                                 "The tolerance is {tolerance}; it must be above 0 mm."};
constexpr Refusal stop_hole_below_kerf{
    code::bad_option,
    "The stop holes have a diameter of {stop_hole}, less than the kerf of {kerf}.",
    "Make them at least as wide."};
constexpr Refusal slit_opens_twice{
    code::unsupported_shape, "The slit from {@from} to {@to} is open in more than one place."};
constexpr Refusal slit_too_wide{
    code::bad_option,
    "The slit from {@from} to {@to} is too wide: there is something {room} beside it.",
    "Choose a smaller kerf or stop hole."};
constexpr Refusal kerf_too_wide{
    code::bad_option, "The kerf of {kerf} is too wide where the slit leaves the sheet at {@at}.",
    "Choose a smaller kerf."};
constexpr Refusal slit_meets_curve{code::unsupported_shape,
                                   "The slit that leaves the sheet at {@at} meets a curve there."};

// ---- allowances

constexpr Refusal bend_thickness{code::bad_option,
                                 "A bend has a thickness of {thickness}; it must be above 0 mm."};
constexpr Refusal bend_radius{code::bad_option,
                              "A bend has an inside radius of {radius}; it must be 0 mm or more."};
constexpr Refusal bend_angle{code::bad_option,
                             "A bend has an angle of {angle}; it must be 0° or more."};
constexpr Refusal k_out_of_range{
    code::bad_option,
    "The K-factor {k} ({source}) is outside [0, 1] for a bend of {angle} with an inside radius of "
    "{radius} and a thickness of {thickness}.",
    "Check the value, its units and whether it is K, BA or BD."};
constexpr Refusal table_without_rows{code::bad_option, "The {table} has no rows."};
constexpr Refusal lengths_by_ratio{code::bad_option,
                                   "The {table} gives lengths by R/T, which has no unit.",
                                   "Give R and T instead."};
constexpr Refusal material_curve{
    code::bad_option,
    "The curve of {material} for {side} must have ascending strains and stresses of at least 0, "
    "not "
    "all of them 0; a power law, a strength above 0 and an exponent from 0 to 1."};

// ---- tables

constexpr Refusal not_plain_text{code::invalid_input,
                                 "The table is not plain text: it holds zero bytes.",
                                 "Save it as \"CSV UTF-8\" instead of Unicode text or a workbook."};
constexpr Refusal open_quote{code::invalid_input, "{@line} opens a quote (\") that is not closed.",
                             "Remove it or add the closing one."};
constexpr Refusal empty_table{code::invalid_input, "The bend table is empty.",
                              "Begin it with a header row such as \"R/T,K\"."};
constexpr Refusal unknown_unit{
    code::invalid_input, "{@line}: the unit in column \"{column}\" is not known.",
    "Give lengths in mm or inch, angles in deg or rad, R/T and K without a unit."};
constexpr Refusal column_twice{
    code::invalid_input, "{@line}: the columns \"{first}\" and \"{second}\" both give {what}.",
    "Keep one of them."};
constexpr Refusal incomplete_header{code::invalid_input,
                                    "{@line}: the header must name R/T, or R and T, and one of K, "
                                    "BA, BD (an angle is optional); it "
                                    "names \"{header}\"."};
constexpr Refusal several_values{
    code::invalid_input, "{@line}: more than one of K, BA and BD is given.", "Keep one of them."};
constexpr Refusal ratio_and_lengths{code::invalid_input,
                                    "{@line}: R/T is given together with R or T.",
                                    "Give R/T alone, or both R and T."};
constexpr Refusal lengths_need_sizes{
    code::invalid_input, "{@line}: BA and BD are lengths and need the columns R and T, not R/T."};
constexpr Refusal cell_missing{code::invalid_input, "{@line}: the value of {column} is missing."};
constexpr Refusal cell_not_a_number{code::invalid_input,
                                    "{@line}: \"{cell}\" in column {column} is not a number.",
                                    "Write 1.5 or 1,5; units belong in the header."};
constexpr Refusal cell_out_of_range{code::invalid_input,
                                    "{@line}: {rule}, but the value is \"{cell}\"."};
constexpr Refusal too_many_fields{code::invalid_input,
                                  "{@line} has {count:field}, but the header names {wanted}.",
                                  "Separate the fields by semicolons if commas are decimal."};
constexpr Refusal no_rows_follow{code::invalid_input, "{@line}: no rows follow the header.",
                                 "Add at least one."};
constexpr Refusal contradicting_rows{
    code::invalid_input,
    "{@line} gives {value:6} for a bend for which {@earlier} gives {earlier_value:6}.",
    "Keep one of the rows: a table is for one material."};

}  // namespace planish::refuse
