#include "facts.hpp"
#include "report_json.hpp"
#include "report_schema.hpp"
#include "report_text.hpp"
#include "slit_equilibrium.hpp"

#include <planish/base/text.hpp>
#include <planish/job/slit.hpp>
#include <planish/schema/json_parts.hpp>
#include <planish/schema/table.hpp>
#include <planish/schema/units.hpp>

#include <fmt/format.h>

#include <cmath>

namespace planish::job {
using namespace schema;
namespace {

std::string_view status_word(StripStatus status) {
  return word_of(status, {"open", "solved", "out_of_reach"});
}

Json ridge_json(const SlitRidge& ridge, const Units& units) {
  Json json;
  json["flat"] = {point_json(ridge.flat[0], units), point_json(ridge.flat[1], units)};
  json["folded"] = {space_point_json(ridge.folded[0], units),
                    space_point_json(ridge.folded[1], units)};
  json["fold"] = number_json(ridge.fold.degrees());
  return json;
}

Json strip_json(const StripState& state, const FoldedStrip& strip, Ridges ridges,
                const Units& units) {
  Json json;
  json["status"] = status_word(state.status);
  json["gap"] = number_json(units.length(state.gap));
  json["shortfall"] = number_json(units.length(state.shortfall));
  json["min_radius"] = number_json(units.length(state.min_radius));
  json["energy"] = number_json(state.energy);
  json["runner_up_energy"] = number_json(state.runner_up_energy);
  json["iterations"] = state.iterations;
  json["seat_distance"] = number_json(units.length(state.seat_distance));
  json["anchor_distance"] = number_json(units.length(state.anchor_distance));
  json["scan_distance"] = number_json(units.length(state.scan_distance));
  json["crosses"] = state.crosses;
  json["crosses_plane"] = state.crosses_plane;
  json["below_ground"] = number_json(units.length(state.below_ground));
  json["ridges"] = Json::array();
  if (ridges == Ridges::left_out) return json;
  for (const SlitRidge& ridge : strip.ridges)
    json["ridges"].push_back(ridge_json(ridge, units));
  return json;
}

Json slit_json(const SlitReport& report, Ridges ridges, const Units& units) {
  if (report.strips.empty()) return nullptr;
  Json json;
  json["gap"] = number_json(units.length(report.gap));
  json["flat_deviation"] = report.refusal ? Json(nullptr)
                                          : number_json(units.length(report.flat_deviation));
  json["leg_scales"] = Json::array();
  for (const double scale : report.leg_scales)
    json["leg_scales"].push_back(number_json(scale));
  json["strips"] = Json::array();
  for (std::size_t i = 0; i < report.strips.size(); ++i)
    json["strips"].push_back(strip_json(report.strips[i], report.folded.strips[i], ridges, units));
  add_equilibrium(json, report, units);
  return json;
}

std::string radius_text(double radius, const Units& units) {
  return std::isfinite(radius) ? units.length_text(radius) : "flat";
}

std::string strip_table(const SlitReport& report, const Units& units) {
  Table table({{"strip"},
               {"", Table::Align::left},
               {"gap", Table::Align::right},
               {"radius", Table::Align::right},
               {"seat", Table::Align::right},
               {"anchors", Table::Align::right},
               {"scan", Table::Align::right},
               {"iterations", Table::Align::right}});
  for (std::size_t i = 0; i < report.strips.size(); ++i) {
    const StripState& strip = report.strips[i];
    table.add({std::to_string(i + 1), std::string(status_word(strip.status)),
               units.tiny_text(strip.gap), radius_text(strip.min_radius, units),
               units.length_text(strip.seat_distance), units.length_text(strip.anchor_distance),
               units.length_text(strip.scan_distance), std::to_string(strip.iterations)});
  }
  return table.text();
}

}  // namespace

ReportDetails slit_report_details() {
  const Schema ridge = object({required("flat", tuple(2, report_point(), "two points")),
                               required("folded", tuple(2, report_space_point(), "two points")),
                               required("fold", angle(kAnyNumber).or_null())});
  std::vector<Field> strip_fields = {required("status", words({"open", "solved", "out_of_reach"})),
                                     required("gap", measured_length()),
                                     required("shortfall", measured_length()),
                                     required("min_radius", measured_length()),
                                     required("energy", number(kAnyNumber)),
                                     required("runner_up_energy", number(kAnyNumber).or_null()),
                                     required("iterations", whole()),
                                     required("seat_distance", measured_length()),
                                     required("anchor_distance", measured_length()),
                                     required("scan_distance", measured_length()),
                                     required("crosses", list(whole())),
                                     required("crosses_plane", flag()),
                                     required("below_ground", measured_length()),
                                     required("ridges", list(ridge))};
  for (Field& field : strip_equilibrium_fields())
    strip_fields.push_back(std::move(field));
  const Schema strip = object(std::move(strip_fields));
  std::vector<Field> slit_fields = {
      required("gap", measured_length()), required("flat_deviation", measured_length()),
      required("leg_scales", list(number(kAnyNumber))), required("strips", list(strip))};
  for (Field& field : equilibrium_fields())
    slit_fields.push_back(std::move(field));
  return {{optional("slit", object(std::move(slit_fields)).or_null())}, {}};
}

std::string report_json(const SlitReport& report, Ridges ridges) {
  const Units units(report.units);
  Json json = begun_report(report, "slit");
  finish_report(json, report, ridges == Ridges::told ? BendList::shown : BendList::left_out);
  json["slit"] = slit_json(report, ridges, units);
  return text_of(json);
}

std::string report_text(const SlitReport& report) {
  const Units units(report.units);
  const std::string table = report.strips.empty() ? "" : strip_table(report, units);
  // There are too many ridges to read; the table of strips has what matters.
  if (report.refusal) return text_of(report, input_name(report), "", BendList::left_out) + table;
  return text_of(report, input_name(report),
                 table +
                     fmt::format("the developed sheet is the one that was cut, within {} {}\n",
                                 units.tiny_text(report.flat_deviation), units.symbol()) +
                     equilibrium_text(report),
                 BendList::left_out);
}

}  // namespace planish::job
