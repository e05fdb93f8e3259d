#include "facts.hpp"
#include "report_json.hpp"
#include "report_schema.hpp"
#include "report_text.hpp"

#include <planish/job/transition.hpp>
#include <planish/schema/json_parts.hpp>
#include <planish/schema/table.hpp>
#include <planish/schema/units.hpp>
#include <planish/sheet/pattern_facts.hpp>

#include <fmt/format.h>

namespace planish::job {
using namespace schema;
namespace {

std::string_view kind_word(PatchKind kind) {
  return word_of(kind, {"plane", "cylinder", "cone", "general"});
}

Json patches_json(const Transition& transition, const Units& units) {
  Json json = Json::array();
  for (const TransitionPatch& patch : transition.patches) {
    Json row;
    row["kind"] = kind_word(patch.kind);
    row["area"] = number_json(units.area(patch.area));
    row["borders"] = {number_json(units.length(patch.border[0])),
                      number_json(units.length(patch.border[1]))};
    row["turn"] = number_json(patch.turn.degrees());
    json.push_back(std::move(row));
  }
  return json;
}

/// All bends in the order of the profile, a row for each line.
Json press_lines_json(const Report& piece, const Units& units) {
  Json json = Json::array();
  for (const FlatBend& bend : piece.flat.bends)
    for (std::size_t i = 0; i < bend.lines.size(); ++i) {
      Json row;
      row["id"] = bend.lines.size() == 1 ? bend.id : fmt::format("{}.{}", bend.id, i + 1);
      row["piece"] = piece.body;
      row["angle"] = number_json(bend.line_angles[i].degrees());
      row["direction"] = direction_name(bend.direction);
      row["line"] = line_json(bend.lines[i], units);
      json.push_back(std::move(row));
    }
  return json;
}

Json transition_json(const TransitionReport& report, const Units& units) {
  const Transition& transition = report.transition;
  if (transition.pieces.empty()) return nullptr;
  Json json;
  json["area"] = number_json(units.area(transition.area));
  json["perimeters"] = {number_json(units.length(transition.perimeters[0])),
                        number_json(units.length(transition.perimeters[1]))};
  json["patches"] = patches_json(transition, units);
  json["press_lines"] = Json::array();
  for (const TransitionPiece& piece : report.pieces)
    for (Json& row : press_lines_json(piece, units))
      json["press_lines"].push_back(std::move(row));
  json["true_lengths"] = Json::array();
  for (const TrueLength& length : transition.true_lengths) {
    Json row;
    row["from"] = length.from;
    row["to"] = length.to;
    row["length"] = number_json(units.length(length.length));
    if (static_cast<std::size_t>(length.piece) >= report.pieces.size()) continue;  // not reported
    row["piece"] = report.pieces[length.piece].body;
    row["press_line"] = length.press.empty() ? Json(nullptr) : Json(length.press);
    row["points"] = {space_point_json(length.points[0], units),
                     space_point_json(length.points[1], units)};
    json["true_lengths"].push_back(std::move(row));
  }
  return json;
}

std::string patch_table(const TransitionReport& report, const Units& units) {
  Table table({{"patch"},
               {"surface"},
               {"area", Table::Align::right},
               {"first profile", Table::Align::right},
               {"second profile", Table::Align::right},
               {"turn", Table::Align::right}});
  int number = 0;
  for (const TransitionPatch& patch : report.transition.patches)
    table.add({std::to_string(++number), std::string(kind_word(patch.kind)),
               units.area_text(patch.area), units.length_text(patch.border[0]),
               units.length_text(patch.border[1]), angle_text(patch.turn)});
  return table.text();
}

}  // namespace

ReportDetails transition_report_details() {
  const Schema patch = object({required("kind", words({"plane", "cylinder", "cone", "general"})),
                               required("area", measured_area()),
                               required("borders", tuple(2, measured_length(), "two lengths")),
                               required("turn", angle(kAnyNumber).or_null())});
  const Schema press_line = object({required("id", text()), required("piece", text()),
                                    required("angle", angle(kAnyNumber).or_null()),
                                    required("direction", words({"up", "down"})),
                                    required("line", report_line())});
  const Schema true_length = object(
      {required("from", text()), required("to", text()), required("length", measured_length()),
       required("piece", text()), required("press_line", text().or_null()),
       required("points", tuple(2, report_space_point(), "two points"))});
  const Schema transition = object(
      {required("area", measured_area()),
       required("perimeters", tuple(2, measured_length(), "two lengths")),
       required("patches", list(patch)), required("press_lines", list(press_line)),
       required("true_lengths", list(true_length))});
  std::vector<Field> piece = common_report_fields();
  piece.insert(piece.begin(), required("body", text()));
  return {{optional("transition", transition.or_null()),
           optional("pieces", list(object(std::move(piece))))},
          {}};
}

std::string report_json(const TransitionReport& report) {
  const Units units(report.units);
  Json json = begun_report(report, "transition");
  finish_report(json, report);
  json["transition"] = transition_json(report, units);
  if (report.pieces.size() > 1) {
    json["pieces"] = Json::array();
    for (const TransitionPiece& piece : report.pieces) {
      Json row;
      row["body"] = piece.body;
      finish_report(row, piece);
      json["pieces"].push_back(std::move(row));
    }
  }
  return text_of(json);
}

std::string report_text(const TransitionReport& report) {
  const std::string table = patch_table(report, Units(report.units));
  if (report.pieces.size() < 2) return text_of(report, input_name(report), table);
  std::string text;
  for (std::size_t i = 0; i < report.pieces.size(); ++i) {
    Report piece = report.pieces[i];
    if (i + 1 == report.pieces.size()) piece.files = report.files;
    text += text_of(piece, piece.body, i == 0 ? table : "") + "\n";
  }
  return text;
}

}  // namespace planish::job
