#include "facts.hpp"
#include "report_json.hpp"
#include "report_schema.hpp"
#include "report_text.hpp"

#include <planish/job/connect.hpp>
#include <planish/schema/json_parts.hpp>
#include <planish/schema/table.hpp>
#include <planish/schema/units.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace planish::job {
using namespace schema;
namespace {

std::string_view facing_name(EdgeKind kind) {
  return kind == EdgeKind::facing ? "facing" : "averted";
}

std::string_view lateral_name(LateralBoundary lateral) {
  constexpr std::string_view kWords[] = {"auto", "straight", "arc", "corner"};
  return kWords[static_cast<int>(lateral)];
}

const FittedBend* fitted(const ConnectReport& report, BendId id) {
  const auto& bends = report.connection.bends;
  const auto found = std::find_if(bends.begin(), bends.end(),
                                  [&](const FittedBend& bend) { return bend.bend == id; });
  return found == bends.end() ? nullptr : &*found;
}

std::vector<std::string> plate_ids(const FittedBend& bend, const PlateStructure& structure) {
  std::vector<std::string> ids;
  for (const int plate : bend.plates)
    ids.push_back(structure.plates[plate].id);
  return ids;
}

Json edges_json(const FittedBend& bend, const PlateStructure& structure) {
  Json json = Json::object();
  const auto ids = plate_ids(bend, structure);
  for (std::size_t side = 0; side < ids.size(); ++side)
    json[ids[side]] = bend.edges[side];
  return json;
}

Json stretch_json(const BendStretch& stretch, const FittedBend& bend,
                  const PlateStructure& structure, const Units& units) {
  Json json{{"edges", Json::object()}, {"width", number_json(units.length(stretch.width))}};
  const auto ids = plate_ids(bend, structure);
  for (std::size_t side = 0; side < ids.size(); ++side)
    json["edges"][ids[side]] = stretch.edges[side];
  return json;
}

Json direction_json(const Vec3& v) {
  return Json::array({number_json(v.x()), number_json(v.y()), number_json(v.z())});
}

Json frame_json(const BendFrame& frame, const Units& units) {
  Json json;
  json["origin"] = space_point_json(frame.origin, units);
  json["d"] = direction_json(frame.d);
  json["e1"] = direction_json(frame.e[0]);
  json["e2"] = direction_json(frame.e[1]);
  json["beta"] = number_json(frame.beta.degrees());
  json["rise"] = space_point_json(frame.rise, units);
  return json;
}

Json alternative_json(const BendAlternative& alternative, const Units& units) {
  Json json;
  json["edges"] = Json::object();
  const BendRequest& request = alternative.request;
  for (std::size_t side = 0; side < request.between.size(); ++side) {
    const auto& edges = request.edges[side];
    json["edges"][request.between[side]] = edges ? Json(*edges) : Json(nullptr);
  }
  json["surface"] = kind_name(alternative.kind);
  json["facing"] = facing_name(alternative.edge_kind);
  json["width"] = number_json(units.length(alternative.width));
  json["span"] = number_json(units.length(alternative.span));
  return json;
}

Json radii_json(const FittedBend& bend, const Units& units) {
  const bool even = bend.kind == BendKind::cylinder;
  Json json = Json::array();
  for (const double radius : bend.inside_radii)
    json.push_back(number_json(units.length(even ? bend.inside_radius : radius)));
  return json;
}

void add_fit(Json& json, const FittedBend& bend, const PlateStructure& structure,
             const Units& units) {
  json["between"] = plate_ids(bend, structure);
  json["edges"] = edges_json(bend, structure);
  json["surface"] = kind_name(bend.kind);
  json["facing"] = facing_name(bend.edge_kind);
  json["slope"] = number_json(bend.line.slope);
  json["offset"] = number_json(units.length(bend.line.offset));
  json["apex"] = bend.apex ? number_json(units.length(*bend.apex)) : Json(nullptr);
  json["half_angle"] = bend.half_angle ? number_json(bend.half_angle->degrees()) : Json(nullptr);
  json["inside_radii"] = radii_json(bend, units);
  json["lateral"] = lateral_name(bend.lateral);
  json["width"] = number_json(units.length(bend.width));
  json["span"] = number_json(units.length(bend.span));
  json["joined"] = number_json(units.length(bend.joined));
  json["stretches"] = Json::array();
  for (const BendStretch& stretch : bend.stretches)
    json["stretches"].push_back(stretch_json(stretch, bend, structure, units));
  json["extension_area"] = number_json(units.area(bend.extension_area));
  json["frame"] = frame_json(bend.frame, units);
  json["alternatives"] = Json::array();
  for (const BendAlternative& alternative : bend.alternatives)
    json["alternatives"].push_back(alternative_json(alternative, units));
}

std::string fit_table(const ConnectReport& report, const Units& units) {
  if (report.flat.bends.empty()) return {};
  using Align = Table::Align;
  Table table({{"bend"},
               {"between"},
               {"surface"},
               {"radius", Align::right},
               {"angle", Align::right},
               {"width", Align::right},
               {"extension area", Align::right}});
  for (const FlatBend& flat : report.flat.bends) {
    const FittedBend* bend = fitted(report, flat.bend);
    if (!bend) continue;
    const auto ids = plate_ids(*bend, report.connection.structure);
    table.add({flat.id, fmt::format("{}", fmt::join(ids, " – ")),
               std::string(kind_name(bend->kind)), units.length_text(bend->inside_radius),
               angle_text(bend->angle), units.length_text(bend->joined),
               units.area_text(bend->extension_area)});
  }
  return table.text();
}

}  // namespace

ReportDetails connect_report_details() {
  const Schema direction = tuple(3, measured_number(), "a direction [x, y, z]");
  const Schema frame = object({required("origin", report_space_point()), required("d", direction),
                               required("e1", direction), required("e2", direction),
                               required("beta", angle(kAnyNumber).or_null()),
                               required("rise", report_space_point())});
  const Schema surface = words({"cylinder", "cone", "general", "sharp"});
  const Schema facing = words({"facing", "averted"});
  const Schema alternative = object({required("edges", map(list(whole()).or_null())),
                                     required("surface", surface), required("facing", facing),
                                     required("width", measured_length()),
                                     required("span", measured_length())});
  const Schema stretch = object(
      {required("edges", map(list(whole()))), required("width", measured_length())});
  return {{},
          {optional("between", list(text())), optional("edges", map(list(whole()))),
           optional("surface", surface), optional("facing", facing),
           optional("slope", measured_number()), optional("offset", measured_length()),
           optional("apex", measured_length()), optional("half_angle", angle(kAnyNumber).or_null()),
           optional("inside_radii", list(measured_length())),
           optional("lateral", words({"auto", "straight", "arc", "corner"})),
           optional("width", measured_length()), optional("span", measured_length()),
           optional("joined", measured_length()), optional("stretches", list(stretch)),
           optional("extension_area", measured_area()), optional("frame", frame),
           optional("alternatives", list(alternative))}};
}

std::string report_json(const ConnectReport& report) {
  const Units units(report.units);
  Json json = begun_report(report, "connect");
  finish_report(json, report, BendList::shown, [&](Json& bend, const FlatBend& flat) {
    if (const FittedBend* fit = fitted(report, flat.bend))
      add_fit(bend, *fit, report.connection.structure, units);
  });
  return text_of(json);
}

std::string report_text(const ConnectReport& report) {
  return text_of(report, input_name(report), fit_table(report, Units(report.units)));
}

}  // namespace planish::job
