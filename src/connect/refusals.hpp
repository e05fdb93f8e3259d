#pragma once

#include <planish/base/message.hpp>
#include <planish/connect/codes.hpp>
#include <planish/sheet/codes.hpp>

/// The sentences with which connect refuses.
namespace planish::refuse {

constexpr Refusal cancelled{code::cancelled, "Joining the plates was cancelled."};

// Values of the file and of options.
constexpr Refusal bad_value{code::invalid_input, "{name} is {value}, which is out of range.",
                            "Set it to {range}."};
constexpr Refusal bad_connect_option{code::bad_option, "{name} is {value}, which is out of range.",
                                     "Set it to {range}."};
constexpr Refusal bad_radii{code::invalid_input, "inside_radii are {value}, which is out of range.",
                            "Set both to 0 or more."};
constexpr Refusal same_id{code::invalid_input, "{@plate} appears twice.",
                          "Give each plate a different id."};
constexpr Refusal no_such_plate{code::unknown_plate, "There is no plate \"{id}\".",
                                "Name a plate of the file: {known}."};
constexpr Refusal bends_without_plates{
    code::invalid_input,
    "There are no plates and {bends:bend}; without plates there must be exactly one, a section by "
    "itself.",
    "Add plates, or give one bend."};

// Polygons of a plate. `ring` is "the outline" or "hole 2".
constexpr Refusal few_corners{
    code::too_few_corners, "In {@plate}, {ring} has {corners:corner}; a polygon needs 3 or more.",
    "Add the missing corners."};
constexpr Refusal corner_not_finite{
    code::invalid_input,
    "In {@plate}, a coordinate of corner {corner} of {ring} is not a finite number.",
    "Give each corner three finite numbers."};
constexpr Refusal corner_repeated{
    code::repeated_corner,
    "In {@plate}, corners {corner} and {next} of {ring} lie at the same place, {@at}.",
    "Leave one of them out; polygons close by themselves."};
constexpr Refusal corner_off_plane{
    code::not_planar,
    "In {@plate}, corner {corner} of {ring} lies {off} off the plane of the plate; {allowed} is "
    "allowed.",
    "Move the corner into the plane."};
constexpr Refusal ring_crosses_itself{code::self_crossing,
                                      "In {@plate}, {ring} crosses or touches itself at {@at}.",
                                      "Move its corners, or put them in order."};
constexpr Refusal no_area{code::self_crossing,
                          "The outline of {@plate} encloses no area: its corners lie on one line, "
                          "or it crosses itself.",
                          "Move its corners, or put them in order."};
constexpr Refusal hole_meets_outline{
    code::self_crossing, "Hole {hole} of {@plate} touches or crosses the outline at {@at}.",
    "Leave material between them."};
constexpr Refusal holes_meet{code::self_crossing,
                             "Hole {hole} of {@plate} overlaps or touches hole {other} at {@at}.",
                             "Make them one hole."};
constexpr Refusal hole_outside{
    code::invalid_input,
    "In {@plate}, corner {corner} of hole {hole} lies outside the outline, at {@at}.",
    "Move the corner inside."};

// Where plates lie.
constexpr Refusal plates_cross{code::plates_intersect, "{@plate} pass through each other at {@at}.",
                               "Move them apart, or cut one of them."};
constexpr Refusal plates_too_near{code::plates_touch,
                                  "{@plate} are {gap} apart at {@at}, where sheets of {thickness} "
                                  "need {least} between their middles.",
                                  "Move them apart."};
constexpr Refusal in_one_plane{
    code::plates_coplanar,
    "{@plate} lie in the same plane, so there is nothing to bend between them.",
    "Make them one plate."};
constexpr Refusal nearly_in_one_plane{
    code::plates_coplanar,
    "{@plate} lie in one plane but for {angle:3} and {off:3}, and no bend lies along the line "
    "where "
    "their planes meet: it does not run between them.",
    "Make them one plate, or turn one about a line between them."};
constexpr Refusal beside_each_other{
    code::plates_offset,
    "{@plate} lie in parallel planes {distance} apart and beside each other; a half-turn joins "
    "plates that lie over each other.",
    "Put a third plate between them."};
constexpr Refusal touch_at_bend{
    code::plates_touch, "{@plate} touch where the bend would be; a bend needs a gap.",
    "Keep their edges {least} or more from the line where their planes meet, or fold plates that "
    "share an edge sharply (inside_radius 0)."};
constexpr Refusal no_room_in_front{
    code::no_bend_fits,
    "No bend fits where {@plate} touch: only one that goes round their backs does.",
    "Make the plates wider there, the inside radius smaller, or leave room beside openings."};
constexpr Refusal flange_too_narrow{
    code::no_bend_fits,
    "{@plate} is {width} wide where it touches {@other}: a bend of inside radius {radius} takes "
    "{needed} of it.",
    "Make it wider than {needed}, or the inside radius smaller."};
constexpr Refusal sheets_run_into_each_other{
    code::plates_touch, "The sheets of {@plate}, {thickness} thick, run into each other at {@at}.",
    "Move the plates apart, or cut them back there to {least} from the line where their planes "
    "meet; trim does so along edges that plates share, which can also be folded sharply "
    "(inside_radius 0)."};
constexpr Refusal nearly_parallel{
    code::no_bend_fits,
    "The planes of {@plate} are so nearly parallel that a bend between them is out of reach.",
    "Make them parallel, or turn one by more."};

// Which plates are joined.
constexpr Refusal left_out{code::not_connected, "The given bends do not join {@plate} to {@other}.",
                           "Add a bend, or give no bends at all to have them found."};
constexpr Refusal longer_than_given{
    code::too_far_apart,
    "The bend between {@plate} would be {span} long from plate to plate, more than largest_span, "
    "{most}.",
    "Increase largest_span, or move the plates closer."};
constexpr Refusal longer_than_joined{code::too_far_apart,
                                     "The bend between {@plate} would be {span} long from plate to "
                                     "plate, but at most {most} is bridged.",
                                     "Set a larger largest_span, or give the bend itself."};
constexpr Refusal nearest_too_far{
    code::too_far_apart,
    "{@plate} is not joined to the others: the shortest bend, to {@other}, would be {span} long "
    "from plate to plate, but at most {most} is bridged.",
    "Set a larger largest_span, or give the bend itself."};
constexpr Refusal default_radius_does_not_fit{
    code::no_bend_fits,
    "No bend of the default inside radius, {radius:6}, joins {@plate} to the others.",
    "Make the default smaller, or give the radius to single bends."};
constexpr Refusal faces_no_other{code::no_bend_fits,
                                 "{@plate} cannot be joined to the others: none of its edges and "
                                 "theirs look towards each other.",
                                 "Turn or move the plate."};
constexpr Refusal closes_loop{
    code::bend_loop,
    "The bend between {@plate} closes a loop, as they are joined already, and {why}.",
    "Leave it out: the sheet is then open there."};

// What a bend is asked to be.
constexpr Refusal too_many_plates{code::invalid_input,
                                  "The bend is between {count:plate}; a bend joins two at most.",
                                  "Give several bends."};
constexpr Refusal plate_with_itself{code::invalid_input, "The bend joins {@plate} to itself.",
                                    "Name two different plates."};
constexpr Refusal no_edges_listed{code::invalid_input, "The list of edges of {@plate} is empty.",
                                  "Leave it out to have the edges chosen."};
constexpr Refusal no_such_edge{code::unknown_edge,
                               "{@plate} has no edge {edge}: its edges are 0 to {last}.",
                               "Name one of these."};
constexpr Refusal cylinder_given_as_cone{code::invalid_input,
                                         "A cylinder has no slope, apex, aperture or inside_radii.",
                                         "Leave them out, or set surface to cone."};
constexpr Refusal general_given_more{
    code::invalid_input, "A general bend takes only edges, apex, tangent_point and lateral.",
    "Leave out slope, aperture, inside_radius and inside_radii."};
constexpr Refusal tangent_point_of_other{code::invalid_input,
                                         "Only a general bend has a tangent_point.",
                                         "Set surface to general, or leave tangent_point out."};
constexpr Refusal cone_given_twice{
    code::invalid_input,
    "slope and apex, aperture, and inside_radii each fix the cone, and more than one is given.",
    "Give one of the three."};
constexpr Refusal radius_given_twice{
    code::invalid_input,
    "inside_radius cannot be given together with inside_radii, aperture or apex.",
    "Give only one of them."};

// Sections with a free end.
constexpr Refusal section_without_angle{code::invalid_input,
                                        "A section with a free end needs its angle.", "Add angle."};
constexpr Refusal section_without_radius{code::invalid_input,
                                         "A section with a free end needs its radius.",
                                         "Add inside_radius, or inside_radii for a cone."};
constexpr Refusal section_without_length{
    code::invalid_input, "A section without plates needs its length.", "Add length."};
constexpr Refusal section_cone_of_one_radius{code::invalid_input,
                                             "A conical section needs two different inside_radii.",
                                             "Give them, or set surface to cylinder."};
constexpr Refusal section_general{code::invalid_input,
                                  "A section with a free end is a cylinder or a cone.",
                                  "Set surface to cylinder or cone."};
constexpr Refusal section_cylinder_of_two_radii{
    code::invalid_input, "Two different inside_radii make a cone, not a cylinder.",
    "Set surface to cone, or give one inside_radius."};
constexpr Refusal section_without_edge{code::invalid_input,
                                       "A bend of one plate, {@plate}, begins at one of its edges.",
                                       "Name one edge in edges."};
constexpr Refusal edge_taken{code::unknown_edge, "Edge {edge} of {@plate} carries another bend.",
                             "Name a free edge."};

// Radii.
constexpr Refusal small_radius{code::radius_too_small, "An inside radius of {radius} is too small.",
                               "Set it to {least} or more."};
constexpr Refusal sheet_too_thick{
    code::radius_too_small,
    "The sheet, {thickness} thick, is too thick for the bend between {@plate}: its mid-surface has "
    "a radius of {radius} at one end and needs more than {least}.",
    "Use a thinner sheet, or move the plates apart."};
constexpr Refusal edges_too_near{
    code::radius_too_small,
    "The largest radius that fits between the edges of {@plate} is {radius} on the mid-surface; a "
    "sheet of {thickness} needs more than {least}.",
    "Move the edges {distance} away from the line where the planes of the plates meet."};
constexpr Refusal half_turn_only{code::no_bend_fits,
                                 "{@plate} lie in parallel planes, so half a cylinder joins them.",
                                 "Leave out surface, slope, aperture and inside_radii."};
constexpr Refusal half_turn_radius{
    code::no_bend_fits,
    "{@plate} lie in parallel planes {distance} apart, so a half-turn joins them, and its inside "
    "radius cannot be {asked}.",
    "Set it to {radius:8}, or leave it out."};
constexpr Refusal radius_up_to{code::no_bend_fits,
                               "An inside radius of {asked:8} does not fit between {@plate}.",
                               "Set inside_radius to {largest:8} or less."};
constexpr Refusal radius_from{
    code::no_bend_fits, "An inside radius of {asked:8} does not fit between {@plate}.",
    "Set inside_radius to {smallest:8} or more: that bends around the back of the plates."};
constexpr Refusal radius_up_to_or_from{
    code::no_bend_fits, "An inside radius of {asked:8} does not fit between {@plate}.",
    "Set inside_radius to {largest:8} or less; {smallest:8} or more bends around the back of the "
    "plates."};
constexpr Refusal middle_radius{code::no_bend_fits,
                                "A cone with an inside radius of {asked:8} at mid-length does not "
                                "fit between the edges of {@plate}.",
                                "Set it to {nearest:6}, the nearest that fits."};
constexpr Refusal middle_radius_of_none{
    code::no_bend_fits,
    "A cone with an inside radius of {asked:8} at mid-length does not fit between the edges of "
    "{@plate}.",
    "Give another slope, or other edges."};
constexpr Refusal radii_cut_plate{
    code::no_bend_fits,
    "A cone with inside radii of {asked} cuts a plate: at the ends of the edges, {@plate} leave "
    "room for {room}.",
    "Give other radii, or leave them out."};

// Tangent lines. The functions that know no plates say "the plates".
constexpr Refusal no_such_line{
    code::no_bend_fits,
    "No such tangent line leaves both plates whole between these edges; no slope is possible.",
    "Choose other edges."};
constexpr Refusal no_line_of_slopes{
    code::no_bend_fits,
    "No such tangent line leaves both plates whole between these edges; slopes from {low:6} to "
    "{high:6} are possible.",
    "Give one of these slopes."};
constexpr Refusal no_line{code::no_bend_fits,
                          "With the values given, no tangent line fits between the edges of the "
                          "plates and leaves both whole.",
                          "Give fewer values, or move a plate."};
constexpr Refusal no_edges_alike{code::no_bend_fits, "No edges look the same way on both plates.",
                                 "Turn a plate over, or move it to the other side."};
constexpr Refusal no_edges_facing{
    code::no_bend_fits, "No edges of {@plate} look towards each other.", "Turn or move a plate."};
constexpr Refusal edges_of_no_bend{
    code::unknown_edge, "No bend can lie on {noun} {edge}.",
    "Name free edges that follow each other, lie on one side of the line where the planes of the "
    "plates meet, and all look towards it or all away from it."};
constexpr Refusal aperture_too_wide{
    code::no_bend_fits,
    "A cone with an aperture of {aperture} does not fit between the edges of {@plate}.",
    "Give an aperture of up to {most}."};
constexpr Refusal apex_between{
    code::apex_in_span,
    "The apex at {apex:6} lies within the span of the edges, from {low:6} to {high:6}.",
    "Move it beyond one of their ends."};
constexpr Refusal apex_of_slope{code::no_bend_fits,
                                "With a slope of {slope:6} an apex at {apex:6} does not fit.",
                                "Give an apex from {low:6} to {high:6}."};
constexpr Refusal slope_beyond{code::no_bend_fits,
                               "A slope of {slope:6} does not fit between the edges of {@plate}.",
                               "Give a slope from {low:6} to {high:6}."};
constexpr Refusal slope_of_none{code::no_bend_fits,
                                "A slope of {slope:6} does not fit between the edges of {@plate}.",
                                "Give another slope, or other edges."};
constexpr Refusal cone_is_cylinder{
    code::no_bend_fits,
    "The edges of {@plate} are parallel, so the cone of least plate extension is a cylinder.",
    "Give a slope, an aperture or two radii, or set surface to cylinder."};
constexpr Refusal tangent_point_off{
    code::no_bend_fits,
    "The tangent point {@at} lies {off} off the line where the planes of the plates meet.",
    "Move it to {@foot}."};
constexpr Refusal tangent_point_at_apex{code::no_bend_fits,
                                        "The tangent point {@at} is the apex of the bend.",
                                        "Move it along the line where the planes meet."};
constexpr Refusal general_of_averted{code::no_bend_fits,
                                     "A general bend joins edges that look towards each other; "
                                     "these look away from each other.",
                                     "Set surface to cylinder or cone."};
constexpr Refusal general_without_apex{
    code::no_bend_fits,
    "No edge runs towards the line where the planes of the plates meet, so a general bend has no "
    "apex.",
    "Give an apex, or set surface to cylinder or cone."};

// Folds of inside radius 0.
constexpr Refusal fold_without_edges{
    code::no_bend_fits,
    "A fold of inside radius 0 between {@plate} needs an edge of both on the line where the planes "
    "of their mid-surfaces meet, side by side.",
    "Extend the plates to that line, or give a radius."};
constexpr Refusal fold_without_room{code::overlap,
                                    "The edges beside the fold between {@plate} leave no room to "
                                    "cut the plates back by {reach}, to where their inner skins "
                                    "meet.",
                                    "Give the bend an inside radius, or move these edges."};
constexpr Refusal folds_both_ways{
    code::no_bend_fits,
    "Folds of inside radius 0 in both directions need edges of equal length, and {@plate} has a "
    "longer one.",
    "Give its fold an inside radius of {least} or more."};

// Where a bend runs.
constexpr Refusal no_width{
    code::no_common_width,
    "The edges have no width in common where a bend would clear both plates.",
    "Choose other edges, or move a plate."};
constexpr Refusal ranges_apart{code::no_common_width,
                               "The edges have no width in common where a bend would clear both "
                               "plates: their ranges miss each other by {gap}.",
                               "Choose other edges, or move a plate."};
constexpr Refusal straight_over_plate{
    code::no_common_width,
    "A straight lateral boundary would run over a plate or past the end of the bend.",
    "Set lateral to arc or corner."};
constexpr Refusal begins_beside_edges{
    code::no_common_width,
    "The bend that fits best begins beside the edges of {@plate}, where its extension would run "
    "over the plate at {@at}.",
    "Choose other edges, or move a plate."};
constexpr Refusal touches_in_point{code::no_common_width,
                                   "The bend touches {@plate} only in a point.",
                                   "Choose other edges, or move a plate."};
constexpr Refusal extensions_meet{
    code::overlap,
    "The extensions of {@plate} that its bends need run into each other or over the plate, near "
    "{@at}.",
    "Choose other edges, or move a plate."};
constexpr Refusal cuts_plate{
    code::overlap,
    "The straight way from the edges of {@plate} to the bend would cut through the plate, near "
    "{@at}.",
    "Choose other edges, or move a plate."};
constexpr Refusal covers_itself{
    code::overlap,
    "Laid flat, {@plate} and the bend between them would cover each other by {area}.",
    "Choose other edges, or move a plate."};

}  // namespace planish::refuse
