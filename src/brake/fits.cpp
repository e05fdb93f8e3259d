// Which tools bend a line, whatever the stage. Of the dies whose angle suits it those count whose V
// may be taken: for a usual radius from 4 to 12 thicknesses, for a large one those that leave it.
// Each is held against tip, radius, force of tools and machine, and segments; what no tool can cure
// is said first (math.md#tool-fit, math.md#v-choice, math.md#closing-hems).
#include "fits.hpp"

#include "segments.hpp"
#include "sentences.hpp"
#include "tool_shape.hpp"

#include <planish/base/assert.hpp>
#include <planish/base/tolerance.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>
#include <utility>

namespace planish::brake_detail {
namespace {

constexpr double kVOfPitch = 4.0;      // so that bumps do not share shoulders
constexpr double kWidestAtAll = 24.0;  // thicknesses: a V that a shop might get
constexpr double kLittle = 5.0;        // thicknesses that a punch may be short: the bend goes on

bool bears(const std::optional<double>& most, double force) { return !most || *most >= force; }

/// kN/m that a punch and a die bear together.
double most_of(const Punch& punch, const Die& die) {
  constexpr double kUnlimited = std::numeric_limits<double>::infinity();
  return std::min(punch.max_force.value_or(kUnlimited), die.max_force.value_or(kUnlimited));
}

/// What tools have to press of a line, from its first piece to its last, mm.
double pressed_span(const BrakeLine& line, double shortfall) {
  if (line.pieces.empty()) return 0.0;
  return covered(line.pieces.back(), shortfall).hi - covered(line.pieces.front(), shortfall).lo;
}

/// Of all segments of a tool.
double length_of(const Die& die) {
  return std::accumulate(die.segments.begin(), die.segments.end(), 0.0);
}
double length_of(const Punch& punch) {
  const double ears = punch.ears ? punch.ears->left + punch.ears->right : 0.0;
  return std::accumulate(punch.segments.begin(), punch.segments.end(), ears);
}

/// Whether all segments of a tool together press the pieces of a line.
bool has_segments(double length, const BrakeLine& line, double shortfall) {
  double needed = 0.0;
  for (const Interval& piece : line.pieces) {
    const Interval pressed = covered(piece, shortfall);
    needed += pressed.hi - pressed.lo;
  }
  return length >= needed - kWritten;
}

}  // namespace

Angle angle_before_closing(const BrakeTools& tools, const PlanOptions& options) {
  const auto sharpest = [](const auto& all) {
    Angle angle = Angle::radians(std::numbers::pi);
    for (const auto& tool : all)
      angle = std::min(angle, tool.angle);
    return angle;
  };
  const auto flat = [](const auto& tool) { return flattens(tool.angle); };
  if (std::ranges::none_of(tools.punches, flat) || std::ranges::none_of(tools.dies, flat))
    return {};
  return Angle::radians(std::numbers::pi) -
         std::max(sharpest(tools.punches), sharpest(tools.dies)) - options.springback;
}

WorkpieceOptions workpiece_options(double thickness, const BrakeTools& tools,
                                   const PlanOptions& options, std::vector<LargeBend> large) {
  return {options.radius_of_opening * options.opening.value_or(wanted_opening(thickness)),
          angle_before_closing(tools, options), std::move(large)};
}

namespace {

/// Finds the tools of one line.
class Fitting {
 public:
  Fitting(const BrakeLine& line, const BrakeTools& tools, const PlanOptions& options)
      : line_(line),
        tools_(tools),
        options_(options),
        thickness_(line.bend.thickness),
        shortfall_(options.shortfall.value_or(thickness_)),
        most_angle_(largest_tool_angle(line, options)),
        wanted_(wanted_opening(line, tools, options)) {
    for (const Die& die : tools.dies)
      if (is_v(die)) sizes_.insert(std::round(die.opening / kWritten) * kWritten);
    nearest_ = nearest_size();
  }

  FittingTools found() {
    FittingTools fitting;
    for (int punch = 0; punch < std::ssize(tools_.punches); ++punch)
      for (int die = 0; die < std::ssize(tools_.dies); ++die)
        if (fits(tools_.punches[punch], tools_.dies[die]))
          fitting.pairs.push_back({punch, die, away(tools_.dies[die].opening)});
    std::ranges::stable_sort(fitting.pairs, {}, &ToolPair::v_away);
    if (!fitting.pairs.empty()) return fitting;
    fitting.why = why();
    if (fitting.why->code == say::kWeakOverUsual) fitting.wider = least_wider();
    if (fitting.why->code == say::kSlightlyShortRows) fitting.shortfall = least_shortfall();
    return fitting;
  }

 private:
  bool is_v(const Die& die) const { return is_sharp_for(line_, die, options_); }
  bool is_sharp(const Punch& punch) const { return punch.angle.radians() <= most_angle_; }
  double force(double opening) const {
    return force_per_length(options_.tensile_strength, thickness_, opening);
  }
  bool borne_by_press(const Die& die) const {
    return force_of(line_, die, options_) <= tools_.machine.force;
  }

  /// The size of the catalogue that is nearest to the wanted one, the smaller on a tie; with
  /// `VChoice::wanted` of those whose dies bear the force.
  double nearest_size() const {
    double nearest = 0.0;
    for (const double size : sizes_) {
      const auto strong = [&](const Die& die) {
        return is_v(die) && std::abs(die.opening - size) < kWritten &&
               bears(die.max_force, force(die.opening));
      };
      if (options_.v == VChoice::wanted && std::ranges::none_of(tools_.dies, strong)) continue;
      if (nearest == 0.0 || std::abs(size - wanted_) < std::abs(nearest - wanted_) - kWritten)
        nearest = size;
    }
    return nearest;
  }

  /// All bumps of a radius are pressed with one V if one takes them all, so none costs more.
  int away(double opening) const {
    if (options_.v == VChoice::wanted || line_.bump_pitch) return 0;
    const auto place = [&](double size) {
      return static_cast<int>(
          std::distance(sizes_.begin(), sizes_.lower_bound(size - 0.5 * kWritten)));
    };
    return std::abs(place(opening) - place(nearest_));
  }

  bool may_be_taken(const Die& die) const {
    if (!is_v(die)) return false;
    const bool is_nearest = std::abs(die.opening - nearest_) < kWritten;
    if (options_.v == VChoice::wanted) return is_nearest;
    if (line_.is_large) return true;  // its radius decides
    if (line_.bump_pitch && die.opening > kVOfPitch * *line_.bump_pitch + kWritten &&
        die.opening > narrowest() + kWritten)
      return false;
    if (is_nearest || options_.radius == RadiusWanted::drawn) return true;
    return die.opening >= narrowest_opening(thickness_) - kWritten &&
           die.opening <= widest_opening(thickness_) + kWritten;
  }

  /// The narrowest V of the catalogue that is wide enough for the thickness.
  double narrowest() const {
    const auto least = sizes_.lower_bound(narrowest_opening(thickness_) - kWritten);
    return least == sizes_.end() ? *sizes_.begin() : *least;
  }

  /// The largest tip that may be taken: a radius that is drawn below every tip is bent with the
  /// smallest, and what the V leaves hides a smaller tip.
  double largest_tip(const Die& die) const {
    constexpr double kNone = std::numeric_limits<double>::infinity();
    double least = kNone;
    for (const Punch& punch : tools_.punches)
      if (is_sharp(punch) && bears(punch.max_force, force(die.opening)))
        least = std::min(least, punch.tip_radius);
    const double hidden = options_.v == VChoice::wanted ? 0.0
                                                        : options_.radius_of_opening * die.opening;
    return std::max({least < kNone ? least : 0.0, line_.inside_radius, hidden}) + kWritten;
  }

  /// Whether the sheet about a tip rounder than drawn still lies with plane sides on the shoulders.
  bool goes_in(const Punch& punch, const Die& die) const {
    if (punch.tip_radius <= line_.inside_radius) return true;  // the bend itself is looked at
    const Shoulder shoulder = shoulder_of(die);
    const double half = 0.5 * (line_.angle.radians() + options_.springback.radians());
    return (punch.tip_radius + thickness_ + shoulder.radius) * std::sin(half) <= shoulder.across;
  }

  /// A tip a little rounder than drawn is better than a far smaller one.
  bool leaves_as_drawn(const Punch& punch, const Die& die) const {
    if (options_.v == VChoice::wanted || line_.press_line || line_.closed_by) return false;
    return std::abs(made_radius(punch, die, options_) - line_.drawn_radius) <=
           told_from(line_.drawn_radius, thickness_) + kWritten;
  }

  bool insists_on_radius() const {
    return line_.is_large ||
           (options_.radius == RadiusWanted::drawn && !line_.press_line && !line_.closed_by);
  }

  bool has_radius(const Punch& punch, const Die& die) const {
    if (!insists_on_radius())
      return punch.tip_radius <= largest_tip(die) || leaves_as_drawn(punch, die);
    return meets(made_radius(punch, die, options_), line_.drawn_radius);
  }

  bool borne_by_tools(const Punch& punch, const Die& die) const {
    return bears(die.max_force, force(die.opening)) && bears(punch.max_force, force(die.opening));
  }

  bool pressed_by(const Punch& punch, const Die& die) const {
    return has_segments(length_of(punch), line_, shortfall_) &&
           has_segments(length_of(die), line_, shortfall_);
  }

  bool takes(const Punch& punch, const Die& die) const {
    return is_sharp(punch) && has_radius(punch, die) && goes_in(punch, die);
  }

  bool suits(const Punch& punch, const Die& die) const {
    return takes(punch, die) && may_be_taken(die);
  }

  bool fits(const Punch& punch, const Die& die) const {
    return all_but_press(punch, die) && borne_by_press(die) &&
           pressed_span(line_, shortfall_) <= tools_.machine.length + kWritten;
  }

  /// The widest V of the pairs that pass a test; null if there is none.
  template <typename Test>
  const Die* widest(const Test& test) const {
    const Die* widest = nullptr;
    for (const Punch& punch : tools_.punches)
      for (const Die& die : tools_.dies)
        if (test(punch, die) && (!widest || die.opening > widest->opening)) widest = &die;
    return widest;
  }

  /// The narrowest V over 12 T that would do, mm; 0: none.
  double least_wider() const {
    double opening = 0.0;
    for (const Punch& punch : tools_.punches)
      for (const Die& die : tools_.dies)
        if (is_v(die) && die.opening > widest_opening(thickness_) + kWritten && takes(punch, die) &&
            borne_by_tools(punch, die) && pressed_by(punch, die) && borne_by_press(die) &&
            (opening == 0.0 || die.opening < opening))
          opening = die.opening;
    return opening;
  }

  bool all_but_press(const Punch& punch, const Die& die) const {
    return suits(punch, die) && borne_by_tools(punch, die) && pressed_by(punch, die);
  }

  /// What is missing: first what no tool cures.
  Remark why() const {
    const double span = pressed_span(line_, shortfall_);
    if (span > tools_.machine.length + kWritten)
      return remark_of(say::short_press,
                       {{"span", span, unit::mm}, {"length", tools_.machine.length, unit::mm}});
    if (is_hem(line_) && !line_.closed_by) return remark_of(say::no_flat_tools);
    if (most_angle_ <= kWritten)
      return remark_of(say::has_to_be_rolled,
                       {{"bend_angle", 180.0 - options_.springback.degrees(), unit::degrees}});
    const Facts angle{{"tool_angle", Angle::radians(most_angle_).degrees(), unit::degrees}};
    if (std::ranges::none_of(tools_.punches, [&](const Punch& one) { return is_sharp(one); }))
      return remark_of(say::no_sharp_punch, angle);
    if (sizes_.empty()) return remark_of(say::no_sharp_die, angle);
    return why_no_pair();
  }

  Remark why_no_pair() const {
    const Die* suiting = widest([&](const Punch& p, const Die& d) { return suits(p, d); });
    if (!suiting) return remark_of(say::no_radius, {{"radius", line_.drawn_radius, unit::mm}});
    if (!widest([&](const Punch& p, const Die& d) { return suits(p, d) && pressed_by(p, d); }))
      return remark_of(least_shortfall() > 0.0 ? say::slightly_short_rows : say::few_segments,
                       {{"length", line_.length(), unit::mm}, {"longest", longest(), unit::mm}});
    if (!widest([&](const Punch& p, const Die& d) { return suits(p, d) && borne_by_tools(p, d); }))
      return no_strong_tools();
    const Die* die = widest([&](const Punch& p, const Die& d) { return all_but_press(p, d); });
    PLANISH_ASSERT(die);
    const bool wider = options_.v == VChoice::wanted &&
                       sizes_.upper_bound(die->opening) != sizes_.end();
    Facts facts{{"force", force_of(line_, *die, options_), unit::kilonewtons},
                {"most", tools_.machine.force, unit::kilonewtons},
                {"opening", die->opening, unit::mm}};
    if (wider) return remark_of(say::weak_over_wanted, facts);
    const double unusual = least_wider();
    const double enough = std::ceil(die->opening * force_of(line_, *die, options_) /
                                    tools_.machine.force);
    if (unusual == 0.0 && enough > kWidestAtAll * thickness_)
      return remark_of(say::weak_press, facts);
    facts.emplace_back("wider", unusual > 0.0 ? unusual : enough, unit::mm);
    return remark_of(unusual > 0.0 ? say::weak_over_usual : say::weak_over_wide, facts);
  }

  /// The longest row of punch and die with all their segments, mm.
  double longest() const {
    double longest = 0.0;
    for (const Punch& punch : tools_.punches)
      for (const Die& die : tools_.dies)
        if (suits(punch, die))
          longest = std::max(longest, std::min(length_of(punch), length_of(die)));
    return longest;
  }

  /// With which the longest row would do, to 0.1 mm; 0: it would have to be more than a little.
  double least_shortfall() const {
    constexpr double kFinest = 0.1;  // mm
    const double ends = 2.0 * static_cast<double>(line_.pieces.size());
    const double lacks = (line_.length() - longest()) / ends;
    const double shortfall = kFinest * std::ceil(lacks / kFinest - kWritten);
    return shortfall <= kLittle * thickness_ && has_segments(longest(), line_, shortfall)
               ? shortfall
               : 0.0;
  }

  /// Of the pairs that would press the line the one that lacks least of the force.
  Remark no_strong_tools() const {
    double most = 0.0, force = std::numeric_limits<double>::infinity(), opening = 0.0;
    for (const Punch& punch : tools_.punches)
      for (const Die& die : tools_.dies) {
        if (!suits(punch, die) || !pressed_by(punch, die)) continue;
        const double bears = most_of(punch, die), needs = this->force(die.opening);
        if (bears * force <= most * needs) continue;
        most = bears, force = needs, opening = die.opening;
      }
    if (insists_on_radius())
      return remark_of(say::no_strong_radius, {{"radius", line_.drawn_radius, unit::mm},
                                               {"force", force, say::kPerMetre},
                                               {"opening", opening, unit::mm},
                                               {"most", most, say::kPerMetre}});
    const double wider = std::ceil(opening * force / most);
    const bool usual = wider <= widest_opening(thickness_);
    return remark_of(usual ? say::strong_over_wider : say::no_strong_tools,
                     {{"force", force, say::kPerMetre},
                      {"opening", opening, unit::mm},
                      {"most", most, say::kPerMetre},
                      {"wider", wider, unit::mm}});
  }

  const BrakeLine& line_;
  const BrakeTools& tools_;
  const PlanOptions& options_;
  double thickness_, shortfall_, most_angle_, wanted_;
  std::set<double> sizes_;  ///< openings of the catalogue, of dies that are sharp enough
  double nearest_ = 0.0;    ///< of them to the wanted one
};

/// Flat tools that bear the force of closing a hem.
FittingTools closing_tools(const BrakeLine& line, const BrakeTools& tools,
                           const PlanOptions& options) {
  FittingTools fitting;
  const double force = closing_force(options.tensile_strength, line.bend.thickness);
  double most = 0.0;
  for (int punch = 0; punch < std::ssize(tools.punches); ++punch)
    for (int die = 0; die < std::ssize(tools.dies); ++die) {
      if (!flattens(tools.punches[punch].angle) || !flattens(tools.dies[die].angle)) continue;
      most = std::max(most, most_of(tools.punches[punch], tools.dies[die]));
      if (most_of(tools.punches[punch], tools.dies[die]) >= force)
        fitting.pairs.push_back({punch, die});
    }
  const double whole = force * line.length() / kMillimetres;
  if (fitting.pairs.empty())
    fitting.why = remark_of(say::no_strong_flat_tools,
                            {{"force", force, say::kPerMetre}, {"most", most, say::kPerMetre}});
  else if (whole > tools.machine.force)
    fitting = {
        {},
        remark_of(say::weak_press_for_hem, {{"force", whole, unit::kilonewtons},
                                            {"most", tools.machine.force, unit::kilonewtons}})};
  return fitting;
}

}  // namespace

FittingTools fitting_tools(const BrakeLine& line, const BrakeTools& tools,
                           const PlanOptions& options) {
  return line.closes ? closing_tools(line, tools, options) : Fitting(line, tools, options).found();
}

}  // namespace planish::brake_detail
