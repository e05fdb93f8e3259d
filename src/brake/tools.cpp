#include "profile_check.hpp"
#include "refusals.hpp"

#include <planish/base/text.hpp>
#include <planish/base/tolerance.hpp>
#include <planish/brake/tools.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <string_view>
#include <utility>

// The first fault of a catalogue of tools, and its JSON pointer (formats.md#tools). Sizes come
// first, then profiles, since roundings need a sound profile. With the punch's tip and the middle
// of the V at the origin, nothing of a punch or its beam lies below, nothing of a die or its beam
// above, and the V is open between its shoulders: collisions rely on that (math.md#machine-frame).

namespace planish {
namespace {

using namespace brake_detail;

/// Finds the first thing that is wrong with the part of a catalogue at a JSON pointer.
class ToolCheck {
 public:
  ToolCheck(std::string pointer, std::string name)
      : pointer_(std::move(pointer)), name_(std::move(name)) {}

  const std::optional<Error>& error() const { return error_; }

  /// About "The opening of die "V16"", or the part itself without `what`.
  void wrong(const std::string& key, const std::string& what, const Refusal& refusal,
             Facts facts = {}) {
    if (error_) return;
    std::string subject = what.empty() ? name_ : "the " + what + " of " + name_;
    facts.emplace_back("subject", capitalized(std::move(subject)));
    facts.emplace_back("field", place::pointer(pointer_ + key));
    error_ = error_of(refusal, facts);
  }

  void above_zero(const std::string& key, const std::string& what, double value,
                  std::string_view unit = unit::mm) {
    if (!(value > 0.0 && std::isfinite(value)))
      wrong(key, what, refuse::bad_tool_value,
            {{"value", value, unit}, {"range", "a value above 0"}});
  }

  void at_least_zero(const std::string& key, const std::string& what, double value) {
    if (!(value >= 0.0 && std::isfinite(value)))
      wrong(key, what, refuse::bad_tool_value,
            {{"value", value, unit::mm}, {"range", "0 or more"}});
  }

  void profile(const std::string& key, const std::string& what, const ToolProfile& profile) {
    if (const auto fault = fault_of(profile))
      wrong(key + fault->where, what, fault->refusal, fault->facts);
  }

  void segments(const std::vector<double>& lengths) {
    if (lengths.empty()) wrong("/segments", "", refuse::no_segments);
    for (std::size_t i = 0; i < lengths.size(); ++i)
      above_zero("/segments/" + std::to_string(i), "length of a segment", lengths[i]);
  }

  void angle(Angle value) {
    if (!(value.degrees() > 0.0 && (value.degrees() <= kFlat || flattens(value))))
      wrong("/angle", "angle", refuse::bad_tool_value,
            {{"value", value.degrees(), unit::degrees},
             {"range", "an angle above 0° and at most 180°, which is flat"}});
  }

  template <typename Tool>
  void common(const Tool& tool) {
    if (tool.id.empty()) wrong("/id", "", refuse::no_id);
    angle(tool.angle);
    segments(tool.segments);
    if (tool.max_force) above_zero("/max_force", "max_force", *tool.max_force, kPerMetre);
    profile("/profile", "profile", tool.profile);
  }

 private:
  static constexpr double kFlat = 180.0;
  static constexpr std::string_view kPerMetre = "kN/m";
  std::string pointer_, name_;
  std::optional<Error> error_;
};

/// The corner that lies beyond z = 0, on the sheet's side.
enum class Body { above, below };

void check_side(ToolCheck& to, const std::string& key, const std::string& what,
                const ToolProfile& profile, Body body) {
  const double near = corner_tolerance(profile);
  for (std::size_t i = 0; i < profile.size(); ++i) {
    const double z = profile[i].y();
    if (body == Body::above ? z < -near : z > near)
      to.wrong(key + "/" + std::to_string(i), what,
               body == Body::above ? refuse::below_tip : refuse::above_top, {{"z", z, unit::mm}});
  }
}

void check_tip(ToolCheck& to, const Punch& punch) {
  const auto tip = corner_at(punch.profile, Vec2::Zero());
  if (!tip) return to.wrong("/profile", "profile", refuse::no_tip);
  const double near = corner_tolerance(punch.profile);
  for (std::size_t i = 0; i < punch.profile.size(); ++i)
    if (i != *tip && punch.profile[i].y() <= near)
      to.wrong("/profile/" + std::to_string(i), "profile", refuse::second_corner,
               {{"x", punch.profile[i].x(), unit::mm}, {"z", punch.profile[i].y(), unit::mm}});
  if (const auto fault = fault_of_rounding(punch.profile, *tip, punch.tip_radius))
    to.wrong("/tip_radius", "tip_radius", fault->refusal, fault->facts);
}

/// A foot that the body stands back from on both sides is there above the whole of it.
void check_ears(ToolCheck& to, const Punch& punch) {
  const Ears& ears = *punch.ears;
  if (flattens(punch.angle)) return to.wrong("/ears", "", refuse::flat_punch_ears);
  to.at_least_zero("/ears/left", "left ear", ears.left);
  to.at_least_zero("/ears/right", "right ear", ears.right);
  to.above_zero("/ears/height", "height of the ears", ears.height);
  to.above_zero("/ears/reach", "reach of the ears", ears.reach);
  if (ears.left == 0.0 && ears.right == 0.0) to.wrong("/ears", "", refuse::no_ears);
  const double top = std::ranges::max(punch.profile, {}, [](const Vec2& p) { return p.y(); }).y();
  if (ears.height >= top)
    to.wrong("/ears/height", "", refuse::high_ears,
             {{"height", ears.height, unit::mm}, {"top", top, unit::mm}});
  for (const auto& [key, length] :
       {std::pair("/ears/left", ears.left), {"/ears/right", ears.right}})
    if (length > 0.0 && length < ears.reach)
      to.wrong(key, "", refuse::short_ear,
               {{"length", length, unit::mm}, {"reach", ears.reach, unit::mm}});
}

void check_punch(ToolCheck& to, const Punch& punch) {
  to.common(punch);
  to.at_least_zero("/tip_radius", "tip_radius", punch.tip_radius);
  if (to.error()) return;
  check_side(to, "/profile", "profile", punch.profile, Body::above);
  if (punch.ears) check_ears(to, punch);
  if (!flattens(punch.angle)) return check_tip(to, punch);
  if (!on_outline(punch.profile, Vec2::Zero()))
    to.wrong("/profile", "profile", refuse::not_through_origin);
}

/// The corners from the right shoulder to the left one, which are those of the V, are below both.
void check_opening(ToolCheck& to, const Die& die) {
  const ToolProfile& profile = die.profile;
  const double half = 0.5 * die.opening, near = corner_tolerance(profile);
  const auto left = corner_at(profile, {-half, 0.0}), right = corner_at(profile, {half, 0.0});
  if (!left || !right)
    return to.wrong("/opening", "opening", right ? refuse::no_left_shoulder : refuse::no_shoulder,
                    {{"opening", die.opening, unit::mm}, {"half", half, unit::none}});
  const std::size_t n = profile.size();
  bool open = (*right + 1) % n != *left;
  for (std::size_t i = (*right + 1) % n; i != *left; i = (i + 1) % n)
    open = open && profile[i].y() < -near;
  if (!open)
    return to.wrong("/opening", "opening", refuse::not_open,
                    {{"opening", die.opening, unit::mm}, {"half", half, unit::none}});
  for (const std::size_t shoulder : {*left, *right})
    if (const auto fault = fault_of_rounding(profile, shoulder, die.shoulder_radius))
      to.wrong("/shoulder_radius", "shoulder_radius", fault->refusal, fault->facts);
}

void check_die(ToolCheck& to, const Die& die) {
  to.common(die);
  to.at_least_zero("/shoulder_radius", "shoulder_radius", die.shoulder_radius);
  const bool flat = flattens(die.angle);
  if (!flat) to.above_zero("/opening", "opening", die.opening);
  if (to.error()) return;
  check_side(to, "/profile", "profile", die.profile, Body::below);
  if (!flat) return check_opening(to, die);
  if (die.opening != 0.0)
    to.wrong("/opening", "opening", refuse::flat_die_opens, {{"opening", die.opening, unit::mm}});
  if (!on_outline(die.profile, Vec2::Zero()))
    to.wrong("/profile", "profile", refuse::not_through_origin);
}

void check_gauge(ToolCheck& to, const BackGauge& gauge) {
  to.at_least_zero("/range/0", "range", gauge.from);
  to.above_zero("/range/1", "range", gauge.to);
  if (!(gauge.from < gauge.to))
    to.wrong("/range", "range", refuse::range_ends_early,
             {{"to", gauge.to, unit::mm}, {"from", gauge.from, unit::mm}});
  if (gauge.lowest > gauge.highest)
    to.wrong("/lift", "lift", refuse::range_ends_early,
             {{"to", gauge.highest, unit::mm}, {"from", gauge.lowest, unit::mm}});
  to.above_zero("/finger_width", "finger_width", gauge.finger_width);
  to.profile("/finger", "finger", gauge.finger);
  if (!to.error() && !on_outline(gauge.finger, Vec2::Zero()))
    to.wrong("/finger", "finger", refuse::not_through_origin);
  if (!gauge.nose) return;
  to.above_zero("/nose/width", "width of the nose", gauge.nose->width);
  to.profile("/nose/profile", "nose", gauge.nose->profile);
  if (!to.error() && !on_outline(gauge.nose->profile, Vec2::Zero()))
    to.wrong("/nose/profile", "nose", refuse::not_through_origin);
}

std::optional<Error> fault_of_machine(const PressBrake& machine) {
  ToolCheck to("/machine", "the machine");
  to.above_zero("/force", "force", machine.force, unit::kilonewtons);
  to.above_zero("/length", "length", machine.length);
  const auto beam = [&](const std::string& key, const ToolProfile& profile, Body body) {
    if (profile.empty()) return;
    to.profile("/" + key, key, profile);
    if (!to.error()) check_side(to, "/" + key, key, profile, body);
  };
  beam("upper_beam", machine.upper_beam, Body::above);
  beam("lower_beam", machine.lower_beam, Body::below);
  if (to.error() || !machine.gauge) return to.error();
  ToolCheck gauge("/machine/gauge", "the gauge");
  check_gauge(gauge, *machine.gauge);
  return gauge.error();
}

template <typename Tool>
std::optional<Error> fault_of_tools(const std::vector<Tool>& tools, const std::string& kind,
                                    void (*check_one)(ToolCheck&, const Tool&)) {
  const std::string list = "/" + kind + (kind == "punch" ? "es" : "s");
  if (tools.empty())
    return error_of(refuse::no_tools, {{"kind", kind}, {"field", place::pointer(list)}});
  std::set<std::string> ids;
  for (std::size_t i = 0; i < tools.size(); ++i) {
    const std::string& id = tools[i].id;
    ToolCheck to(list + "/" + std::to_string(i),
                 kind + " " + (id.empty() ? std::to_string(i + 1) : "\"" + id + "\""));
    check_one(to, tools[i]);
    if (!ids.insert(id).second) to.wrong("/id", "id", refuse::same_tool_id);
    if (to.error()) return to.error();
  }
  return std::nullopt;
}

}  // namespace

std::string_view kind_name(ToolKind kind) {
  constexpr std::string_view kNames[] = {"punch", "upper beam", "die", "lower beam"};
  return kNames[static_cast<int>(kind)];
}

std::string text_of(const ToolName& tool) {
  std::string text(kind_name(tool.kind));
  return tool.id.empty() ? text : text + " " + tool.id;
}

bool flattens(Angle angle) {
  return std::abs(angle.radians() - std::numbers::pi) <= tolerance::kComputed;
}

Result<void> check(const BrakeTools& tools) {
  if (const auto error = fault_of_machine(tools.machine)) return tl::unexpected(*error);
  if (const auto error = fault_of_tools(tools.punches, "punch", check_punch))
    return tl::unexpected(*error);
  if (const auto error = fault_of_tools(tools.dies, "die", check_die))
    return tl::unexpected(*error);
  return {};
}

}  // namespace planish
