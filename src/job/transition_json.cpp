#include "makers.hpp"
#include "refusals.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/job/transition_json.hpp>
#include <planish/schema/json_reading.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace planish::job {
using namespace schema;
namespace {

constexpr auto kTransitionFormat = "planish/transition";
constexpr int kTransitionVersion = 1;
constexpr schema::Range kPressAngle{"an angle above 0 and up to 360 degrees", 0.0, 360.0, false};
constexpr double kDefaultK = 0.5;
constexpr int kMostPressLines = 2000;

const Words<SizesAre> kSizes{
    {"inside", SizesAre::inside}, {"mid", SizesAre::mid}, {"outside", SizesAre::outside}};

Schema profile_schema() {
  const Schema size = length(kAboveZero);
  return one_key(
      {optional("polygon", list(plane_point()).said("corners, in either direction")),
       optional("circle", object({required("radius", size)})),
       optional("ellipse", object({required("rx", size), required("ry", size)})),
       optional("rounded_rectangle", object({required("width", size), required("height", size),
                                             required("radius", length(kAtLeastZero))})),
       optional("obround", object({required("length", size), required("width", size)})),
       optional("spline", list(plane_point()).said("points of a smooth closed curve"))});
}

Schema placed_schema() {
  const Schema frame = object(
      {optional("origin", space_point().defaulting(Json::array({0, 0, 0}))),
       optional("x", space_direction().said("direction of the profile's x")),
       optional("normal", space_direction().defaulting(Json::array({0, 0, 1})))});
  return object({required("profile", profile_schema()),
                 optional("frame", frame.said("place of the profile's plane"))});
}

Schema seam_schema() {
  return one_key(
      {optional("edge", whole().said("in the middle of this edge of the first profile")),
       optional("corner", whole().said("at this corner of the first profile")),
       optional("parameter", number(kShare).said("at this share of the first profile's length"))});
}

Schema press_lines_schema() {
  return one_key(
      {optional("count", whole(1, kMostPressLines).said("number of lines in each curved patch")),
       optional("max_angle", angle(kPressAngle).said("largest angle of a line")),
       optional("chord", length(kAboveZero).said("largest distance between lines"))});
}

Schema make_transition_schema() {
  std::vector<Field> fields = header_fields(kTransitionFormat, kTransitionVersion);
  fields.push_back(optional("units", units()));
  fields.push_back(required("thickness", length(kAboveZero).said("of the sheet")));
  fields.push_back(optional("k_factor", number(kShare).defaulting(kDefaultK)));
  fields.push_back(required("from", placed_schema().said("the first profile")));
  fields.push_back(required("to", placed_schema().said("the second profile")));
  fields.push_back(optional("sizes_are", words(kSizes).defaulting("mid").said(
                                             "surface for which the profiles are given")));
  fields.push_back(optional("seam", seam_schema().said("where the sheet is closed")));
  fields.push_back(optional("pieces", values({1, 2, "per_side"}, "1, 2 or \"per_side\"")
                                          .defaulting(1)
                                          .said("how many pieces, or one for each side")));
  fields.push_back(
      optional("press_lines", press_lines_schema().said("how curved patches are pressed")));
  return object(std::move(fields)).said("Two profiles to be joined by a developable surface");
}

std::vector<Vec2> plane_points_at(const JsonPlace& place) {
  return mapped(place.items(), [&](const JsonPlace& item) { return item.plane_point(); });
}

Frame frame_at(const JsonPlace& place) {
  if (!place.given()) return {};
  const Vec3 origin = place["origin"].given() ? place["origin"].point() : Vec3::Zero();
  const Vec3 z = place["normal"].direction().value_or(Vec3::UnitZ());
  constexpr double kParallel = tolerance::kWrittenDigits;  // sine
  const bool x_given = place["x"].given();
  const Vec3 x = place["x"].direction().value_or(Vec3::UnitX());
  if (x.cross(z).norm() > kParallel) return frame_from_axes(origin, z, x);
  if (x_given) place["x"].mistake(refuse::x_along_normal);
  return frame_from_axes(origin, z,
                         x_given       ? Vec3(z.unitOrthogonal())
                         : z.x() > 0.0 ? Vec3(-Vec3::UnitZ())
                                       : Vec3::UnitZ());
}

Profile profile_at(const JsonPlace& place) {
  const auto members = place.members();
  if (members.size() != 1) return PolygonProfile{};
  const auto& [kind, shape] = members.front();
  if (kind == "polygon") return PolygonProfile{plane_points_at(shape)};
  if (kind == "spline") return SplineProfile{plane_points_at(shape)};
  if (kind == "circle") {
    const double radius = shape["radius"].length();
    return EllipseProfile{radius, radius};
  }
  if (kind == "ellipse") return EllipseProfile{shape["rx"].length(), shape["ry"].length()};
  if (kind == "rounded_rectangle")
    return RoundedRectangleProfile{shape["width"].length(), shape["height"].length(),
                                   shape["radius"].length()};
  return ObroundProfile{shape["length"].length(), shape["width"].length()};
}

PlacedProfile placed_at(const JsonPlace& place) {
  return {profile_at(place["profile"]), frame_at(place["frame"])};
}

std::optional<Seam> seam_at(const JsonPlace& place) {
  if (!place.given()) return std::nullopt;
  if (place["edge"].given()) return SeamEdge{place["edge"].whole()};
  if (place["corner"].given()) return SeamCorner{place["corner"].whole()};
  return SeamParameter{place["parameter"].number()};
}

Division pieces_at(const JsonPlace& place) {
  if (place.is_text()) return Division::per_side;
  return place.whole() == 2 ? Division::two : Division::one;
}

Pressing pressing_at(const JsonPlace& place) {
  if (!place.given()) return {};
  if (place["max_angle"].given()) return PressAngle{place["max_angle"].angle()};
  if (place["chord"].given()) return PressChord{place["chord"].length()};
  return PressCount{place["count"].whole()};
}

TransitionSpec spec_at(const JsonPlace& place) {
  TransitionSpec spec;
  spec.thickness = place["thickness"].length();
  spec.k_factor = place["k_factor"].number();
  spec.from = placed_at(place["from"]);
  spec.to = placed_at(place["to"]);
  spec.sizes_are = place["sizes_are"].choice(kSizes);
  spec.seam = seam_at(place["seam"]);
  spec.pieces = pieces_at(place["pieces"]);
  spec.pressing = pressing_at(place["press_lines"]);
  return spec;
}

}  // namespace

const Schema& transition_schema() {
  static const Schema schema = make_transition_schema();
  return schema;
}

Result<TransitionFile> parse_transition(const std::string& json, const std::string& name) {
  JsonReading reading(json, "transition file", name, transition_schema());
  TransitionFile file;
  const JsonPlace place(reading);
  file.spec = spec_at(place);
  file.has_default_k = !place["k_factor"].given();
  file.units = reading.unit();
  if (reading.error()) return tl::unexpected(*reading.error());
  return file;
}

}  // namespace planish::job
