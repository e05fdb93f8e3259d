#pragma once

#include <planish/base/result.hpp>
#include <planish/sheet/flat_pattern.hpp>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace planish {

enum class Severity { info, warning, error };

/// One place where a rule is broken.
struct FindingPlace {
  Severity severity = Severity::warning;
  std::string message;             ///< one sentence without its full stop, numbers with units
  std::vector<Vec2> at;            ///< the points in the pattern: of two openings, one on each
  std::vector<Place> places = {};  ///< what it is about: a bend, a flange
  std::vector<NamedQuantity> numbers = {};
  std::vector<Named> named = {};  ///< what `message` names
};

/// One observation about a flat pattern. Codes: "overlap", and one for each rule: "flange_height",
/// "bend_relief", "flush_bend", "inside_radius", "hem", "k_factor", "opening_to_bend",
/// "opening_in_bend", "opening_to_edge", "opening_to_opening", "smallest_opening"; `job` adds those
/// of certificates (formats.md#checks). A rule gives one finding, with its worst place in the
/// message and all of them in `places`. What the message names is in `about` and `numbers`.
struct Finding {
  std::string code;
  Severity severity = Severity::warning;  ///< that of the worst place
  std::string message;   ///< one sentence without its full stop, numbers with units
  std::vector<Vec2> at;  ///< where in the pattern; may be several places
  std::vector<FindingPlace> places = {};  ///< of a rule, the worst first
  std::vector<Place> about = {};          ///< what the message names: flanges, bends, faces, points
  std::vector<NamedQuantity> numbers = {};
  std::vector<Remedy> remedies = {};  ///< what would do away with it, the best first
  std::vector<Named> named = {};      ///< what `message` names
};

/// The message as words of another sentence, without its data.
Told words_of(const Finding& finding);
Told words_of(const FindingPlace& place);

/// The finding with its sentences in another unit.
Finding in_units(Finding finding, LengthUnit unit);

/// How openings and the outer contour are cut. The limits of a rule depend on it.
enum class Process { laser, punch };

/// Thresholds of shop-floor.md#rules-of-manufacture, by default those of cutting by laser. Names
/// ending in _t and _r are factors of the thickness T and the inside radius R. All can be set in a
/// JSON file (formats.md#rules). A threshold of 0 switches its rule off.
struct Rules {
  double flange_height_t = 1.5;  ///< smallest flange height = this·T + flange_height_r·R
  double flange_height_r = 1.0;
  double opening_to_bend_t = 2.0;      ///< opening to bend tangent line
  double opening_to_edge_t = 1.0;      ///< opening to outer contour
  double opening_to_opening_t = 1.0;   ///< the larger of this·T and opening_to_opening_mm
  double opening_to_opening_mm = 0.8;  ///< mm
  double smallest_opening_t = 0.5;
  double inside_radius_t = 1.0;  ///< smallest inside radius = this·T
  double relief_width_t = 0.5;
  double relief_depth_r = 1.0;  ///< relief depth ≥ relief_depth_r·R + relief_depth_t·T
  double relief_depth_t = 1.0;
  double hem_diameter_t = 1.0;  ///< inside diameter of an open hem (angle ≥ 170°)
  double hem_return_t = 6.0;
  double k_low = 0.2;  ///< a bend's K outside [k_low, k_high] is reported
  double k_high = 0.5;
  /// Every breach is a warning. Otherwise a breach is info where the guideline keeps a margin, and
  /// a warning where a shop would call (`check_rules`).
  bool strict = false;
  bool enabled = true;
};

/// The limits that guidelines state for a process.
Rules rules_for(Process process);

/// A threshold of `Rules` as data, so that files, help and forms need no lists of their own.
struct RuleField {
  std::string_view name;  ///< key in files; the member's name
  double Rules::*value;
  std::string_view description;
  std::string_view origin;  ///< where the default comes from, and other values in use
};

/// Every threshold of `Rules` (all but `strict` and `enabled`), in the order of its members.
std::span<const RuleField> rule_fields();

/// Regions of a pattern that overlap by at most this share of the thickness only touch. A laser's
/// kerf is a hundred times as wide.
inline constexpr double kContactShare = 1e-3;

/// Where the pattern covers itself: findings with code "overlap", severity error, largest first,
/// one for each pair of flanges or bends, with the shared area in the message and its outlines as
/// places; then contours that cross themselves, unless a pair already shows it. Flanges are counted
/// from 1. Regions may touch: overlaps shallower than 2 `kContactShare` (or than curve tolerance
/// and `closure`, if larger) are ignored, and so are slits without width. `layout` and `pattern`
/// are those of one `FlatSheet`. Cost: near-linear in the number of faces when little overlaps.
std::vector<Finding> find_overlaps(const Sheet& sheet, const Layout& layout,
                                   const FlatPattern& pattern);

/// Manufacturability by the rules, one finding for each rule that is broken. A value that misses a
/// limit by less than 0.001 mm satisfies it. A place is a warning where
/// - an opening is nearer to an edge or to another opening than half the limit, or nearer to a bend
///   than a quarter of it; or is too small, or reaches into a bend;
/// - a flange is too low, a hem narrower or its return shorter than half the limit, K outside its
///   range;
/// - a bend ends beside sheet that goes on along the bend zone, without a relief or with one less
///   deep than half the limit;
/// - the rules are `strict`;
/// and info elsewhere: inside radii (a shop bends with the tools that it has), narrow reliefs,
/// bends that end flush with the edge beside them.
/// - flange_height: the shortest flat length beside a bend, to the edge or the next bend, given as
///   the height from the outside of the bend. 1.5 T + R leaves 0.5 T flat at 90°, and as much at
///   any angle. Chamfered ends, hems, bends that run into one another, and rolled bends (R > 10 T)
///   that end at the edge are accepted.
/// - bend_relief: at bend ends with sheet beside them; depth is measured from the outside of the
///   bend, where R + T is the tangent line. flush_bend: that sheet ends at the tangent line, and
///   the rules ask for no deeper relief.
/// - hem: bends of 170° and more, the return measured from the outside of the bend;
///   inside_radius: all other bends.
/// - opening_to_bend, opening_to_edge, opening_to_opening: the distance of nearest points, through
///   material only; an opening is compared with its nearest neighbour.
/// - opening_in_bend: an opening takes material from a bend zone; info, always, if it is cut
///   through
///   from flange to flange. Rolled bends are exempt, and so are windows and reliefs at which the
///   bend ends.
/// - smallest_opening: the largest circle that fits; slits without width are exempt.
/// - k_factor: one place for each value of K.
std::vector<Finding> check_rules(const Sheet& sheet, const FlatPattern& pattern,
                                 const Rules& rules);

}  // namespace planish
