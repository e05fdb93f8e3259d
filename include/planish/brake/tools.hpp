#pragma once

#include <planish/base/angle.hpp>
#include <planish/base/result.hpp>
#include <planish/geometry/region.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace planish {

/// A tool's section across the bend line, counter-clockwise, mm: x is y of the machine frame
/// (towards the back gauge), y is z (up); math.md#press-brake.
using ToolProfile = std::vector<Vec2>;

/// The end segments of a punch for boxes with inward lips, also called horns. Up to a height above
/// the tip they reach to their outer end; above it the body stands back.
struct Ears {
  double left = 0.0, right = 0.0;  ///< lengths, mm, as the operator sees them; 0: there is none
  double height = 0.0;             ///< of the foot, above the tip, mm
  double reach = 0.0;              ///< by which the body stands back, mm
};

struct Punch {
  std::string id;
  ToolProfile profile;                   ///< its tip at the origin, the body above
  double tip_radius = 0.0;               ///< mm, rounds the corner at the origin
  Angle angle;                           ///< between the flanks of the tip; 180°: flat, for
                                         ///< closing hems, and the origin anywhere on its edge
  std::vector<double> segments;          ///< lengths, mm, one of each
  std::optional<Ears> ears = {};         ///< besides the segments
  std::optional<double> max_force = {};  ///< kN per metre; empty: not limited
  double raises_beam = 0.0;              ///< how much higher the upper beam is than drawn, mm
};

struct Die {
  std::string id;
  double opening = 0.0;          ///< of the V, mm; its middle at the origin, its top at z = 0
  Angle angle;                   ///< between the flanks of the V; 180°: flat, and opening 0
  double shoulder_radius = 0.0;  ///< mm, rounds the corners at (±opening/2, 0)
  ToolProfile profile;
  std::vector<double> segments;
  std::optional<double> max_force = {};
};

/// Of a finger: what touches within an opening that the finger is too large for.
struct GaugeNose {
  double width = 0.0;   ///< along the bend line, mm
  ToolProfile profile;  ///< the point that touches the sheet is the origin
};

struct BackGauge {
  double from = 0.0, to = 0.0;         ///< distances from the bend line that fingers reach, mm
  double finger_width = 0.0;           ///< along the bend line, mm
  ToolProfile finger;                  ///< the point that touches the sheet is the origin
  double lowest = 0.0, highest = 0.0;  ///< of that point, above the lying sheet's upper skin, mm
  std::optional<GaugeNose> nose = {};
};

struct PressBrake {
  std::string name;
  double force = 0.0;      ///< kN
  double length = 0.0;     ///< longest row of tools, mm
  ToolProfile upper_beam;  ///< in the punch's frame; empty: none
  ToolProfile lower_beam;  ///< in the die's frame; empty: none
  std::optional<BackGauge> gauge = {};
};

/// A press brake and the tools that a shop has for it.
struct BrakeTools {
  PressBrake machine;
  std::vector<Punch> punches;
  std::vector<Die> dies;
};

/// What of a press brake a workpiece may hit.
enum class ToolKind { punch, upper_beam, die, lower_beam };

/// One of it, by its id: empty of beams.
struct ToolName {
  ToolKind kind = ToolKind::punch;
  std::string id = {};
  friend bool operator==(const ToolName&, const ToolName&) = default;
};

/// "punch", "upper beam"
std::string_view kind_name(ToolKind kind);
/// "punch P88", "upper beam"
std::string text_of(const ToolName& tool);

/// Whether a tool of this angle is flat: it closes hems that were bent before.
bool flattens(Angle angle);

/// What is wrong with the tools: crossing profiles, a tip away from the origin, segments missing,
/// an opening that its profile does not have. `where` is the JSON pointer of the value. Errors:
/// `bad_tools`.
Result<void> check(const BrakeTools& tools);

}  // namespace planish
