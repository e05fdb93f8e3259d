#pragma once

#include <planish/base/result.hpp>
#include <planish/base/text.hpp>
#include <planish/inspect/findings.hpp>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// The findings of `job`, for `tell`: no full stop, since lists show them.
namespace planish::say {

constexpr std::string_view
    no_made_flat = "there is no flat pattern for the radii that these tools make: {why}";
constexpr std::string_view mended_corner =
    "{@part} overlap by {area} in the flat pattern, so a {shape} of {length:3} by {width:3} is cut "
    "there; draw a relief at least {least_width:3} wide and {least_depth:3} deep instead";
constexpr std::string_view
    relief_cut_beside = "a {shape} of {length:3} by {width:3} is cut beside {@bend}";
constexpr std::string_view reliefs_cut_beside =
    "{count} are cut beside bends; the first, beside {@bend}, is {length:3} by {width:3}";

constexpr std::string_view
    rips_cut = "{ripped:slit is cut as a rip/slits are cut as rips} {width:3} wide";
constexpr std::string_view rips_left_out =
    "{ripped:slit is cut as a rip/slits are cut as rips} {width:3} wide; {left:stays a line/stay "
    "lines}, because a rip there would meet another or cut the sheet in two";
constexpr std::string_view no_rips_cut =
    "rips {width:3} wide would meet others or cut the sheet in two, so {left:slit stays a "
    "line/slits stay lines}";

constexpr std::string_view
    volume_off = "the flat area at K = ½ times the thickness is {ratio:7} of the solid's volume";
constexpr std::string_view
    because_of_forms = "; the sheet has {forms}, which a flat pattern only outlines";
constexpr std::string_view without_forms = "; without them it is {explained:7}";
constexpr std::string_view without_mitres = "; without the mitres of its folds it is {explained:7}";
constexpr std::string_view slanted_or_missed =
    "; the cause is a missed feature, or cut edges that are not normal to the sheet";
constexpr std::string_view openings_fit =
    ", along the outer contour or in a bend; openings in flanges fit what the solid lacks there";
constexpr std::string_view slanted_cuts =
    "{count:cut edge} {are} not normal to the sheet; the pattern follows one skin "
    "there";
constexpr std::string_view slanted_beyond = ", and the other reaches up to {beyond} beyond it";
constexpr std::string_view slanted_within = ", and the other ends up to {within} within it";
constexpr std::string_view slanted_both =
    ", and the other reaches up to {beyond} beyond it, and elsewhere ends up to {within} within it";
constexpr std::string_view pilot_holes =
    "{count:hole} {are} cut smaller than in the solid, because the form is drawn out of the rest";
constexpr std::string_view uncut_openings =
    "{count:opening} of the solid, within formed features or between edges that touch, {are} not "
    "cut";
constexpr std::string_view folded_unmade =
    "no folded solid could be made, so its volume is not checked, nor whether it runs through "
    "itself: {reason}";
constexpr std::string_view folded_untested =
    "the folded solid may run through itself, which could not be checked: {reason}";
constexpr std::string_view
    file_missing = "no {what} could be made, so its file is not written: {reason}";

constexpr std::string_view size_unlikely =
    "the sheet is {thickness} thick and its blank {length} long, which no shop has: check the unit "
    "in which the input states its lengths";

constexpr std::string_view more_errors = ", and {more:more error} {are} found";

constexpr std::string_view length_off =
    "an edge of the solid and its image in the pattern differ in length by {off}, more than "
    "{allowed}";
constexpr std::string_view opening_off =
    "an opening of the pattern is not what the solid lets through: they differ by {off} all round, "
    "more than {allowed}";
constexpr std::string_view outline_off =
    "the solid reaches {off} beyond the outline of the pattern, more than {allowed}: material is "
    "missing there";
constexpr std::string_view
    refold_off = "the contour, folded back, misses the solid's edge by {off}, more than {allowed}";
constexpr std::string_view
    extra_openings = "the solid has {solid:opening}, the pattern {pattern}: {extra} too many";
constexpr std::string_view
    one_opening_lost = "the solid has {solid:opening}, the pattern {pattern}: one is lost";
constexpr std::string_view
    openings_lost = "the solid has {solid:opening}, the pattern {pattern}: {lost} are lost";

constexpr std::string_view
    runs_through_itself = "{@part} runs through itself when folded, {depth:3} deep";
constexpr std::string_view
    run_through_each_other = "{@part} run through each other when folded, {depth:3} deep";
constexpr std::string_view edges_press =
    "{@part} need the same space when folded, {depth:3} deep, less than the sheet is thick; trim "
    "their edges there, or file them when the part is put together";
constexpr std::string_view solid_through_itself =
    "the folded solid runs through itself, {depth:3} deep, between its faces {first} and {second}";
constexpr std::string_view strips_meet = "{meet} when folded, {depth:3} deep or more";
constexpr std::string_view strips_press =
    "{pair} need the same space, {depth:3} deep or more: move their curves apart, or chamfer their "
    "edges";
constexpr std::string_view strip_yields =
    "{@strip} is bent beyond its yield stress: {stress:3}, where the material yields at {yield:3}";
constexpr std::string_view strip_yields_and_keeps =
    "{@strip} is bent beyond its yield stress: {stress:3}, where the material yields at {yield:3}; "
    "let go, it keeps a radius of {kept:3}";
constexpr std::string_view springs_open =
    "{@strip} {spring} open when let go, as the largest bending stress, {stress:3}, is less than "
    "the yield stress, {yield:3}";
constexpr std::string_view
    strip_unstable = "{@strip} does not stay in this shape: it buckles, or sways aside";
constexpr std::string_view falls_over =
    "the sheet falls over with its load: it would stand if it were tilted back by {margin:3}";
constexpr std::string_view seam_edges =
    "the seam lies in a fold, where square edges meet on the inside first, {depth:3} deep: bevel "
    "them, or move the seam";

// Strips of a slit sheet.
constexpr std::string_view strip_tight =
    "{@strip} is bent to a radius of {radius} at {@ridge}; the material allows {least}";
constexpr std::string_view strip_creased =
    "{@strip} is creased at {@ridge}: its inside radius there is {inside}, less than its "
    "thickness";
constexpr std::string_view gap_missed = "{@strip} end {gap} apart, which is not the gap asked for";
constexpr std::string_view
    strips_cross = "{@strip} runs through {@other}: move the curves or anchors apart";
constexpr std::string_view scan_far =
    "{@strip} stays {off} from its scanned points on average: check their units, their position "
    "and the strip that they belong to";
constexpr std::string_view crosses_image = "{@strip} runs through its mirror image";
constexpr std::string_view
    below_ground = "{@strip} goes {deep} below the ground; no shape above it was found";
constexpr std::string_view
    not_converged = "{@strip} ends where it must, but is not finished and could be smoother";

// Bending. What is in the way of a bend goes on from another sentence, or is a line by itself.
constexpr std::string_view flange_hits = "{@bend:id}: {@flange} hits {tool} by {depth}";
constexpr std::string_view
    flange_near = "{@bend:id}: {@flange} comes nearer to {tool} than the clearance";
constexpr std::string_view
    part_near = "{@bend:id}: the part comes nearer to {tool} than the clearance";
constexpr std::string_view flange_through = "{@bend:id}: {@flange} goes right through {tool}";
constexpr std::string_view part_through = "{@bend:id}: the part goes right through {tool}";
constexpr std::string_view part_hits = "{@bend:id}: the part hits {tool} by {depth}";
constexpr std::string_view at_turn = "at {turn:3}";
constexpr std::string_view only_bend = "{@bend:id}";
constexpr std::string_view no_order = "no order of strokes forms all bends with these tools";
constexpr std::string_view that_begins = "that begins with {begun}";
constexpr std::string_view more_blocked = "and {more} more";
constexpr std::string_view not_after_others =
    "each can be formed, but not all in one order: the order that gets furthest leaves {@bend:id} "
    "flat";
constexpr std::string_view
    halves = "; in one piece it closes round the punch: try two (`\"pieces\": 2`)";
constexpr std::string_view no_plan =
    "no order of strokes was found among {stages:stage}, nor was it shown that there is none: name "
    "the bends to begin with (`--fix`)";
constexpr std::string_view plates_trimmed =
    "{@plate} {are} cut back where they touch, by up to {by}, so that bends fit between them";
constexpr std::string_view joint_left_open =
    "{@plate} touch along {length}, from {@from} to {@to}, and are not joined there: a bend would "
    "close a loop that does not lie flat";
constexpr std::string_view corner_left_open =
    "{@plate} touch at {@from} and are not joined there: a bend would close a loop that does not "
    "lie "
    "flat";
constexpr std::string_view joints_left_open =
    "{count:joint} of plates that touch stay open, since a bend there would close a loop that does "
    "not lie flat: {first}";
constexpr std::string_view joints_left_open_more =
    "{count:joint} of plates that touch stay open, since a bend there would close a loop that does "
    "not lie flat: {first} and {more} more";
constexpr std::string_view between_plates = "{@bend:id} between {@plate:id}";
constexpr std::string_view round_the_back =
    "turns {turn} round the back of the plates; edges that face each other would need {other}";
constexpr std::string_view long_span =
    "is {reach} long from plate to plate and {wide} wide: {times:3} times as long as "
    "wide";
constexpr std::string_view unused_edge =
    "is {wide} wide, and the edges of the plates on its tangent lines have {first} and {second} "
    "more";
constexpr std::string_view edges_beside =
    "joins edges that lie beside each other, {apart} apart along the bend, so it never runs "
    "straight from one plate to the other";
constexpr std::string_view shorter_bend =
    "{@bend} has a span of {span}; that of {other} would have {shorter}, but does not hold: "
    "{reason}";
constexpr std::string_view
    rolled_bend = "no stroke of the plan forms {@bend}, a large radius: roll it";
constexpr std::string_view changes_timed_out =
    "the time of {seconds} ended the search for changes that would help, so the next run may find "
    "more";
constexpr std::string_view other_metal =
    "the material is {material}, and forces and radii are those of mild steel: choose with "
    "`--material`";
constexpr std::string_view no_gauge_edge = "the back gauge has nothing to touch for {@bend}: {why}";

}  // namespace planish::say

namespace planish::job {

/// The message of an error where another sentence goes on with it: no capital, no full stop.
inline Told going_on(const Error& why) {
  Told words = words_of(why);
  words.sentence = continued(std::move(words.sentence));
  if (words.sentence.ends_with('.')) words.sentence.pop_back();
  return words;
}

/// A finding with its data.
inline Finding finding_of(std::string code, Severity severity, Told told, std::vector<Vec2> at) {
  Finding finding{std::move(code), severity, continued(std::move(told.sentence)), std::move(at)};
  finding.about = std::move(told.places);
  finding.numbers = std::move(told.numbers);
  finding.named = std::move(told.named);
  return finding;
}
inline Finding finding_of(std::string code, Severity severity, std::string_view pattern,
                          const Facts& facts, std::vector<Vec2> at) {
  return finding_of(std::move(code), severity, tell(pattern, facts), std::move(at));
}

/// A finding about an error that is none of the whole, with its data.
inline Finding finding_of(std::string code, std::string_view pattern, const Error& why,
                          Facts facts = {}) {
  facts.emplace_back("reason", going_on(why));
  Finding finding = finding_of(std::move(code), Severity::warning, pattern, facts, {});
  finding.about = why.places;
  finding.numbers = why.numbers;
  return finding;
}

}  // namespace planish::job
