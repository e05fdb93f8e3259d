#pragma once

#include <planish/base/message.hpp>
#include <planish/sheet/codes.hpp>
#include <planish/slit/codes.hpp>

/// The sentences with which slit refuses. Fields of the file are named as they are there
/// ("mould.up").
namespace planish::refuse {

constexpr Refusal cancelled{code::cancelled, "Solving the slit sheet was cancelled."};

// Values out of their range.
constexpr Refusal bad_value{code::invalid_input, "{name} is {value}, which is out of range.",
                            "Set it to {range}."};
constexpr Refusal bad_strip_value{code::invalid_input,
                                  "{name} of {@strip} is {value}, which is out of range.",
                                  "Set it to {range}."};
constexpr Refusal bad_slit_option{code::bad_option, "{name} is {value}, which is out of range.",
                                  "Set it to {range}."};
constexpr Refusal bad_coordinate{
    code::invalid_input, "A coordinate of {what} is not a finite number, or lies beyond {most}.",
    "Give it finite numbers."};
constexpr Refusal bad_number_of_strips{code::invalid_input,
                                       "The sheet has {count:strip}, which is out of range.",
                                       "Give it 1 to {most} strips."};
constexpr Refusal bad_number_of_ridges{code::invalid_input,
                                       "Each strip has {count:ridge}, which is out of range.",
                                       "Set ridges to a number from {least} to {most}."};

// The sheet.
constexpr Refusal symmetric_with_end{
    code::invalid_input,
    "{@strip} has an end of its own, but strips of a symmetric sheet end at its symmetry plane.",
    "Leave the end out."};
constexpr Refusal ends_before_slit{code::invalid_input,
                                   "{@strip} ends at {end:6}, before its slit begins at {start:6}.",
                                   "Lengthen the strip, or begin the slit earlier."};
constexpr Refusal symmetric_with_second_panel{
    code::invalid_input,
    "A symmetric sheet has a second panel, though its other half is its mirror image.",
    "Leave out the second panel, or set symmetric to false."};
constexpr Refusal ends_beyond_panel{
    code::invalid_input,
    "{@strip} ends at {end:6}, beyond the second panel, whose free edge is at {edge:6}.",
    "Shorten the strip, or make the second panel higher."};

// Slits that are curves.
constexpr Refusal slit_without_length{code::invalid_input, "Slit {slit} has no length.",
                                      "Give it two points or more, apart from each other."};
constexpr Refusal slit_across{code::invalid_input,
                              "Slit {slit} begins and ends at {at:6} along the sheet.",
                              "Lead it along the sheet, so that strips lie beside it."};
constexpr Refusal slits_in_line{
    code::invalid_input,
    "Between {one} and {other} no strip lies: one ends before the other begins.",
    "Make them one slit, or let them overlap along the sheet. Strips that are joined several times "
    "on their way cannot be bent."};
constexpr Refusal side_not_straight{
    code::invalid_input,
    "{side} is curved beside the uncut sheet, which begins at {from:6} along it.",
    "Lead it straight along the sheet from there to {end:6}, or end it there too."};
constexpr Refusal joined_to_none{
    code::invalid_input,
    "{@strip} ends at {end:6} along the sheet, where the uncut sheet joins it to no neighbour.",
    "Give its neighbour the same end, right_end to the left of left_end, without a gap between "
    "them; or give the strip an end."};
constexpr Refusal joined_and_ended{code::invalid_input,
                                   "{@strip} has an end, but the uncut sheet joins it to others.",
                                   "Leave out its end, or its left_end and right_end."};
constexpr Refusal joined_without_energy{
    code::bad_option, "Where the uncut sheet lies beyond slits is found by least energy only.",
    "Set objective to energy, or lead the slits to where the strips end."};
constexpr Refusal joined_at_angle{
    code::bad_option,
    "The uncut sheet beyond slits crosses the symmetry plane at a right angle only.",
    "Set end_angle to right_angle, or lead the slits to the symmetry plane."};
constexpr Refusal slit_off_sheet{
    code::invalid_input,
    "Slit {slit} goes to {at:6} along the sheet, which reaches from 0 to {end:6}.",
    "Keep it on the sheet."};
constexpr Refusal slits_cross{code::invalid_input,
                              "The strip between {one} and {other} is cut through: they meet.",
                              "Move them apart."};
constexpr Refusal strip_without_width{code::invalid_input,
                                      "Between {one} and {other} a strip has no width where it "
                                      "begins or ends.",
                                      "Move their ends apart, or keep them in one order."};
constexpr Refusal outline_without_panel{
    code::invalid_input, "The outline does not leave the panel whole.",
    "Lead it from [0, 0] straight along to {height:6}, on to {end:6}, across there, back to "
    "{height:6}, and straight to 0."};

// Curves.
constexpr Refusal bad_number_of_poles{code::invalid_input,
                                      "{curve} has {poles:pole}, which is out of range.",
                                      "Give it 2 to {most} poles."};
constexpr Refusal poles_in_one_place{code::invalid_input, "{curve} has all its poles in one place.",
                                     "Move them apart."};
constexpr Refusal curve_too_tight{code::radius_too_small,
                                  "The leg curve bends with a radius of {radius} at {@at}; the "
                                  "sheet, {thickness} thick, needs {least} or more at its "
                                  "mid-surface.",
                                  "Make the curve wider there, or the sheet thinner."};
constexpr Refusal nothing_to_lean_about{
    code::invalid_input,
    "The leg curve ends where it begins, so there is no line about which its panel could lean.",
    "Set lean to 0, or open the curve."};
constexpr Refusal crosses_symmetry_plane{
    code::invalid_input,
    "The panel on the leg curve meets the symmetry plane: it begins at x = {first} and reaches "
    "{@at}.",
    "Keep the leg curve on one side of x = 0."};
constexpr Refusal seat_curve_without_symmetry{
    code::invalid_input, "A seat curve lies in the symmetry plane, but the sheet is not symmetric.",
    "Leave it out, and place the ends of the strips."};
constexpr Refusal seat_curve_too_short{
    code::curve_too_short,
    "The seat curve is {length:6} long, but the ends of the "
    "strips are {width:6} wide together and would overlap.",
    "Lengthen the curve, make the strips narrower, or set fit to "
    "true to have the curve scaled."};
constexpr Refusal leg_curve_too_short{
    code::curve_too_short,
    "The leg curve is {length:6} long, {missing} too short for the chords of a sheet {width:6} "
    "wide.",
    "Lengthen the curve, make the sheet narrower, or set fit to true to have the curve scaled."};
constexpr Refusal leg_curve_too_long{
    code::curve_too_long,
    "The leg curve is {length:6} long, {rest} too long for the chords of a sheet {width:6} wide.",
    "Shorten the curve, make the sheet wider, or set fit to true to have the curve scaled."};
constexpr Refusal curve_cannot_be_scaled{code::invalid_input,
                                         "The leg curve cannot be scaled to the sheet: at no size "
                                         "do the strips' chords end where it ends.",
                                         "Change its shape, or set fit to false."};

// Wishes.
constexpr Refusal no_such_strip{code::unknown_strip,
                                "There is no {@strip}: the sheet has {count:strip}.",
                                "Name one by its number in the file, from 0 to {last}."};
constexpr Refusal no_such_ridge{code::unknown_ridge,
                                "{@strip} has no {@ridge}: it has {count:ridge}.",
                                "Name one by its number in the file, from 0 to {last}."};
constexpr Refusal anchor_out_of_reach{
    code::out_of_reach,
    "The anchor at {@at} is {missing} out of reach: the way there from the panel is {needed}, but "
    "{@strip} is only {available} long.",
    "Move the anchor, or lengthen the strip."};
constexpr Refusal anchor_beyond_symmetry{
    code::out_of_reach,
    "The anchor at {@at} is {missing} out of reach: the way there from the panel and on to the "
    "symmetry plane is {needed}, but {@strip} is only {available} long.",
    "Move the anchor, or lengthen the strip."};
constexpr Refusal panel_out_of_reach{
    code::out_of_reach,
    "The second panel is {missing} out of reach of {@strip}: its edge is {needed} from that of the "
    "first panel, but the strip is only {available} long.",
    "Move the panels closer, or lengthen the strip."};
constexpr Refusal end_out_of_reach{
    code::out_of_reach,
    "The end of {@strip} is {missing} out of reach: it is {needed} from the edge of the panel, but "
    "the strip is only {available} long.",
    "Move the end, or lengthen the strip."};
constexpr Refusal end_in_symmetry_plane{
    code::bad_option,
    "The end of {@strip} cannot be placed: strips of a symmetric sheet end in its symmetry plane.",
    "Leave its place out, or set symmetric to false."};
constexpr Refusal end_at_second_panel{
    code::bad_option, "The end of {@strip} cannot be placed: the strips end at the second panel.",
    "Leave its place or the second panel out."};
constexpr Refusal no_direction{code::invalid_input,
                               "A direction of the end of {@strip} is zero or not finite.",
                               "Give it a length."};
constexpr Refusal not_at_right_angles{
    code::invalid_input,
    "The direction of the end of {@strip} and its last ridge are {angle} apart.",
    "Set them at right angles."};

// Weight and loads.
constexpr Refusal load_without_material{
    code::invalid_input,
    "{@field} is given, but no material, so nothing says how stiff the sheet is.",
    "Give the material: young, and density for its weight."};
constexpr Refusal gap_at_panel{code::invalid_input,
                               "{@field} is given, but the strips end at a second panel, or where "
                               "the uncut sheet joins them.",
                               "Leave it out: there the sheet sets the gaps."};
constexpr Refusal least_above_most{code::invalid_input,
                                   "The least gap of {@field}, {least}, is above the most, {most}.",
                                   "Give the smaller one first."};
constexpr Refusal load_without_energy{
    code::invalid_input, "{@field} is given, but the strips are to be smooth, not of least energy.",
    "Leave out weights.smooth, and set objective to energy."};
constexpr Refusal weight_without_density{
    code::invalid_input, "{@field} is true, but the material has no density.",
    "Give material.density in kg/dm³ (steel: 7.85), or set gravity to false."};
constexpr Refusal bad_force{code::invalid_input,
                            "A force on {@strip} is not a finite number, or beyond {most}.",
                            "Give it in newtons."};
constexpr Refusal force_across_plane{
    code::invalid_input,
    "A load pushes {@strip} of a symmetric sheet across its symmetry plane, with {force} along x.",
    "Set the first number of force to 0, or model the whole sheet with symmetric false."};

// Scans.
constexpr Refusal no_scan{code::empty_scan, "There is no scan to align.",
                          "Add the points of a scan."};
constexpr Refusal cloud_off{code::empty_scan, "No point of the scan is near a strip.",
                            "Check its units and where it lies, or name the strips of its points."};
constexpr Refusal scan_too_large{code::scan_too_large, "Scan {scan} has {points:point}.",
                                 "Thin it out to {most} points or fewer."};
constexpr Refusal empty_scan{code::empty_scan, "Scan {scan} has no points.",
                             "Add points, or leave the scan out."};
constexpr Refusal bad_scan_point{
    code::invalid_input,
    "Point {point} of scan {scan} has a coordinate that is not a finite number, or lies "
    "beyond {most}.",
    "Correct the point, or leave it out."};

// A folded sheet, which programs make.
constexpr Refusal sheet_not_finite{
    code::invalid_sheet, "The thickness of a sheet is a number above 0, its reach a number."};
constexpr Refusal panel_not_finite{code::invalid_sheet, "The panel has finite sizes."};
constexpr Refusal facet_of_no_strip{code::invalid_sheet,
                                    "A facet of the panel names a strip of its sheet, or −1."};
constexpr Refusal symmetric_second_panel{
    code::invalid_sheet,
    "A symmetric sheet has no second panel except the mirror image of its panel; what joins its "
    "strips ends in the symmetry plane."};
constexpr Refusal quads_between_ridges{
    code::invalid_sheet, "A strip has quads, one between each two neighbouring ridges."};
constexpr Refusal strip_not_finite{code::invalid_sheet, "A strip has finite sizes."};

// Moulds.
constexpr Refusal no_way_up{code::bad_option,
                            "The direction in which the sheet is lifted off has no length.",
                            "Set mould.up to a direction."};
constexpr Refusal overbend_without_yield{
    code::bad_option,
    "Without a material and its yield stress it is unknown how far strips spring back.",
    "Give the slit file a material with young and yield, or leave overbend out."};
constexpr Refusal overbend_in_one_body{
    code::bad_option, "Overbent strips are bent one by one, which one body does not allow.",
    "Set mould.form to ribs, or leave overbend out."};
constexpr Refusal overbend_too_far{
    code::radius_too_small,
    "{@strip} springs back so far that no fold at {@ridge} would keep its shape.",
    "Use a thicker sheet or one that yields earlier, or bend the strip less."};
constexpr Refusal inset_takes_all{code::bad_option,
                                  "An inset of {inset:6} on both sides leaves nothing of {@strip}, "
                                  "whose ridge is {length:6} long.",
                                  "Set a smaller mould.inset."};
constexpr Refusal folded_too_tightly{
    code::radius_too_small,
    "{@strip} is folded so tightly between {@ridge} that its side towards the mould has no length "
    "there.",
    "Bend the strip less, or put the mould on the other side (mould.side)."};
constexpr Refusal nothing_faces_up{
    code::unsupported_shape,
    "No part of the strips faces the direction in which the sheet is lifted off.",
    "Choose another direction (mould.up) or the other side (mould.side)."};
constexpr Refusal overhangs_itself{
    code::unsupported_shape, "{@strip} overhangs itself, so its rib would pass through itself.",
    "Choose another direction for the mould (mould.up)."};
constexpr std::string_view
    kStandElsewhere = "Choose another direction (mould.up) or the other side (mould.side).";
constexpr Refusal ribs_overlap{code::unsupported_shape,
                               "The mould's ribs under {@strip} would overlap by {area}.",
                               kStandElsewhere};
constexpr Refusal rib_overlaps_image{
    code::unsupported_shape,
    "The mould's rib under {@strip} and the one on the other side of the symmetry plane would "
    "overlap by {area}.",
    kStandElsewhere};
constexpr Refusal rib_overlaps_wall{
    code::unsupported_shape,
    "The mould's rib under {@strip} and its wall behind a panel would overlap by {area}.",
    kStandElsewhere};
constexpr Refusal walls_overlap{code::unsupported_shape,
                                "The mould's walls behind the panels would overlap by {area}.",
                                kStandElsewhere};
constexpr Refusal rib_through_strip{
    code::unsupported_shape, "The mould's rib under {@strip} would pass through {@other} at {@at}.",
    kStandElsewhere};
constexpr Refusal rib_through_own_strip{
    code::unsupported_shape,
    "The mould's rib under {@strip} would pass through another part of that strip at {@at}.",
    kStandElsewhere};
constexpr Refusal wall_through_itself{
    code::unsupported_shape,
    "The mould's wall behind a panel, {depth} deep, would run through itself where the leg curve "
    "is bent most.",
    "Set a smaller mould.base, whose depth it has, or mould.form to ribs."};
constexpr Refusal not_one_body{
    code::unsupported_shape,
    "Ribs or walls of the mould touch each other, so it would not be one body.",
    "Choose a larger inset (mould.inset), or set mould.form to ribs."};
constexpr Refusal no_room_for_wall{
    code::unsupported_shape,
    "Strips come down to {left} above the free edge of a panel {height} high, so the mould's wall "
    "has no room behind it.",
    "Set mould.form to ribs."};

}  // namespace planish::refuse
