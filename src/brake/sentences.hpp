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
constexpr Sentence rolled{"rolled", "no stroke bends {@bend}, which is rolled"};

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
constexpr std::string_view at_turn = "at {turn:3}";

// What a stroke lacks.
constexpr Sentence no_segments_fit{
    "no_segments",
    "no segments of {tool} press the line, {is} long, and stand between what is beside it"};
constexpr Sentence shoulders_touch_bend{
    "bend_too_wide",
    "the shoulders of {tool} would touch the bend, {is} wide, and not the plane sides"};
constexpr Sentence short_side{
    "short_side",
    "a side is {is} from the bend line, and {tool} needs {needed}; a V of {opening} or less would "
    "take it"};
constexpr Sentence short_of_any{
    "short_side",
    "a side is {is} from the bend line, and {tool} needs {needed}; no V would take it"};
constexpr Sentence beam_at_hem{"beam_at_hem", "the {tool} is in the way of closing the hem"};
constexpr Sentence hem_not_bent{"hem_not_bent", "a hem is bent before it is closed"};

// Why no tool bears a line: goes on from "there is".
constexpr std::string_view kNoTool = "no_tool";

constexpr std::string_view kPerMetre = "kN/m";

constexpr std::string_view no_flat_tools = "no flat punch and flat die to close a hem";
constexpr std::string_view
    no_strong_flat_tools = "no flat punch and flat die that bear the force of closing a hem";
constexpr std::string_view
    has_to_be_rolled = "no tool that bends by {bend_angle} or more: it has to be rolled";
constexpr std::string_view no_sharp_punch = "no punch of {tool_angle} or less";
constexpr std::string_view
    no_fine_punch = "no punch of {tool_angle} or less with a tip radius of at most {tip_radius}";
constexpr std::string_view no_strong_punch =
    "no punch of {tool_angle} or less with a tip radius of at most {tip_radius} that bears {force}";
constexpr std::string_view no_sharp_die = "no die of {tool_angle} or less";
constexpr std::string_view no_strong_die = "no die of {tool_angle} or less that bears the force";

}  // namespace planish::say

namespace planish::brake_detail {

inline Remark remark_of(const say::Sentence& sentence, const Facts& facts = {}) {
  return {sentence.code, tell(sentence.pattern, facts)};
}

}  // namespace planish::brake_detail
