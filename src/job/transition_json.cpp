#include "json_reading.hpp"

#include <planish/job/transition_json.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace planish::job {
namespace {

constexpr auto kFormat = "planish/transition";
constexpr int kVersion = 1;
constexpr Allowed kPressAngle{"an angle above 0 and up to 360 degrees", 0.0, 360.0, false};
constexpr double kDefaultK = 0.5;

Vec2 plane_point_at(const JsonPlace& place) {
  const auto xy = place.items(2, "a point [x, y]");
  if (xy.empty()) return Vec2::Zero();
  return {xy[0].length(), xy[1].length()};
}

std::vector<Vec2> plane_points_at(const JsonPlace& place) {
  std::vector<Vec2> points;
  for (const JsonPlace& item : place.items())
    points.push_back(plane_point_at(item));
  return points;
}

Frame frame_at(const JsonPlace& place) {
  if (!place.given()) return {};
  place.keys({}, {"origin", "x", "normal"});
  const Vec3 origin = place["origin"].given() ? place["origin"].point() : Vec3::Zero();
  const Vec3 z = place["normal"].direction().value_or(Vec3::UnitZ());
  constexpr double kParallel = 1e-6;
  const bool x_given = place["x"].given();
  const Vec3 x = place["x"].direction().value_or(Vec3::UnitX());
  if (x.cross(z).norm() > kParallel) return frame_from_axes(origin, z, x);
  if (x_given)
    place["x"].mistake("is parallel to the normal: give a direction in the profile's plane");
  return frame_from_axes(origin, z,
                         x_given       ? Vec3(z.unitOrthogonal())
                         : z.x() > 0.0 ? Vec3(-Vec3::UnitZ())
                                       : Vec3::UnitZ());
}

Profile profile_at(const JsonPlace& place) {
  const auto members = place.members();
  place.keys({}, {"polygon", "circle", "ellipse", "rounded_rectangle", "obround", "spline"});
  if (members.size() != 1) {
    place.mistake("must be one of polygon, circle, ellipse, rounded_rectangle, obround, spline");
    return PolygonProfile{};
  }
  const auto& [kind, shape] = members.front();
  if (kind == "polygon") return PolygonProfile{plane_points_at(shape)};
  if (kind == "spline") return SplineProfile{plane_points_at(shape)};
  if (kind == "circle") {
    shape.keys({"radius"});
    const double radius = shape["radius"].length(kAboveZero);
    return EllipseProfile{radius, radius};
  }
  if (kind == "ellipse") {
    shape.keys({"rx", "ry"});
    return EllipseProfile{shape["rx"].length(kAboveZero), shape["ry"].length(kAboveZero)};
  }
  if (kind == "rounded_rectangle") {
    shape.keys({"width", "height", "radius"});
    return RoundedRectangleProfile{shape["width"].length(kAboveZero),
                                   shape["height"].length(kAboveZero),
                                   shape["radius"].length(kAtLeastZero)};
  }
  shape.keys({"length", "width"});
  return ObroundProfile{shape["length"].length(kAboveZero), shape["width"].length(kAboveZero)};
}

PlacedProfile placed_at(const JsonPlace& place) {
  place.keys({"profile"}, {"frame"});
  return {profile_at(place["profile"]), frame_at(place["frame"])};
}

std::optional<Seam> seam_at(const JsonPlace& place) {
  if (!place.given()) return std::nullopt;
  place.keys({}, {"edge", "corner", "parameter"});
  if (place.members().size() != 1) {
    place.mistake("must be one of edge, corner, parameter");
    return std::nullopt;
  }
  if (place["edge"].given()) return SeamEdge{place["edge"].index()};
  if (place["corner"].given()) return SeamCorner{place["corner"].index()};
  return SeamParameter{place["parameter"].number(kShare)};
}

Pieces pieces_at(const JsonPlace& place) {
  if (!place.given()) return Pieces::one;
  if (place.is_text("per_side")) return Pieces::per_side;
  const double count = place.number();
  if (count == 1.0) return Pieces::one;
  if (count == 2.0) return Pieces::two;
  place.mistake("must be 1, 2 or \"per_side\"");
  return Pieces::one;
}

Pressing pressing_at(const JsonPlace& place) {
  if (!place.given()) return {};
  place.keys({}, {"count", "max_angle", "chord"});
  if (place.members().size() != 1) {
    place.mistake("must be one of count, max_angle, chord");
    return {};
  }
  if (place["max_angle"].given()) return PressAngle{place["max_angle"].angle(kPressAngle)};
  if (place["chord"].given()) return PressChord{place["chord"].length(kAboveZero)};
  const int count = place["count"].index();
  if (count < 1) place["count"].mistake("is 0; give at least one line, or leave press_lines out");
  return PressCount{count};
}

TransitionSpec spec_at(const JsonPlace& place) {
  place.keys({"thickness", "from", "to"}, {"format", "version", "units", "k_factor", "sizes_are",
                                           "seam", "pieces", "press_lines"});
  place.format(kFormat, kVersion);
  place.read_unit();
  TransitionSpec spec;
  spec.thickness = place["thickness"].length(kAboveZero);
  spec.k_factor = place["k_factor"].maybe_number(kShare).value_or(kDefaultK);
  spec.from = placed_at(place["from"]);
  spec.to = placed_at(place["to"]);
  spec.sizes_are = place["sizes_are"].choice<SizesAre>(
      {{"inside", SizesAre::inside}, {"mid", SizesAre::mid}, {"outside", SizesAre::outside}},
      SizesAre::mid);
  spec.seam = seam_at(place["seam"]);
  spec.pieces = pieces_at(place["pieces"]);
  spec.pressing = pressing_at(place["press_lines"]);
  return spec;
}

}  // namespace

Result<TransitionFile> parse_transition(const std::string& json, const std::string& name) {
  JsonReading reading(json, "transition file", name);
  TransitionFile file;
  file.spec = spec_at(JsonPlace(reading));
  file.units = reading.unit();
  if (reading.error()) return tl::unexpected(*reading.error());
  return file;
}

}  // namespace planish::job
