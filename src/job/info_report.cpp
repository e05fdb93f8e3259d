#include "facts.hpp"
#include "places_json.hpp"

#include <planish/base/text.hpp>
#include <planish/job/info.hpp>
#include <planish/schema/json_parts.hpp>
#include <planish/schema/printable.hpp>
#include <planish/schema/table.hpp>
#include <planish/schema/units.hpp>

#include <fmt/format.h>

namespace planish::job {
using namespace schema;
namespace {

Json size_json(const Vec3& size, const Units& units) {
  return json_array(size, [&](double extent) { return number_json(units.length(extent)); });
}

Json sheet_json(const Result<SheetInfo>& sheet, const Units& units) {
  Json json;
  json["reason"] = reason_json(sheet ? std::nullopt : std::optional(sheet.error()), units);
  if (!sheet) return json;
  json["thickness"] = number_json(units.length(sheet->thickness));
  json["flanges"] = sheet->flanges;
  json["bends"] = sheet->bends;
  json["flange_faces"] = Json::array();
  for (const FlangeFaceInfo& face : sheet->faces) {
    json["flange_faces"].push_back(
        {{"number", face.number}, {"area", number_json(units.area(face.area))}});
  }
  return json;
}

Json body_json(const BodyInfo& body, const Units& units) {
  Json json;
  json["number"] = body.number;
  json["name"] = body.name;
  json["quantity"] = body.quantity;
  json["faces"] = body.faces;
  json["size"] = size_json(body.size, units);
  json["volume"] = number_json(units.volume(body.volume));
  if (!body.material.empty()) json["material"] = body.material;
  if (body.density) json["density"] = number_json(*body.density);
  if (!body.colour.empty()) json["colour"] = body.colour;
  if (body.sheet) json["sheet"] = sheet_json(*body.sheet, units);
  return json;
}

std::string sheet_text(const Result<SheetInfo>& sheet, const Units& units) {
  if (!sheet)
    return fmt::format("no flat pattern [{}]: {}", code_name(sheet.error().code),
                       printable(sheet.error().message));
  std::string text = fmt::format("sheet {} {}, {}, {}; faces that can be the root, with area:",
                                 units.short_text(sheet->thickness), units.symbol(),
                                 counted(sheet->flanges, "flange"), counted(sheet->bends, "bend"));
  for (const FlangeFaceInfo& face : sheet->faces) {
    text += fmt::format("{} {} ({})", &face == &sheet->faces.front() ? "" : ",", face.number,
                        units.area_text(face.area));
  }
  return text;
}

std::string body_table(const InfoReport& report, const Units& units) {
  using Align = Table::Align;
  const auto any = [&](std::string BodyInfo::*text) {
    return std::ranges::any_of(report.bodies,
                               [&](const BodyInfo& body) { return !(body.*text).empty(); });
  };
  const bool materials = any(&BodyInfo::material), colours = any(&BodyInfo::colour);
  std::vector<Table::Column> columns{{"no", Align::right},       {"body", Align::left, kNameShown},
                                     {"quantity", Align::right}, {"faces", Align::right},
                                     {"size", Align::right},     {"volume", Align::right}};
  if (materials) columns.push_back({"material", Align::left, kNameShown});
  if (colours) columns.push_back({"colour"});
  Table table(columns);
  for (const BodyInfo& body : report.bodies) {
    std::vector<std::string> cells{
        fmt::format("{}", body.number),
        body.name,
        fmt::format("{}", body.quantity),
        fmt::format("{}", body.faces),
        fmt::format("{} × {} × {}", units.length_text(body.size.x()),
                    units.length_text(body.size.y()), units.length_text(body.size.z())),
        fmt::format("{:.6g}", units.volume(body.volume))};
    if (materials) cells.push_back(body.material);
    if (colours) cells.push_back(body.colour);
    table.add(cells);
  }
  return table.text("  ");
}

}  // namespace

std::string info_json(const InfoReport& report, const std::optional<Error>& error) {
  const Units units(report.units);
  Json json;
  json["format"] = "planish/info";
  json["version"] = 1;
  json["command"] = "info";
  json["input"] = report.input;
  json["units"] = units.name();
  json["status"] = status_name(error ? Status::refused : Status::ok);
  json["reason"] = reason_json(error, units);
  json["schema"] = report.schema;
  json["cad_system"] = report.cad_system;
  json["file_units"] = report.file_unit;
  json["bodies"] = Json::array();
  for (const BodyInfo& body : report.bodies)
    json["bodies"].push_back(body_json(body, units));
  json["surface_bodies"] = report.surface_bodies;
  return text_of(json);
}

std::string info_text(const InfoReport& report) {
  const Units units(report.units);
  const auto said = [](const std::string& text) {
    return text.empty() ? "not stated" : printable_name(text);
  };
  const bool step = !report.schema.starts_with("B-rep");
  std::string text = fmt::format("{}: {}{}, made by {}, in {}\n", printable(report.input),
                                 step ? "STEP " : "", said(report.schema), said(report.cad_system),
                                 said(report.file_unit));
  text += fmt::format("{}, lengths in {}\n",
                      report.bodies.size() == 1
                          ? "1 body"
                          : fmt::format("{} different bodies", report.bodies.size()),
                      units.name());
  text += body_table(report, units);
  for (const BodyInfo& body : report.bodies) {
    if (body.sheet) text += fmt::format("  {}: {}\n", body.number, sheet_text(*body.sheet, units));
  }
  if (report.surface_bodies > 0) {
    text += fmt::format("not unfolded, because not part of a solid: {}\n",
                        counted(report.surface_bodies, "shell"));
  }
  return text;
}

}  // namespace planish::job
