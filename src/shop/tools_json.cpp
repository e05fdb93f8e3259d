#include <planish/base/assert.hpp>
#include <planish/base/id_vector.hpp>
#include <planish/base/text.hpp>
#include <planish/geometry/region.hpp>
#include <planish/schema/json_reading.hpp>
#include <planish/shop/schemas.hpp>
#include <planish/shop/tools_json.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>

namespace planish::shop {
using namespace schema;
namespace {

constexpr auto kToolsFormat = "planish/tools";
constexpr int kToolsVersion = 1;
constexpr std::size_t kMostCorners = 2'000, kMostTools = 1'000, kMostSegments = 1'000;
constexpr Range kToolAngle{"an angle above 0 and at most 180 degrees", 0.0, 180.0, false, true};

Schema outline(std::string description) {
  return list(plane_point())
      .of_length(3, kMostCorners, "a list of 3 to 2000 corners [y, z]")
      .said(std::move(description));
}

Schema segments_schema() {
  return list(length(kAboveZero))
      .of_length(1, kMostSegments, "a list of 1 to 1000 lengths")
      .said("lengths of the segments that the tool is there in, one of each");
}

Schema force_schema() { return number(kAboveZero).said("that it bears, kN per metre"); }

Schema ears_schema() {
  return object({optional("left", length(kAtLeastZero)), optional("right", length(kAtLeastZero)),
                 required("height", length(kAboveZero).said("of the foot, above the tip")),
                 required("reach",
                          length(kAboveZero).said("by which the body above the foot stands back"))})
      .said("lengths of the left and right end segments for boxes with inward lips (horns)");
}

Schema punch_schema() {
  return object(
      {required("id", text().said("name of the punch, different for each")),
       required("profile", outline("its tip at [0, 0], its body above")),
       required("tip_radius", length(kAtLeastZero).said("rounds the corner at [0, 0]")),
       required(
           "angle",
           angle(kToolAngle).said("between the flanks of the tip; 180: flat, for closing hems")),
       required("segments", segments_schema()), optional("ears", ears_schema()),
       optional("max_force", force_schema()),
       optional("raises_beam",
                length(kAtLeastZero).said("by which the upper beam is higher than drawn"))});
}

Schema die_schema() {
  return object(
      {required("id", text().said("name of the die, different for each")),
       required("opening", length(kAtLeastZero).said("of the V; 0 if the angle is 180")),
       required("angle",
                angle(kToolAngle).said("between the flanks of the V; 180: flat, for closing hems")),
       required("shoulder_radius",
                length(kAtLeastZero).said("rounds the corners at [±opening/2, 0]")),
       required("profile",
                outline("the middle of its opening at [0, 0], its top at z = 0, its body below")),
       required("segments", segments_schema()), optional("max_force", force_schema())});
}

Schema nose_schema() {
  return object({required("width", length(kAboveZero).said("along the bend line")),
                 required("profile", outline("the point that touches the sheet is [0, 0]"))});
}

Schema gauge_schema() {
  return object({required("range", tuple(2, length(kAtLeastZero), "two distances [from, to]")
                                       .said("from the bend line, that the fingers reach")),
                 required("finger_width", length(kAboveZero).said("along the bend line")),
                 required("finger", outline("the point that touches the sheet is [0, 0]")),
                 optional("lift", tuple(2, length(kAnyNumber), "two heights [from, to]")
                                      .said("of that point above the lying sheet; default 0")),
                 optional("nose", nose_schema().said("of a finger, for openings of the sheet"))});
}

Schema machine_schema() {
  return object({optional("name", any_text().said("for reports")),
                 required("force", number(kAboveZero).said("kN")),
                 required("length", length(kAboveZero).said("of the longest row of tools")),
                 optional("upper_beam", outline("what holds the punch, in the punch's frame")),
                 optional("lower_beam", outline("what holds the die, in the die's frame")),
                 optional("gauge", gauge_schema())});
}

Schema make_tools_schema() {
  std::vector<Field> fields = header_fields(kToolsFormat, kToolsVersion);
  fields.push_back(optional("units", units()));
  fields.push_back(required("machine", machine_schema()));
  fields.push_back(required(
      "punches", list(punch_schema()).of_length(1, kMostTools, "a list of 1 to 1000 punches")));
  fields.push_back(
      required("dies", list(die_schema()).of_length(1, kMostTools, "a list of 1 to 1000 dies")));
  return object(std::move(fields))
      .said(
          "A press brake and its tools, in sections [y, z] across "
          "the bend line: y towards the back gauge, z up");
}

/// Reads profiles, and knows which corners of the file they are.
class Profiles {
 public:
  ToolProfile at(const JsonPlace& place) {
    ToolProfile corners = mapped(place.items(),
                                 [&](const JsonPlace& corner) { return corner.plane_point(); });
    if (ring_area(corners) < 0.0) {
      std::reverse(corners.begin() + 1, corners.end());
      turned_[place.pointer()] = corners.size();
    }
    return corners;
  }

  /// The pointer of a corner in the file.
  std::string in_file(const std::string& pointer) const {
    const std::size_t slash = pointer.rfind('/');
    const auto turned = turned_.find(pointer.substr(0, slash));
    if (turned == turned_.end()) return pointer;
    std::size_t corner = 0;
    const char* end = pointer.data() + pointer.size();
    if (std::from_chars(pointer.data() + slash + 1, end, corner).ptr != end) return pointer;
    return fmt::format("{}/{}", turned->first, (turned->second - corner) % turned->second);
  }

 private:
  std::map<std::string, std::size_t> turned_;  ///< number of corners, by pointer
};

std::vector<double> lengths_at(const JsonPlace& place) {
  return mapped(place.items(), [&](const JsonPlace& item) { return item.length(); });
}

std::optional<Ears> ears_at(const JsonPlace& place) {
  if (!place.given()) return std::nullopt;
  return Ears{place["left"].maybe_length().value_or(0.0),
              place["right"].maybe_length().value_or(0.0), place["height"].length(),
              place["reach"].length()};
}

Punch punch_at(const JsonPlace& place, Profiles& profiles) {
  return {.id = place["id"].text(),
          .profile = profiles.at(place["profile"]),
          .tip_radius = place["tip_radius"].length(),
          .angle = place["angle"].angle(),
          .segments = lengths_at(place["segments"]),
          .ears = ears_at(place["ears"]),
          .max_force = place["max_force"].maybe_number(),
          .raises_beam = place["raises_beam"].maybe_length().value_or(0.0)};
}

Die die_at(const JsonPlace& place, Profiles& profiles) {
  return {.id = place["id"].text(),
          .opening = place["opening"].length(),
          .angle = place["angle"].angle(),
          .shoulder_radius = place["shoulder_radius"].length(),
          .profile = profiles.at(place["profile"]),
          .segments = lengths_at(place["segments"]),
          .max_force = place["max_force"].maybe_number()};
}

std::optional<BackGauge> gauge_at(const JsonPlace& place, Profiles& profiles) {
  if (!place.given()) return std::nullopt;
  const std::vector<double> range = lengths_at(place["range"]);
  if (range.size() != 2) return std::nullopt;
  BackGauge gauge{range[0], range[1], place["finger_width"].length(), profiles.at(place["finger"])};
  if (const JsonPlace nose = place["nose"]; nose.given())
    gauge.nose = GaugeNose{nose["width"].length(), profiles.at(nose["profile"])};
  if (!place["lift"].given()) return gauge;
  const std::vector<double> lift = lengths_at(place["lift"]);
  if (lift.size() != 2) return std::nullopt;
  gauge.lowest = lift[0];
  gauge.highest = lift[1];
  return gauge;
}

PressBrake machine_at(const JsonPlace& place, Profiles& profiles) {
  return {.name = place["name"].text(),
          .force = place["force"].number(),
          .length = place["length"].length(),
          .upper_beam = profiles.at(place["upper_beam"]),
          .lower_beam = profiles.at(place["lower_beam"]),
          .gauge = gauge_at(place["gauge"], profiles)};
}

}  // namespace

const Schema& tools_schema() {
  static const Schema schema = make_tools_schema();
  return schema;
}

Result<BrakeTools> parse_tools(const std::string& json, const std::string& name) {
  JsonReading reading(json, "tools file", name, tools_schema());
  const JsonPlace file(reading);
  Profiles profiles;
  BrakeTools tools;
  tools.machine = machine_at(file["machine"], profiles);
  for (const JsonPlace& punch : file["punches"].items())
    tools.punches.push_back(punch_at(punch, profiles));
  for (const JsonPlace& die : file["dies"].items())
    tools.dies.push_back(die_at(die, profiles));
  if (reading.error()) return tl::unexpected(*reading.error());
  if (auto checked = check(tools); !checked) {
    Error error = std::move(checked.error());
    error.message = continued(std::move(error.message));
    say_before(error, "tools file: ");
    error.where = name + profiles.in_file(error.where);
    return fail(std::move(error));
  }
  return tools;
}

const BrakeTools& default_tools() {
  static const BrakeTools tools = [] {
    auto read = parse_tools(std::string(default_tools_json()), "european_tools.json");
    PLANISH_ASSERT(read.has_value());
    return std::move(*read);
  }();
  return tools;
}

}  // namespace planish::shop
