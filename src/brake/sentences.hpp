#pragma once

#include <planish/brake/plan.hpp>

#include <string_view>

/// The remarks of brake, for `tell`: no full stop, since other text goes on from them.
namespace planish::say {

/// What is remarked, for `tell`, and its code (formats.md#remarks).
struct Sentence {
  std::string_view code, pattern;
};

constexpr Sentence other_radius{"other_radius",
                                "air bending over a V of {opening} leaves an inside radius of "
                                "about {left}, not the {radius} of {@bend}"};
constexpr Sentence tip_radius{
    "other_radius",
    "the tip of {punch} leaves an inside radius of {left}, not the {radius} of {@bend}"};
constexpr Sentence timed_out{
    "timed_out", "the time of {seconds} ended the search, so the next run may find another plan"};
constexpr Sentence reasons_timed_out{
    "timed_out",
    "the time of {seconds} ended the search for reasons, so the next run may find more of them"};
constexpr Sentence rolled{"rolled", "no stroke of the plan forms {@bend}: roll it"};
constexpr Sentence rolled_since{
    "rolled", "no way was found to form {@bend} over a V or by bumps with these tools: roll it"};
constexpr Sentence bumped{"bumped",
                          "{@bend} is formed by {bumps:bump} of {angle:4}, {pitch:4} apart, with a "
                          "chord error of {error:3}"};
constexpr Sentence bumped_coarser{
    "bumped",
    "{@bend} is formed by {bumps:bump} of {angle:4}, {pitch:4} apart, with a chord error of "
    "{error:3}: for {wanted:3} they would be nearer together than the sheet is thick"};
constexpr Sentence open_hem{
    "open_hem",
    "stop the flat punch {height} above the die to leave {gap} between the sides of {@bend}"};
constexpr Sentence short_gauge{
    "short_gauge",
    "the gauge touches only {touched} beside {@bend}, {line} long: hold the sheet square"};
constexpr Sentence other_v{
    "other_v", "the V is {opening} instead of {wanted} for {@bend}, which takes {force:4}"};
constexpr Sentence narrow_v{
    "narrow_v", "a V of {opening}, less than {least}, marks the sheet at {@bend} and may crack it"};

constexpr Sentence none_last{"none_last",
                             "no bend can be the last: each, with all others formed, hits a tool "
                             "or lacks room for one"};

// What is in the way of a bend in the stage that got furthest.
constexpr Sentence cannot_be_bent{kFurthestStage,
                                  "where the order gets furthest, {@bend:id} cannot be bent"};
constexpr Sentence flange_in_tool{
    kFurthestStage,
    "where the order gets furthest, {@bend:id} cannot be bent: {@flange} would run {depth:3} into "
    "the {tool}"};
constexpr Sentence sheet_in_tool{
    kFurthestStage,
    "where the order gets furthest, {@bend:id} cannot be bent: the sheet would run {depth:3} into "
    "the {tool}"};
constexpr Sentence flange_through_tool{
    kFurthestStage,
    "where the order gets furthest, {@bend:id} cannot be bent: {@flange} would run right through "
    "the {tool}"};
constexpr Sentence sheet_through_tool{
    kFurthestStage,
    "where the order gets furthest, {@bend:id} cannot be bent: the sheet would run right through "
    "the {tool}"};
constexpr Sentence flange_near_tool{
    kFurthestStage,
    "where the order gets furthest, {@bend:id} cannot be bent: {@flange} would come nearer to the "
    "{tool} than the clearance"};
constexpr Sentence sheet_near_tool{
    kFurthestStage,
    "where the order gets furthest, {@bend:id} cannot be bent: the sheet would come nearer to the "
    "{tool} than the clearance"};
constexpr std::string_view at_turn = "at {turn:3}";

// Why a stroke is not gauged.
constexpr Sentence no_back_gauge{"no_back_gauge", "the press has no back gauge"};
constexpr Sentence no_parallel_edge{"no_parallel_edge",
                                    "no straight edge is parallel to the bend line"};
constexpr Sentence edge_leans{
    "edge_leans",
    "each straight edge that is parallel to the bend line is on a formed flange that neither lies "
    "nor stands upright"};
constexpr Sentence edge_on_other_side{
    "edge_on_other_side", "what fingers could touch is on the other side of the bend line"};
constexpr Sentence edge_out_of_range{
    "edge_out_of_range",
    "the nearest edge is {away} from the bend line, and the gauge reaches from {from} to {to}"};
constexpr Sentence face_out_of_range{
    "edge_out_of_range",
    "the nearest flange that stands upright is {away} from the bend line, and the gauge reaches "
    "from {from} to {to}"};
constexpr Sentence face_too_low{
    "face_too_low",
    "the fingers touch {touched} of the height of what stands upright, {away} from the bend line, "
    "less than {least}"};
constexpr Sentence face_beyond_lift{"face_beyond_lift",
                                    "the fingers, which lift from {lowest} to {highest}, reach "
                                    "less than {least} of the height of what "
                                    "stands upright, {away} from the bend line"};
constexpr Sentence edge_too_short{
    "edge_too_short",
    "the longest edge in its range is {longest}, and a finger has to touch {least}"};
constexpr Sentence finger_in_tool{
    "finger_in_tool", "at the edge, {away} from the bend line, the fingers would stand in {tool}"};
constexpr Sentence finger_blocked{"finger_blocked",
                                  "the part is in the way of the fingers at each edge"};
constexpr std::string_view
    nose_would_touch = "with `--gauge-openings` the nose of the fingers touches in an opening",
    fingers_would_touch = "with `--gauge-openings` the fingers touch in an opening";

// What a stroke lacks.
constexpr Sentence no_segments_fit{
    "no_segments",
    "no segments of {tool} press the line, {is} long, and stand between what is beside it"};
constexpr Sentence no_segments_in_room{
    "no_segments",
    "{tool} has no segments that press the line, {is} long, in the {room} between what is beside "
    "it"};
constexpr Sentence bed_too_short{
    "no_segments",
    "no row of {tool} that presses the line, {is} long, is as short as the machine takes, {most}"};
constexpr Sentence shoulders_touch_bend{
    "bend_too_wide",
    "the shoulders of {tool} would touch the bend, {is} wide, and not the plane sides"};
constexpr Sentence short_side{
    "short_side",
    "the bend line is {is} from the end of {@side}, and {tool} needs {needed}; a V of {opening} or "
    "less would take it"};
constexpr Sentence short_of_usual{
    "short_side",
    "the bend line is {is} from the end of {@side}, and {tool} needs {needed}; only a V of "
    "{opening} would take it, narrower than 4 T"};
constexpr Sentence short_of_any{
    "short_side",
    "the bend line is {is} from the end of {@side}, and {tool} needs {needed}; no V would take it"};
constexpr Sentence short_of_strong{
    "short_side",
    "the bend line is {is} from the end of {@side}, and {tool} needs {needed}; {other} would take "
    "it, but bears only {most} of {force}"};
constexpr Sentence beam_at_hem{"beam_at_hem", "the {tool} is in the way of closing the hem"};
constexpr Sentence hem_not_bent{"hem_not_bent", "a hem is bent before it is closed"};

// Why no tool bears a line: goes on from "there is".
constexpr std::string_view kNoTool = "no_tool";

constexpr std::string_view kPerMetre = "kN/m";

constexpr std::string_view kShortPress = "short_press", kWeakPress = "weak_press";
constexpr std::string_view kWeakPressForHem = "weak_press_for_hem";
constexpr std::string_view kWeakOverWanted = "weak_over_wanted";
constexpr std::string_view kWeakOverUsual = "weak_over_usual", kWeakOverWide = "weak_over_wide";
constexpr std::string_view kSlightlyShortRows = "slightly_short_rows";
constexpr Sentence short_press{
    kShortPress,
    "no press long enough: it takes {span:6} of tools, and the machine holds {length:6}"};
constexpr Sentence weak_press{
    kWeakPress,
    "no press strong enough: even over a V of {opening} it takes {force}, and the machine has "
    "{most}"};
constexpr Sentence weak_over_wide{
    kWeakOverWide,
    "no press strong enough: over a V of {opening} it takes {force}, and the machine has {most}, "
    "enough over a V of {wider} or more"};
constexpr Sentence weak_over_wanted{
    kWeakOverWanted,
    "no press strong enough: over the wanted V of {opening} it takes {force}, and the machine has "
    "{most}"};
constexpr Sentence weak_over_usual{
    kWeakOverUsual,
    "no press strong enough: even over a V of {opening} it takes {force}, and the machine has "
    "{most}; a V of {wider} would do, and is wider than 12 T"};
constexpr Sentence weak_press_for_hem{
    kWeakPressForHem,
    "no press strong enough: closing it takes {force}, and the machine has {most}"};
constexpr Sentence no_flat_tools{kNoTool, "no flat punch and flat die to close a hem"};
constexpr Sentence no_strong_flat_tools{
    kNoTool,
    "no flat punch and flat die that bear {force} to close a hem: the strongest bear {most}"};
constexpr Sentence has_to_be_rolled{
    kNoTool, "no tool that bends by {bend_angle} or more: it has to be rolled"};
constexpr Sentence no_sharp_punch{kNoTool, "no punch of {tool_angle} or less"};
constexpr Sentence no_sharp_die{kNoTool, "no die of {tool_angle} or less"};
constexpr Sentence no_radius{
    kNoTool, "no punch and die that leave an inside radius within a third of {radius}"};
constexpr Sentence no_strong_radius{
    kNoTool,
    "no punch and die that leave an inside radius within a third of {radius} and bear {force} over "
    "their V of {opening}: the strongest bear {most}"};
constexpr Sentence few_segments{
    kNoTool,
    "no punch and die whose segments together press a length of {length}: the longest press "
    "{longest}"};
constexpr Sentence slightly_short_rows{
    kSlightlyShortRows,
    "no punch and die whose segments together press a length of {length}: the longest press "
    "{longest}"};
constexpr Sentence no_strong_tools{
    kNoTool, "no punch and die that bear {force} over a V of {opening}: the strongest bear {most}"};
constexpr Sentence strong_over_wider{
    kNoTool,
    "no punch and die that bear {force} over a V of {opening}: the strongest bear {most}, enough "
    "over a V of {wider} or more"};

}  // namespace planish::say

namespace planish::brake_detail {

inline Remark remark_of(const say::Sentence& sentence, const Facts& facts = {}) {
  return {sentence.code, tell(sentence.pattern, facts)};
}

}  // namespace planish::brake_detail
