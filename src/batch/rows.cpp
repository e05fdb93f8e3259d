#include "rows.hpp"

#include <planish/sheet/csv.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <set>

namespace planish::batch {
namespace {

using Json = nlohmann::ordered_json;

struct Column {
  std::string_view title;
  std::string Row::*cell;
};
constexpr std::array kColumns{Column{"input", &Row::input},
                              Column{"body", &Row::body},
                              Column{"quantity", &Row::quantity},
                              Column{"status", &Row::status},
                              Column{"reason", &Row::reason},
                              Column{"message", &Row::message},
                              Column{"units", &Row::units},
                              Column{"thickness", &Row::thickness},
                              Column{"length", &Row::length},
                              Column{"width", &Row::width},
                              Column{"area", &Row::area},
                              Column{"outer_cutting", &Row::outer_cutting},
                              Column{"inner_cutting", &Row::inner_cutting},
                              Column{"openings", &Row::openings},
                              Column{"bends", &Row::bends},
                              Column{"mass", &Row::mass},
                              Column{"volume_ratio", &Row::volume_ratio},
                              Column{"warnings", &Row::warnings},
                              Column{"files", &Row::files},
                              Column{"same_as", &Row::same_as},
                              Column{"material", &Row::material}};

/// The value at a JSON pointer as text; empty for null and where there is none.
std::string text_at(const Json& json, const char* pointer) {
  const Json::json_pointer at(pointer);
  if (!json.contains(at)) return {};
  const Json& value = json[at];
  if (value.is_null()) return {};
  if (value.is_string()) return value.get<std::string>();
  return value.dump();
}

}  // namespace

Row row_of(const std::string& folder, const std::string& report) {
  const Json json = Json::parse(report);
  Row row{.input = text_at(json, "/input"),
          .body = text_at(json, "/body"),
          .folder = folder,
          .quantity = text_at(json, "/quantity"),
          .status = text_at(json, "/status"),
          .reason = text_at(json, "/reason/code"),
          .message = text_at(json, "/reason/message"),
          .units = text_at(json, "/units"),
          .thickness = text_at(json, "/sheet/thickness"),
          .length = text_at(json, "/flat/size/0"),
          .width = text_at(json, "/flat/size/1"),
          .area = text_at(json, "/flat/area"),
          .outer_cutting = text_at(json, "/flat/cutting/outer"),
          .inner_cutting = text_at(json, "/flat/cutting/inner"),
          .openings = text_at(json, "/flat/openings"),
          .bends = text_at(json, "/sheet/bends"),
          .mass = text_at(json, "/sheet/mass"),
          .volume_ratio = text_at(json, "/verification/volume_ratio"),
          .warnings = {},
          .files = {},
          .material = text_at(json, "/material")};
  int warnings = 0;
  std::set<std::string> codes;
  if (json.contains("checks") && json["checks"].is_array())
    for (const Json& finding : json["checks"])
      if (finding.value("severity", "") != "info") {
        ++warnings;
        codes.insert(finding.value("code", ""));
      }
  row.warnings = std::to_string(warnings);
  row.findings = fmt::format("{}", fmt::join(codes, ", "));
  if (json.contains("files") && json["files"].is_array())
    for (const Json& file : json["files"])
      row.files += (row.files.empty() ? "" : ";") + file.get<std::string>();
  return row;
}

std::string csv_titles() {
  std::vector<std::string> titles;
  for (const Column& column : kColumns)
    titles.emplace_back(column.title);
  return csv_row(titles);
}

std::string csv_of(const Row& row) {
  std::vector<std::string> cells;
  for (const Column& column : kColumns)
    cells.push_back(row.*column.cell);
  return csv_row(cells);
}

}  // namespace planish::batch
