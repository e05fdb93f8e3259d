#include "report_json.hpp"

#include "facts.hpp"
#include "places_json.hpp"
#include "plan_report.hpp"
#include "report_schema.hpp"
#include "tree_json.hpp"

#include <planish/job/unfold.hpp>
#include <planish/schema/json_parts.hpp>
#include <planish/schema/units.hpp>
#include <planish/sheet/pattern_facts.hpp>

namespace planish::job {
using namespace schema;
namespace {

Json sheet_json(const Report& report, const Units& units) {
  if (!sheet_known(report)) return nullptr;
  const SheetSummary& sheet = report.summary;
  Json json;
  json["thickness"] = number_json(units.length(sheet.thickness));
  json["thickness_spread"] = number_json(units.length(sheet.thickness_spread));
  json["k_factor"] = number_json(sheet.k_factor);
  json["k_source"] = sheet.k_source.empty() ? Json(nullptr) : Json(sheet.k_source);
  json["flanges"] = sheet.flanges;
  json["bends"] = sheet.bends;
  json["volume"] = number_json(units.volume(sheet.volume));
  json["mass"] = number_json(report.mass);
  return json;
}

Json bend_json(const FlatBend& bend, const Json& order, const Units& units) {
  Json json;
  json["id"] = bend.id;
  json["order"] = order;
  json["kind"] = kind_name(bend.kind);
  json["angle"] = number_json(bend.angle.degrees());
  json["inside_radius"] = number_json(units.length(bend.inside_radius));
  json["k_factor"] = number_json(bend.allowance.k_factor);
  json["k_source"] = bend.allowance.source;
  json["allowance"] = number_json(units.length(bend.allowance.allowance));
  json["deduction"] = number_json(units.length(bend.allowance.deduction));
  json["direction"] = direction_name(bend.direction);
  json["length"] = number_json(units.length(bend.length));
  const auto longest = longest_line(bend);
  json["line"] = longest ? line_json(*longest, units) : Json::array();
  json["lines"] = Json::array();
  for (const Segment& line : bend.lines)
    json["lines"].push_back(line_json(line, units));
  return json;
}

Json feature_json(const FlatFeature& feature, const Units& units) {
  Box2 box;
  for (const Loop& outline : feature.outlines)
    box.add(bounds(outline));
  Json json;
  json["kind"] = feature.kind;
  json["side"] = side_name(feature.side);
  json["at"] = box.empty() ? Json(nullptr) : point_json(0.5 * (box.lo + box.hi), units);
  json["size"] = box.empty() ? Json(nullptr) : point_json(box.size(), units);
  json["openings"] = feature.uncut_openings;
  if (feature.beyond_cut) json["beyond"] = number_json(units.length(*feature.beyond_cut));
  return json;
}

/// Bends are counted by the strokes that press them, as they come where no order is known.
void add_bends(Json& rows, const FlatPattern& flat, const Units& units,
               const BendDetails& details) {
  const bool planned = has_order(flat);
  int count = 0;
  for (const FlatBend& bend : flat.bends) {
    Json order = ++count;
    if (planned) order = bend.stroke ? Json(*bend.stroke) : Json(nullptr);
    rows.push_back(bend_json(bend, order, units));
    if (details) details(rows.back(), bend);
  }
}

Json flat_json(const Report& report, const Units& units, BendList bends,
               const BendDetails& details) {
  if (!flat_known(report)) return nullptr;
  const FlatPattern& flat = report.flat;
  Json json;
  json["area"] = number_json(units.area(flat.area));
  json["perimeter"] = number_json(units.length(flat.perimeter));
  json["size"] = point_json(report.size, units);
  json["openings"] = flat.openings.size();
  json["slits"] = slit_count(flat);
  json["cutting"]["outer"] = number_json(units.length(outer_cutting_length(flat)));
  json["cutting"]["inner"] = number_json(units.length(inner_cutting_length(flat)));
  json["bends"] = Json::array();
  if (bends == BendList::shown) add_bends(json["bends"], flat, units, details);
  if (bends == BendList::shown) json["tree"] = tree_json(report, units);
  if (!flat.labels.empty()) json["labels"] = Json::array();
  for (const FlatLabel& label : flat.labels)
    json["labels"].push_back({{"text", label.text}, {"at", point_json(label.at, units)}});
  json["features"] = Json::array();
  for (const FlatFeature& feature : flat.features) {
    json["features"].push_back(feature_json(feature, units));
  }
  return json;
}

Json openings_json(const OpeningCount& openings) {
  Json json;
  if (openings.solid) json["solid"] = *openings.solid;
  json["pattern"] = openings.pattern;
  if (openings.slits > 0) json["slits"] = openings.slits;
  json["features"] = openings.features;
  if (openings.loops > 0) json["loops"] = openings.loops;
  return json;
}

Json verification_json(const Report& report, const Units& units) {
  if (!certificate_known(report)) return nullptr;
  const Certificate& certificate = report.certificate;
  Json json;
  json["volume_ratio"] = number_json(or_nan(certificate.volume_ratio));
  json["explained_ratio"] = number_json(or_nan(certificate.explained_ratio));
  json["length_error"] = number_json(units.length(certificate.length_error));
  json["refold_deviation"] = number_json(units.length(or_nan(certificate.refold_deviation)));
  if (certificate.opening_error)
    json["opening_error"] = number_json(units.length(*certificate.opening_error));
  if (certificate.outline_error)
    json["outline_error"] = number_json(units.length(*certificate.outline_error));
  json["closure"] = number_json(units.length(report.flat.closure));
  json["area_at_half"] = number_json(units.area(certificate.flat_area_half));
  json["openings"] = openings_json(certificate.openings);
  json["places"]["length_error"] = point_json(certificate.length_error_at, units);
  json["places"]["refold_deviation"] = point_json(certificate.refold_at, units);
  if (certificate.opening_error)
    json["places"]["opening_error"] = point_json(certificate.opening_error_at, units);
  if (certificate.outline_error)
    json["places"]["outline_error"] = point_json(certificate.outline_error_at, units);
  return json;
}

}  // namespace

Json line_json(const Segment& line, const Units& units) {
  return Json::array({point_json(line.a, units), point_json(line.b, units)});
}

Json begun_report(const Report& report, std::string_view command) {
  Json json;
  json["format"] = "planish/report";
  json["version"] = 1;
  json["command"] = report.task.empty() ? command : report.task;
  json["input"] = report.input;
  if (!report.material.empty()) json["material"] = report.material;
  if (report.quantity != 1) json["quantity"] = report.quantity;
  return json;
}

void finish_report(Json& json, const Report& report, BendList bends, const BendDetails& details) {
  const Units units(report.units);
  json["units"] = units.name();
  json["status"] = status_name(report.status());
  json["reason"] = reason_json(report.refusal, units);
  json["sheet"] = sheet_json(report, units);
  json["flat"] = flat_json(report, units, bends, details);
  json["verification"] = verification_json(report, units);
  json["checks"] = Json::array();
  for (const Finding& finding : report.findings)
    json["checks"].push_back(check_json(finding, units));
  if (report.plan) json["plan"] = plan_json(*report.plan, report);
  json["notes"] = report.notes;
  json["files"] = report.files;
}

Json report_value(const UnfoldReport& report) {
  Json json = begun_report(report, "unfold");
  json["body"] = report.body;
  json["body_number"] = report.number;
  json["quantity"] = report.quantity;
  if (report.density) json["density"] = number_json(*report.density);
  if (!report.colour.empty()) json["colour"] = report.colour;
  finish_report(json, report);
  return json;
}

ReportDetails unfold_report_details() {
  return {{optional("body", any_text()), optional("body_number", whole(1)),
           optional("density", measured_number()), optional("colour", any_text())},
          {}};
}

std::string report_json(const UnfoldReport& report) { return text_of(report_value(report)); }

}  // namespace planish::job
