#include "refusals.hpp"

#include <planish/io/flat_json.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <exception>

// A flat pattern as text that reads back to the same doubles, so that files written from it are the
// same to the byte. A curve is a row of numbers whose count tells its kind. A checksum shows
// damage: what parses but was not written by this version is refused and never guessed.

namespace planish {
namespace {

using FlatJson = nlohmann::ordered_json;

constexpr auto kFlatFormat = "planish/flat";
constexpr int kFlatVersion = 1;

/// Found in stored text that parses, but is not what was written.
class Damaged : public std::exception {};

void require(bool condition) {
  if (!condition) throw Damaged();
}

/// FNV-1a, 64 bits: shows damage, not intent.
std::string checksum(const std::string& text) {
  std::uint64_t sum = 0xcbf29ce484222325U;
  for (const char c : text)
    sum = (sum ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  return fmt::format("{:016x}", sum);
}

std::string stored(const FlatJson& json) {
  return json.dump(-1, ' ', false, FlatJson::error_handler_t::replace);
}

// A curve is a row of numbers, and their count says which kind it is: 4 for a segment, 5 for an
// arc, 8, 14, 20, … for a spline.
constexpr std::size_t kSegmentNumbers = 4, kArcNumbers = 5;

FlatJson json_of(const Vec2& p) { return {p.x(), p.y()}; }

FlatJson json_of(const Segment& line) { return {line.a.x(), line.a.y(), line.b.x(), line.b.y()}; }

FlatJson json_of(const Curve2& curve) {
  if (const auto* line = std::get_if<Segment>(&curve)) return json_of(*line);
  if (const auto* arc = std::get_if<Arc>(&curve))
    return {arc->center.x(), arc->center.y(), arc->radius, arc->start, arc->sweep};
  FlatJson numbers = FlatJson::array();
  for (const Vec2& pole : std::get<CubicSpline>(curve).poles) {
    numbers.push_back(pole.x());
    numbers.push_back(pole.y());
  }
  return numbers;
}

FlatJson json_of(const Contour& contour);
FlatJson json_of(const Angle& angle);
FlatJson json_of(const FlatBend& bend);
FlatJson json_of(const FlatFeature& feature);
FlatJson json_of(const FlatLabel& label);

template <typename T>
FlatJson json_of(const std::vector<T>& rows) {
  FlatJson json = FlatJson::array();
  for (const T& row : rows)
    json.push_back(json_of(row));
  return json;
}

FlatJson json_of(const Contour& contour) { return json_of(contour.loop); }

FlatJson json_of(const Angle& angle) { return angle.radians(); }

FlatJson json_of(const FlatBend& bend) {
  return {{"id", bend.id},
          {"kind", static_cast<int>(bend.kind)},
          {"angle", bend.angle.radians()},
          {"radius", bend.inside_radius},
          {"k", bend.allowance.k_factor},
          {"allowance", bend.allowance.allowance},
          {"deduction", bend.allowance.deduction},
          {"source", bend.allowance.source},
          {"down", bend.direction == BendDirection::down},
          {"lines", json_of(bend.lines)},
          {"line_angles", json_of(bend.line_angles)},
          {"tangent_lines", json_of(bend.tangent_lines)},
          {"length", bend.length},
          {"stroke", bend.stroke ? FlatJson(*bend.stroke) : FlatJson(nullptr)}};
}

FlatJson json_of(const FlatFeature& feature) {
  return {{"kind", feature.kind},
          {"side", static_cast<int>(feature.side)},
          {"outlines", json_of(feature.outlines)},
          {"uncut_openings", feature.uncut_openings},
          {"pilots", json_of(feature.pilots)},
          {"along", json_of(feature.along)},
          {"beyond_cut", feature.beyond_cut ? FlatJson(*feature.beyond_cut) : FlatJson(nullptr)}};
}

FlatJson json_of(const FlatLabel& label) {
  return {{"at", json_of(label.at)}, {"text", label.text}};
}

FlatJson json_of(const FlatPattern& pattern) {
  return {{"thickness", pattern.thickness},        {"outer", json_of(pattern.outer)},
          {"openings", json_of(pattern.openings)}, {"slits", json_of(pattern.slits)},
          {"bends", json_of(pattern.bends)},       {"features", json_of(pattern.features)},
          {"labels", json_of(pattern.labels)},     {"area", pattern.area},
          {"perimeter", pattern.perimeter},        {"closure", pattern.closure}};
}

double number_in(const FlatJson& json) { return json.get<double>(); }

/// The rows of an array, each read by `read`.
template <typename Read>
auto rows_in(const FlatJson& json, Read read) {
  require(json.is_array());
  return mapped(json, [&](const FlatJson& row) { return read(row); });
}

Vec2 point_in(const FlatJson& json) {
  require(json.is_array() && json.size() == 2);
  return {number_in(json[0]), number_in(json[1])};
}

Curve2 curve_in(const FlatJson& json) {
  const std::vector<double> n = rows_in(json, number_in);
  if (n.size() == kSegmentNumbers) return Segment{{n[0], n[1]}, {n[2], n[3]}};
  if (n.size() == kArcNumbers) return Arc{{n[0], n[1]}, n[2], n[3], n[4]};
  require(n.size() % 2 == 0);
  CubicSpline spline;
  for (std::size_t i = 0; i < n.size(); i += 2)
    spline.poles.emplace_back(n[i], n[i + 1]);
  return spline;
}

Segment segment_in(const FlatJson& json) {
  const Curve2 read = curve_in(json);
  require(std::holds_alternative<Segment>(read));
  return std::get<Segment>(read);
}

Loop loop_in(const FlatJson& json) { return rows_in(json, curve_in); }

Contour contour_in(const FlatJson& json) { return {loop_in(json), {}}; }

FlatBend bend_in(const FlatJson& json) {
  const int kind = json.at("kind").get<int>();
  require(kind >= static_cast<int>(BendKind::cylinder) &&
          kind <= static_cast<int>(BendKind::sharp));
  FlatBend bend;
  bend.id = json.at("id").get<std::string>();
  bend.kind = static_cast<BendKind>(kind);
  bend.angle = Angle::radians(number_in(json.at("angle")));
  bend.inside_radius = number_in(json.at("radius"));
  bend.allowance = {number_in(json.at("k")), number_in(json.at("allowance")),
                    number_in(json.at("deduction")), json.at("source").get<std::string>()};
  bend.direction = json.at("down").get<bool>() ? BendDirection::down : BendDirection::up;
  bend.lines = rows_in(json.at("lines"), segment_in);
  bend.line_angles = rows_in(json.at("line_angles"), [](const FlatJson& angle) {
    return Angle::radians(number_in(angle));
  });
  bend.tangent_lines = rows_in(json.at("tangent_lines"), segment_in);
  bend.length = number_in(json.at("length"));
  if (!json.at("stroke").is_null()) bend.stroke = json.at("stroke").get<int>();
  return bend;
}

FlatFeature feature_in(const FlatJson& json) {
  const int side = json.at("side").get<int>();
  require(side >= static_cast<int>(FormSide::both) && side <= static_cast<int>(FormSide::down));
  const FlatJson beyond = json.value("beyond_cut", FlatJson());  // older files have none
  return {.kind = json.at("kind").get<std::string>(),
          .side = static_cast<FormSide>(side),
          .outlines = rows_in(json.at("outlines"), loop_in),
          .uncut_openings = json.at("uncut_openings").get<int>(),
          .pilots = rows_in(json.at("pilots"), point_in),
          .along = rows_in(json.at("along"), point_in),
          .beyond_cut = beyond.is_null() ? std::nullopt : std::optional(number_in(beyond))};
}

FlatLabel label_in(const FlatJson& json) {
  return {point_in(json.at("at")), json.at("text").get<std::string>()};
}

FlatPattern pattern_in(const FlatJson& json) {
  FlatPattern pattern;
  pattern.thickness = number_in(json.at("thickness"));
  pattern.outer = contour_in(json.at("outer"));
  pattern.openings = rows_in(json.at("openings"), contour_in);
  pattern.slits = rows_in(json.at("slits"), curve_in);
  pattern.bends = rows_in(json.at("bends"), bend_in);
  pattern.features = rows_in(json.at("features"), feature_in);
  pattern.labels = rows_in(json.at("labels"), label_in);
  pattern.area = number_in(json.at("area"));
  pattern.perimeter = number_in(json.at("perimeter"));
  pattern.closure = number_in(json.at("closure"));
  return pattern;
}

tl::unexpected<Error> unreadable(const char* why) {
  return fail(refuse::unreadable_pattern, {{"why", why}});
}

/// A pattern that breaks a rule of `check`.
tl::unexpected<Error> against_rules(Error broken) {
  Error error = error_of(refuse::unreadable_pattern, {{"why", "it breaks a rule of patterns"}});
  say_after(error, broken);
  error.places = std::move(broken.places);
  error.numbers = std::move(broken.numbers);
  return fail(std::move(error));
}

}  // namespace

std::string flat_json(const FlatPattern& pattern) {
  require_valid(pattern);
  const std::string body = stored(json_of(pattern));
  return fmt::format(R"({{"format":"{}","version":{},"checksum":"{}","pattern":{}}})", kFlatFormat,
                     kFlatVersion, checksum(body), body);
}

Result<FlatPattern> read_flat_json(std::string_view text) {
  const FlatJson json = FlatJson::parse(text, nullptr, false);
  if (!json.is_object()) return unreadable("it is cut off or damaged");
  try {
    if (json.at("format") != kFlatFormat) return unreadable("it is of another format");
    if (json.at("version") != kFlatVersion)
      return unreadable("another version of the program has written it");
    require(json.at("checksum") == checksum(stored(json.at("pattern"))));
    FlatPattern pattern = pattern_in(json.at("pattern"));
    if (const auto sound = check(pattern); !sound) return against_rules(sound.error());
    return pattern;
  } catch (const std::exception&) {
    return unreadable("it is damaged");
  }
}

}  // namespace planish
