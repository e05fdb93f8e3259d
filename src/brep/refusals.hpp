#pragma once

#include <planish/base/message.hpp>
#include <planish/brep/codes.hpp>
#include <planish/sheet/codes.hpp>

/// The sentences with which brep refuses.
namespace planish::refuse {

// ---- files

constexpr Refusal empty_file{code::empty_file, "{file} is empty.", "Export the part again."};
constexpr Refusal not_step{code::not_step,
                           "{file} is not a STEP file: it does not start with ISO-10303-21.",
                           "Export the part as STEP AP203, AP214 or AP242."};
constexpr Refusal file_ends_early{
    code::truncated_file,
    "{file} ends in the middle: END-ISO-10303-21 is missing after {count:byte}.",
    "Copy or export it again."};
constexpr Refusal shape_ends_early{code::truncated_file,
                                   "{file} ends in the middle of its B-rep: it was cut short.",
                                   "Copy or export it again."};
constexpr Refusal damaged_archive{code::truncated_file,
                                  "{file} is packed, and damaged or cut short: it cannot be "
                                  "unpacked.",
                                  "Copy or export it again."};
constexpr Refusal archive_without_step{
    code::not_step,
    "{file} is an archive without a STEP file (.step, .stp, .p21): it holds {count:other file}.",
    "Pack the part as STEP AP203, AP214 or AP242."};
constexpr Refusal archive_of_several{code::invalid_input,
                                     "{file} is an archive of {count:STEP file}.",
                                     "Name one of them, such as {first}, or give the archive to "
                                     "`planish batch`, which takes all."};
constexpr Refusal not_in_archive{code::cannot_read, "The archive {file} has no file {entry}."};
constexpr Refusal strange_archive{
    code::invalid_input,
    "{file} holds {entry} encrypted, or packed by another method than deflate.", "Unpack it."};
constexpr Refusal unpacks_too_large{code::invalid_input, "{file} unpacks to more than {most}.",
                                    "Unpack it yourself."};
constexpr Refusal holds_nothing{code::no_solid, "{file} holds no geometry.",
                                "Export the part as a solid."};
constexpr Refusal no_shape{code::no_solid, "{file} holds no shape that can be read.",
                           "Export a solid body."};
constexpr Refusal no_solid{code::no_solid, "{file} holds no solid body.",
                           "Export the part as a solid."};
constexpr Refusal surfaces_only{code::shell_not_solid,
                                "{file} holds {count:surface body/surface bodies} but no solid.",
                                "Knit the surfaces into a solid and export again."};
constexpr Refusal broken_syntax{
    code::invalid_input, "{file} cannot be read: its STEP syntax is broken.", "Export it again."};
constexpr Refusal damaged_shape{code::invalid_input,
                                "{file} is a damaged B-rep: the CAD kernel finds no shape in it.",
                                "Export it again."};
constexpr Refusal shape_too_far_away{
    code::too_far_away,
    "{file} reaches {reach} from the origin, but nothing can be computed beyond {limit}: a number "
    "in it is damaged, or its unit is wrong.",
    "Move the part to the origin and export it again."};
constexpr Refusal point_too_far_away{
    code::too_far_away,
    "{file} has a point {reach} from the origin, but nothing can be computed beyond {limit}: a "
    "number in it is damaged, or its unit is wrong.",
    "Move the part to the origin and export it again."};
constexpr Refusal is_folder{code::cannot_read, "{file} is a folder, not a STEP file."};
constexpr Refusal cannot_open{code::cannot_read, "{file} cannot be opened: {why}."};
constexpr Refusal reading_stopped{code::cancelled, "Stopped while reading {file}."};

// ---- recognition

constexpr Refusal tolerance_of_recognition{
    code::bad_option, "The {what} tolerance is {tolerance}; it must be above 0."};
constexpr Refusal too_narrow{
    code::not_a_sheet,
    "The body is {thickness} thick and only about {width} wide: a bar, wire or profile, not a "
    "sheet.",
    "If it is cut or bent from sheet, set `thickness` to that of the sheet."};
constexpr Refusal a_block{code::not_a_sheet,
                          "The body is {thickness} thick and only about {width} wide: a bar, block "
                          "or profile, not a sheet."};
constexpr Refusal milled_off{
    code::not_a_sheet,
    "The body fits a sheet of {thickness}, its thickness at the rim, of which {share} is milled "
    "off: it was not made of sheet alone.",
    "If it is milled from such a sheet, set `thickness` to that of the sheet."};
constexpr Refusal volume_unexplained{
    code::not_a_sheet,
    "A sheet of {thickness} accounts for {share} of the body's volume: the body is not made of one "
    "sheet."};
constexpr Refusal no_opposite_faces{
    code::not_a_sheet,
    "No two faces lie opposite each other with material between them: this is not a sheet."};
constexpr Refusal no_common_thickness{
    code::not_a_sheet,
    "No two faces lie opposite each other at one thickness: this is not a sheet."};
constexpr Refusal nothing_opposite{code::not_a_sheet,
                                   "Nothing lies opposite {@face}, the largest of its skin, at the "
                                   "thickness of the others: this is "
                                   "not a sheet."};
constexpr Refusal skins_run_together{
    code::unsupported_shape,
    "The two skins of the sheet run into each other at {@face} without a cut edge between them."};
constexpr Refusal drawn_face{code::doubly_curved,
                             "{@face} ({kind}) is curved in two directions: it was drawn or "
                             "formed, not bent, and has no flat "
                             "pattern."};
constexpr Refusal other_thickness{
    code::thickness_not_constant,
    "The material below {@face}, which continues {@skin}, is not {thickness} thick."};
constexpr Refusal beyond_sheet{
    code::not_a_sheet,
    "At {@face} the body extends beyond the sheet of {thickness}: it is not made of one sheet."};
constexpr Refusal flange_divided{
    code::unsupported_shape,
    "{@face} are one flange, which a groove or pocket divides that crosses the tangent line of a "
    "bend and does not go through.",
    "Leave it out of the solid: it is milled after cutting."};
constexpr Refusal recess_at_rim{
    code::not_a_sheet, "The recess at {@face} cuts into the outer contour on one skin only."};
constexpr Refusal curved_joint{
    code::doubly_curved,
    "{@face} meet smoothly along a line that curves by {off}: no flat blank can be bent into that "
    "shape."};
constexpr Refusal unfit_borders{
    code::unsupported_shape,
    "The borders of the sheet's faces do not fit together, as in damaged files. {rule}",
    "Check the solid in a CAD program and export it again."};

// ---- folded solids and meshes

constexpr Refusal no_inside_radius{
    code::unsupported_shape,
    "{@bend} has an inside radius of {radius}; a solid needs one above 0 mm."};
constexpr Refusal no_reference_radius{
    code::unsupported_shape,
    "The reference surface of {@bend} has a radius of {radius}; it must be above 0 mm."};
constexpr Refusal curved_border_at_mitre{
    code::unsupported_shape,
    "A curved border ends at a sharp bend at {@at}, where only straight ones can be mitred.",
    "Give the bend an inside radius."};
constexpr Refusal border_shorter_than_mitres{
    code::unsupported_shape,
    "A border of {length} at {@at} is shorter than the mitres of the sharp bends at its ends.",
    "Give the bends an inside radius."};
constexpr Refusal mitre_too_long{code::unsupported_shape,
                                 "A sharp bend at {@at} turns by more than 168°, so its mitre "
                                 "would be longer than ten times the "
                                 "thickness.",
                                 "Give it an inside radius."};
constexpr Refusal chord_not_positive{code::bad_option,
                                     "The chord of a mesh is {chord}; it must be above 0 mm."};
constexpr Refusal corner_missing{code::invalid_input,
                                 "A triangle has a corner that does not exist."};
constexpr Refusal no_area{code::invalid_input, "A triangle at {@at} has no area."};
constexpr Refusal empty_mesh{code::invalid_input, "The mesh is empty."};
constexpr Refusal open_mesh{code::invalid_input,
                            "The mesh is not closed between {@from} and {@to}."};
constexpr Refusal mesh_inside_out{code::invalid_input,
                                  "The mesh encloses {volume}: a part of it is inside out."};

// ---- the CAD kernel

constexpr Refusal kernel_failed{code::kernel_failed, "The CAD kernel failed ({what})."};
constexpr Refusal kernel_memory{code::out_of_memory,
                                "The CAD kernel needs more memory than there is."};
constexpr Refusal solid_inside_out{
    code::internal, "The folded solid has a volume of {volume}: its faces point inwards."};
constexpr Refusal solid_invalid{code::internal, "The CAD kernel finds the folded solid invalid."};
constexpr Refusal surface_invalid{code::internal,
                                  "The CAD kernel finds the folded surface invalid."};
constexpr Refusal mesh_solid_invalid{code::internal,
                                     "The CAD kernel finds the solid of the mesh invalid."};
constexpr Refusal no_translation{code::internal,
                                 "The CAD kernel could not translate the solid to STEP."};
constexpr Refusal no_print{code::internal, "The CAD kernel could not print the STEP model."};
constexpr Refusal triangles_open{code::internal,
                                 "The CAD kernel's triangles of the body leave {area} open."};
constexpr Refusal mesh_open{code::internal,
                            "The CAD kernel's mesh of the {what} has {count:open side}."};
constexpr Refusal mesh_volume{
    code::internal,
    "The CAD kernel's mesh of the body has a volume of {found:6}, the body {volume:6}."};
constexpr Refusal mesh_empty{code::internal, "The CAD kernel's mesh of the body has no triangles."};

}  // namespace planish::refuse
