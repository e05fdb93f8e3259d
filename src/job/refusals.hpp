#pragma once

#include <planish/base/result.hpp>
#include <planish/brake/codes.hpp>
#include <planish/job/codes.hpp>
#include <planish/sheet/codes.hpp>
#include <planish/slit/codes.hpp>

/// The sentences with which `job` refuses.
namespace planish::refuse {

constexpr Refusal overlap_too_large{code::overlap,
                                    "{@part} overlap by {area}, {depth} deep, which is more than a "
                                    "relief may cut away ({most_area} and {most_depth})."};
constexpr Refusal relief_took_other{
    code::pattern_wrong,
    "A relief at {@at} would cut away {removed}, but the sheet has {within} there."};
constexpr Refusal relief_parts_sheet{code::unsupported_shape,
                                     "A relief at {@at} would cut the sheet in two."};
constexpr Refusal relief_takes_bend{
    code::bad_option, "A relief at {@at}, {width} wide, would cut away the whole line of {@bend}.",
    "Make `rip_width` smaller."};
constexpr Refusal volume_wrong{
    code::pattern_wrong,
    "The flat area at K = ½ times the thickness is {ratio} of the solid's volume; it must be 1 "
    "within {allowed}. The pattern cannot be trusted and is not written."};
constexpr Refusal length_wrong{
    code::pattern_wrong,
    "An edge of the solid and its image in the pattern differ in length by {off}. The pattern "
    "cannot be trusted and is not written."};
constexpr Refusal opening_wrong{
    code::pattern_wrong,
    "An opening of the pattern is not what the solid lets through: they differ by {off} all round. "
    "The pattern cannot be trusted and is not written."};
constexpr Refusal outline_wrong{
    code::pattern_wrong,
    "The solid reaches {off} beyond the outline of the pattern, where material would be missing. "
    "The pattern cannot be trusted and is not written."};
constexpr Refusal refold_wrong{code::pattern_wrong,
                               "The contour, folded back, misses the solid's edge by {off}. The "
                               "pattern cannot be trusted and is not written."};

// Requests and their options.
constexpr Refusal cancelled{code::cancelled, "Cancelled."};
constexpr Refusal bad_option_text{code::bad_option, "`{option}` must be {wanted}, not \"{text}\"."};
constexpr Refusal not_an_option{code::bad_option, "`{option}` is not an option of {task}."};
constexpr Refusal options_not_json{code::invalid_input, "The options are not JSON."};
constexpr Refusal one_k{code::bad_option, "`{first}` and `{second}` each say where K comes from.",
                        "Give only one of them."};
constexpr Refusal rules_and_none{code::bad_option, "`rules` and `no_rules` contradict each other.",
                                 "Leave one of them out."};
constexpr Refusal kept_splines{code::bad_option,
                               "`splines` cannot be keep with `r12`, which has no splines.",
                               "Leave one of them out."};
constexpr Refusal ticks_alone{code::bad_option, "`tick_length` goes with `bend_marks` ticks.",
                              "Set `bend_marks` to ticks.", "bend_marks", "ticks"};
constexpr Refusal tangents_unlayered{
    code::bad_option,
    "`tangent_lines` cannot be drawn with `profile` solidedge, which has no layer for bend zones.",
    "Choose another `profile`, or leave `tangent_lines` out."};
constexpr Refusal bad_rip_edges{
    code::bad_option,
    "`rip_edges` must be numbers of edges with commas between them, as in 21,56, not \"{text}\"."};
constexpr Refusal bad_weights{code::bad_option,
                              "`weights` must be like turn_over=3,rotate=2, each a number of at "
                              "least 0 for one of turn_over, "
                              "rotate, tool_change, stroke, ungauged, v, not \"{text}\"."};
constexpr Refusal no_shop_material{
    code::bad_option, "The shop profile has no material \"{material}\": it has {known}."};
constexpr Refusal no_material_or_file{
    code::bad_option,
    "The shop profile has no material \"{material}\" and there is no such file: it has {known}."};
constexpr Refusal name_without_shop{
    code::bad_option, "`{option}` can be the name of a material only together with `shop`.",
    "Give the content of the {kind}."};
constexpr Refusal material_unsaid{code::bad_option, "The shop profile has the materials {known}.",
                                  "Choose one with `material`, or that of each part with "
                                  "`materials`."};
constexpr Refusal row_not_stocked{
    code::bad_option,
    "{file}, {@line}: the shop profile has no material \"{material}\"; it has {known}."};
constexpr Refusal file_not_stocked{
    code::bad_option,
    "The shop profile has no material \"{material}\", which the file of `material` describes; it "
    "has {known}.",
    "Name it in that file as the shop does."};
constexpr Refusal material_not_stocked{
    code::bad_option,
    "The part is made of {material}, which the shop profile does not have; it has {known}.",
    "Choose one with `material`, or that of each part with `materials`."};
constexpr Refusal k_of_transition{
    code::bad_option, "`{option}` gives K by the inside radius, which a transition does not have.",
    "Give one number by `k`."};
constexpr Refusal folder_unsaid{
    code::invalid_input, "{@field} is missing, but the {kind} names the file {file} at {@named}.",
    "Give the folder of that file."};
constexpr Refusal writes_nothing{code::bad_option, "{task} writes no files.",
                                 "Leave {@field} out."};
constexpr Refusal makes_nothing{code::bad_option, "{task} makes nothing that can be kept.",
                                "Name a maker in {@field}, or run the request."};
constexpr Refusal not_written_by{code::bad_option,
                                 "{task} cannot write \"{artifact}\"; it writes {known}."};
constexpr Refusal flag_of_another{code::bad_option, "{@field} belongs to {task}.", "Leave it out."};

// Inputs and outputs.
constexpr Refusal no_json{code::invalid_input, "{file} is not JSON: a number in it is too large."};
constexpr Refusal unknown_format{
    code::invalid_input, "{file} has the format \"{format}\"; the known formats are {known}."};
constexpr Refusal no_known_file{code::invalid_input,
                                "{file} is JSON, but not one of these: {known}."};
constexpr Refusal bad_scan_line{code::invalid_input,
                                "{@line} of a scan must begin with three numbers, x y z."};
constexpr Refusal output_is_input{code::bad_option,
                                  "The output {output} is the input {input}, which would be lost.",
                                  "Name another file."};
constexpr Refusal no_folder{code::cannot_write,
                            "Cannot write {file}: there is no folder {folder}."};
constexpr Refusal two_outputs{code::bad_option, "Two outputs have the name {file}.",
                              "Give each a different name."};
constexpr Refusal not_edited{code::bad_option, "This kind of input cannot be edited.",
                             "Leave {@field} out."};

// Bodies, faces, bends and pieces that are asked for.
constexpr Refusal body_unchosen{code::no_such_body,
                                "The file holds {count} different bodies: {known}.",
                                "Choose one with `body`, by its number or name."};
constexpr Refusal no_body{code::no_such_body,
                          "There is no body \"{body}\"; the bodies are {known}."};
constexpr Refusal not_the_body{code::no_such_body,
                               "There is no body \"{body}\"; the only one is {known}."};
constexpr Refusal body_name_twice{code::no_such_body,
                                  "{@same} are named \"{body}\"; the bodies are {known}.",
                                  "Choose one by its number."};
constexpr Refusal bad_face_number{
    code::bad_option, "`{option}` must be {words} or the number of a face, not \"{text}\"."};
constexpr Refusal not_a_root{code::no_such_face,
                             "{@face} is not a flange of the skin that is unfolded.",
                             "Choose one of {known} as `root`."};
constexpr Refusal not_on_skin{
    code::no_such_face, "{@face} is not on the reference skin, which has {known}.",
    "Set `up` to other to make the opposite skin face up.", "up", "other"};
constexpr Refusal no_bends{code::bad_option, "There is no {@bend}: the sheet has no bends."};
constexpr Refusal no_such_bend{code::bad_option, "There is no {@bend}; the bends are {known}."};
constexpr Refusal no_plan_as_made{code::cannot_bend,
                                  "No order was found that bends the flat pattern as made."};
constexpr Refusal no_time_as_made{
    code::cannot_bend,
    "The time of {seconds} ended before an order was found that bends the flat pattern as made.",
    "Give it more (`--time-limit`)."};
constexpr Refusal made_otherwise_again{
    code::cannot_bend, "For the flat pattern as made other tools are cheaper, which make others."};
constexpr Refusal plan_as_drawn{code::bad_option,
                                "The plan is that of the flat pattern as it is drawn.",
                                "Set `as_made` for both as they are made."};
constexpr Refusal bend_named_twice{code::bad_option, "`fix` names {@bend} twice."};
constexpr Refusal no_such_piece{code::bad_option, "`piece` is {piece}; the last piece is {last}."};
constexpr Refusal not_made{code::bad_option, "{what} cannot be made from this part."};
constexpr Refusal long_order{code::invalid_input,
                             "{@field} has {count:stroke}; at most {most} are allowed."};

// Results.
constexpr Refusal cannot_bend{code::cannot_bend, "{sentence}."};
constexpr Refusal unfolding_crashed{code::crashed, "Unfolding it crashed ({reason})."};
constexpr Refusal step_is_wrong{code::internal,
                                "The folded solid has a volume of {solid:9}, but of {written:9} "
                                "when it is read back from STEP, so the file would be wrong."};
constexpr Refusal pattern_overlaps{code::overlap, "{what}.",
                                   "Set `write_overlapping` to write the pattern anyway."};
constexpr Refusal pattern_overlaps_more{code::overlap, "{what}, and at {more:more place}.",
                                        "Set `write_overlapping` to write the pattern anyway."};
constexpr std::string_view kWriteAnyway = "Set `write_anyway` to write the files all the same.";
constexpr Refusal opening_lost{code::lost_opening, "{what}{others}.", kWriteAnyway};
constexpr Refusal opening_too_many{code::extra_opening, "{what}{others}.", kWriteAnyway};
constexpr Refusal runs_through{code::self_intersection, "{what}{others}.", kWriteAnyway};
constexpr Refusal contours_cross{code::overlap, "Contours cross elsewhere."};
constexpr Refusal strip_turned{
    code::out_of_reach,
    "The end of {@strip} is where it must be, but no folding was found in which it also points the "
    "right way: half a turn is missing.",
    "Turn its direction, its ridge or the second panel around, or leave one of them out."};
constexpr Refusal strip_short{code::out_of_reach,
                              "{@strip} does not reach where it must end: it is {shortfall} short.",
                              "Make it longer, bring the leg curves nearer, or loosen the end."};
constexpr Refusal strips_short{
    code::out_of_reach,
    "{count:strip} do not reach where they must end: {@strip} are {shortfall} short.",
    "Make the strips longer, bring the leg curves nearer, or loosen the ends."};
constexpr Refusal many_strips_short{
    code::out_of_reach,
    "{count:strip} do not reach where they must end: among them, {@strip} are {shortfall} short.",
    "Make the strips longer, bring the leg curves nearer, or loosen the ends."};

// Plates files.
constexpr Refusal same_plate_id{code::invalid_input,
                                "{@field} is \"{id}\", and so is the id of {@other}.",
                                "Give each plate a different id."};
constexpr Refusal many_plates_of_bend{
    code::invalid_input,
    "{@field} names {count} plates: a bend joins two, has a free end (one id) or is a section by "
    "itself ([])."};
constexpr Refusal bend_to_itself{code::invalid_input, "{@field} names {@plate} twice.",
                                 "Name two different plates."};
constexpr Refusal edge_listed_twice{code::invalid_input,
                                    "{@field} is {edge}, which is already in the list."};
constexpr Refusal not_of_this_bend{code::invalid_input,
                                   "{@field} is not a plate of this bend, which has {known}."};
constexpr Refusal two_radii{code::invalid_input, "{@field} and inside_radius are both given.",
                            "Give only one of them."};
constexpr Refusal angle_of_nothing{
    code::invalid_input, "{@field} is 0, which bends nothing.",
    "Give the angle that the section turns, or leave the section out."};
constexpr Refusal angle_follows{
    code::invalid_input,
    "{@field} belongs to a section with a free end; between two plates it follows from their "
    "positions.",
    "Leave it out."};
constexpr Refusal key_of_joins{
    code::invalid_input,
    "{@field} belongs to a bend between two plates; a section has inside_radius or inside_radii, "
    "angle and ends at right angles to its axis.",
    "Leave it out."};
constexpr Refusal length_follows{
    code::invalid_input,
    "{@field} belongs to a section without plates; beside a plate it follows from the plate's "
    "edges.",
    "Leave it out."};
constexpr Refusal nothing_to_join{code::invalid_input, "{@field} is empty.",
                                  "Give plates, or bends that need no plate."};

// Transition and slit files.
constexpr Refusal x_along_normal{code::invalid_input, "{@field} is parallel to the normal.",
                                 "Give a direction in the profile's plane."};
constexpr Refusal no_such_strip{code::invalid_input,
                                "{@field} is {strip}; it must be from 0 to {last}."};
constexpr Refusal aligned_without_strips{
    code::invalid_input, "{@field} goes with scans that name their strips.",
    "Give each scan its strip, or place it where the sheet is and leave align_scan out."};
constexpr Refusal strip_end_twice{code::invalid_input,
                                  "{@field} is {strip}, the same strip as in an earlier end."};
constexpr Refusal panel_of_symmetric{
    code::invalid_input,
    "{@field} is given, but the other half of a symmetric sheet is its mirror image.",
    "Leave it out, or set symmetric to false."};
constexpr Refusal ends_of_symmetric{
    code::invalid_input,
    "{@field} is given, but strips of symmetric sheets end at the symmetry plane.",
    "Leave it out, or set symmetric to false."};
constexpr Refusal ends_and_panel{code::invalid_input,
                                 "{@field} is given, but the strips end at the second panel.",
                                 "Leave one of them out."};
constexpr Refusal material_without_modulus{
    code::invalid_input,
    "The material file states no Young's modulus, and its curve has no straight beginning.",
    "Add young, in N/mm²."};
constexpr Refusal neither_strips_nor_slits{
    code::invalid_input, "{@field} has no strips, and the file has no slits.",
    "Add strips to the sheet, or slits as curves to the file."};
constexpr Refusal strips_and_slits{code::invalid_input,
                                   "{@field} has strips, but slits as curves are given too.",
                                   "Leave one of them out: strips lie between slits."};
constexpr Refusal outline_of_strips{code::invalid_input,
                                    "{@field} is given, but only a sheet with slits as curves has "
                                    "one; other sheets are rectangles.",
                                    "Leave it out, or give slits in place of the strips."};
constexpr Refusal width_or_outline{code::invalid_input,
                                   "{@field} must have a width, or the file an outline, but not "
                                   "both.",
                                   "Give one of them."};
constexpr Refusal smooth_of_energy{
    code::invalid_input,
    "{@field} is given, but strips of least bending energy are not weighed by it.",
    "Leave it out, or set objective to smooth."};

}  // namespace planish::refuse
