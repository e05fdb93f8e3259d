#include "profile_check.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/brake/codes.hpp>
#include <planish/brake/tools.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace planish {
namespace {

using namespace brake_detail;

/// Finds the first thing that is wrong with the part of a catalogue at a JSON pointer.
class ToolCheck {
 public:
  ToolCheck(std::string pointer, std::string name)
      : pointer_(std::move(pointer)), name_(std::move(name)) {}

  const std::optional<Error>& error() const { return error_; }

  /// "the opening of die "V16"", or the part itself without `what`.
  void wrong(const std::string& key, const std::string& what, const std::string& sentence) {
    if (error_) return;
    const std::string subject = what.empty() ? name_ : fmt::format("the {} of {}", what, name_);
    error_ = Error{code::bad_tools, subject + " " + sentence, pointer_ + key};
  }

  void above_zero(const std::string& key, const std::string& what, double value) {
    if (!(value > 0.0 && std::isfinite(value)))
      wrong(key, what, fmt::format("is {:g}; it must be above 0", value));
  }

  void at_least_zero(const std::string& key, const std::string& what, double value) {
    if (!(value >= 0.0 && std::isfinite(value)))
      wrong(key, what, fmt::format("is {:g}; it must be 0 or more", value));
  }

  void profile(const std::string& key, const std::string& what, const ToolProfile& profile) {
    if (const auto fault = fault_of(profile)) wrong(key + fault->where, what, fault->what);
  }

  void segments(const std::vector<double>& lengths) {
    if (lengths.empty())
      wrong("/segments", "", "has no segments: list the lengths in which it is there");
    for (std::size_t i = 0; i < lengths.size(); ++i)
      above_zero(fmt::format("/segments/{}", i), "length of a segment", lengths[i]);
  }

  void angle(Angle value) {
    if (!(value.degrees() > 0.0 && (value.degrees() <= kFlat || flattens(value))))
      wrong("/angle", "angle",
            fmt::format("is {:g}°; it must be above 0, and at most 180°, which is flat",
                        value.degrees()));
  }

  template <typename Tool>
  void common(const Tool& tool) {
    if (tool.id.empty()) wrong("/id", "", "has no id: every tool has its own");
    angle(tool.angle);
    segments(tool.segments);
    if (tool.max_force) above_zero("/max_force", "max_force", *tool.max_force);
    profile("/profile", "profile", tool.profile);
  }

 private:
  static constexpr double kFlat = 180.0;
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
      to.wrong(fmt::format("{}/{}", key, i), what,
               fmt::format("reaches z = {:.6g}; {}", z,
                           body == Body::above ? "nothing of it is lower than the tip, at z = 0"
                                               : "nothing of it is higher than its top, at z = 0"));
  }
}

void check_tip(ToolCheck& to, const Punch& punch) {
  const auto tip = corner_at(punch.profile, Vec2::Zero());
  if (!tip) return to.wrong("/profile", "profile", "has no corner at (0, 0), where the tip is");
  const double near = corner_tolerance(punch.profile);
  for (std::size_t i = 0; i < punch.profile.size(); ++i)
    if (i != *tip && punch.profile[i].y() <= near)
      to.wrong(fmt::format("/profile/{}", i), "profile",
               fmt::format("has a second corner at z = 0, ({:.6g}, {:.6g}); the tip alone is "
                           "there, unless the angle is 180°",
                           punch.profile[i].x(), punch.profile[i].y()));
  if (const auto fault = fault_of_rounding(punch.profile, *tip, punch.tip_radius))
    to.wrong("/tip_radius", "tip_radius", *fault);
}

void check_punch(ToolCheck& to, const Punch& punch) {
  to.common(punch);
  to.at_least_zero("/tip_radius", "tip_radius", punch.tip_radius);
  if (to.error()) return;
  check_side(to, "/profile", "profile", punch.profile, Body::above);
  if (!flattens(punch.angle)) return check_tip(to, punch);
  if (!on_outline(punch.profile, Vec2::Zero()))
    to.wrong("/profile", "profile", "does not pass through (0, 0), where it touches the sheet");
}

/// The corners from the right shoulder to the left one, which are those of the V, are below both.
void check_opening(ToolCheck& to, const Die& die) {
  const ToolProfile& profile = die.profile;
  const double half = 0.5 * die.opening, near = corner_tolerance(profile);
  const auto left = corner_at(profile, {-half, 0.0}), right = corner_at(profile, {half, 0.0});
  if (!left || !right)
    return to.wrong("/opening", "opening",
                    fmt::format("is {0:.6g} mm, but its profile has no corner at ({1:.6g}, 0)",
                                die.opening, right ? -half : half));
  const std::size_t n = profile.size();
  bool open = (*right + 1) % n != *left;
  for (std::size_t i = (*right + 1) % n; i != *left; i = (i + 1) % n)
    open = open && profile[i].y() < -near;
  if (!open)
    return to.wrong("/opening", "opening",
                    fmt::format("is {:.6g} mm, but its profile is not open between ({:.6g}, 0) and "
                                "({:.6g}, 0)",
                                die.opening, -half, half));
  for (const std::size_t shoulder : {*left, *right})
    if (const auto fault = fault_of_rounding(profile, shoulder, die.shoulder_radius))
      to.wrong("/shoulder_radius", "shoulder_radius", *fault);
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
    to.wrong("/opening", "opening",
             fmt::format("is {:.6g} mm; a die of 180° is flat, and its opening 0", die.opening));
  if (!on_outline(die.profile, Vec2::Zero()))
    to.wrong("/profile", "profile", "does not pass through (0, 0), where the sheet lies");
}

void check_gauge(ToolCheck& to, const BackGauge& gauge) {
  to.at_least_zero("/range/0", "range", gauge.from);
  to.above_zero("/range/1", "range", gauge.to);
  if (!(gauge.from < gauge.to))
    to.wrong("/range", "range",
             fmt::format("ends at {:g} mm, before it begins at {:g} mm", gauge.to, gauge.from));
  to.above_zero("/finger_width", "finger_width", gauge.finger_width);
  to.profile("/finger", "finger", gauge.finger);
  if (!to.error() && !on_outline(gauge.finger, Vec2::Zero()))
    to.wrong("/finger", "finger", "does not pass through (0, 0), where it touches the sheet");
}

std::optional<Error> fault_of_machine(const PressBrake& machine) {
  ToolCheck to("/machine", "the machine");
  to.above_zero("/force", "force", machine.force);
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
  const std::string list = fmt::format("/{}{}", kind, kind == "punch" ? "es" : "s");
  if (tools.empty())
    return Error{code::bad_tools, fmt::format("there is no {}: list at least one", kind), list};
  std::set<std::string> ids;
  for (std::size_t i = 0; i < tools.size(); ++i) {
    const std::string name = tools[i].id.empty() ? fmt::format("{} {}", kind, i + 1)
                                                 : fmt::format("{} \"{}\"", kind, tools[i].id);
    ToolCheck to(fmt::format("{}/{}", list, i), name);
    check_one(to, tools[i]);
    if (!ids.insert(tools[i].id).second) to.wrong("/id", "id", "is there twice: give each its own");
    if (to.error()) return to.error();
  }
  return std::nullopt;
}

}  // namespace

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
