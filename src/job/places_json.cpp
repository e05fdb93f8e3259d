#include "places_json.hpp"

#include "facts.hpp"
#include "report_schema.hpp"

#include <planish/job/reason.hpp>

#include <utility>

namespace planish::job {
using namespace schema;
namespace {

Json coordinates_json(const std::vector<double>& at, const Units& units) {
  return json_array(at, [&](double x) { return number_json(units.length(x)); });
}

Json remedy_json(const Remedy& remedy) {
  Json json;
  if (!remedy.option.empty()) {
    json["option"] = flag_of(remedy.option);
    json["value"] = remedy.value;
  }
  if (!remedy.change.empty()) json["change"] = remedy.change;
  return json;
}

Json points_json(const std::vector<Vec2>& points, const Units& units) {
  return json_array(points, [&](const Vec2& p) { return point_json(p, units); });
}

/// A place where a rule is broken: what it is about, and the first of its points.
Json breach_json(const FindingPlace& breach, const Units& units) {
  Place place = breach.places.empty() ? Place{} : breach.places.front();
  if (!breach.at.empty()) place = place::at(std::move(place), breach.at.front());
  Json json = place_json(place, units);
  json["severity"] = severity_name(breach.severity);
  json["message"] = breach.message;
  json["points"] = points_json(breach.at, units);
  if (!breach.numbers.empty()) json["numbers"] = numbers_json(breach.numbers);
  return json;
}

/// Of a finding that is no rule's: what it is about, else its points.
Json about_json(const Finding& finding, const Units& units) {
  if (!finding.about.empty()) return places_json(finding.about, units);
  return json_array(finding.at, [&](const Vec2& p) { return place_json(place::point(p), units); });
}

}  // namespace

Json place_json(const Place& place, const Units& units) {
  Json json;
  json["kind"] = kind_name(place.kind);
  if (const int* number = std::get_if<int>(&place.id)) json["id"] = *number;
  if (const std::string* name = std::get_if<std::string>(&place.id)) json["id"] = *name;
  if (!place.faces.empty()) json["faces"] = place.faces;
  if (!place.at.empty()) json["at"] = coordinates_json(place.at, units);
  return json;
}

Json places_json(const std::vector<Place>& places, const Units& units) {
  return json_array(places, [&](const Place& place) { return place_json(place, units); });
}

Json numbers_json(const std::vector<NamedQuantity>& numbers) {
  Json json = Json::object();
  for (const NamedQuantity& number : numbers)
    json[number.name] = {{"value", number_json(number.quantity.value)},
                         {"unit", number.quantity.unit}};
  return json;
}

Json wording_json(const std::vector<Piece>& pieces, const Units& units) {
  Json json = Json::array();
  bool names = false;
  for (const Piece& piece : pieces) {
    Json& row = json.emplace_back();
    row["text"] = piece.text;
    if (!piece.option.empty()) row["option"] = piece.option;
    if (piece.place) row["place"] = place_json(*piece.place, units);
    names = names || row.size() > 1;
  }
  return names ? json : Json::array();
}

void add_remedies(Json& json, const std::vector<Remedy>& remedies) {
  if (remedies.empty()) return;
  json["remedy"] = remedy_json(remedies.front());
  if (remedies.size() < 2) return;
  for (const Remedy& remedy : remedies)
    json["remedies"].push_back(remedy_json(remedy));
}

Json check_json(const Finding& finding, const Units& units) {
  Json json;
  json["code"] = finding.code;
  json["severity"] = severity_name(finding.severity);
  json["message"] = finding.message;
  json["at"] = points_json(finding.at, units);
  if (finding.places.empty()) {
    json["places"] = about_json(finding, units);
  } else {
    json["count"] = finding.places.size();
    for (const FindingPlace& breach : finding.places)
      json["places"].push_back(breach_json(breach, units));
  }
  json["numbers"] = numbers_json(finding.numbers);
  add_remedies(json, finding.remedies);
  return json;
}

Json reason_json(const std::optional<Error>& error, const Units& units) {
  if (!error) return nullptr;
  Json reason;
  reason["code"] = code_name(error->code);
  reason["message"] = error->message;
  if (const Json pieces = wording_json(wording(*error), units); !pieces.empty())
    reason["wording"] = pieces;
  reason["where"] = error->where;
  reason["places"] = places_json(error->places, units);
  reason["numbers"] = numbers_json(error->numbers);
  add_remedies(reason, error->remedies);
  return reason;
}

std::string reason_text(const Error& error) {
  return reason_json(error, Units(LengthUnit::mm))
      .dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::vector<Field> place_fields() {
  std::vector<Json> kinds;
  for (int i = 0; i <= static_cast<int>(PlaceKind::line); ++i)
    kinds.emplace_back(kind_name(static_cast<PlaceKind>(i)));
  Schema coordinates = list(measured_length());
  coordinates.least = 2;
  coordinates.most = 3;
  return {required("kind", values(std::move(kinds), "a kind of place")),
          optional("id", any_of({whole(), any_text()}, "a number or a name")),
          optional("faces", list(whole(1)).said("that meet at an edge")),
          optional("at", std::move(coordinates))};
}

Schema wording_schema() {
  const Schema piece = object({required("text", any_text()),
                               optional("option", text().said("that it names, as requests do")),
                               optional("place", object(place_fields()).said("that it names"))});
  return list(piece).said("the message in pieces");
}

Schema numbers_schema() {
  return map(object({required("value", measured_number()), required("unit", any_text())}));
}

std::vector<Field> remedy_fields() {
  const Schema remedy = object(
      {optional("option", text()), optional("value", any_text()), optional("change", text())});
  return {optional("remedy", remedy), optional("remedies", list(remedy))};
}

}  // namespace planish::job
