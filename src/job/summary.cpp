// Several bodies of one file, as a terminal, a table and a program read them. A body that was
// refused keeps its row, with its reason, so that each body has one. The whole is refused only if
// no body has a pattern.
#include "facts.hpp"
#include "report_json.hpp"
#include "report_text.hpp"

#include <planish/base/text.hpp>
#include <planish/job/unfold.hpp>
#include <planish/schema/json_parts.hpp>
#include <planish/schema/printable.hpp>
#include <planish/schema/table.hpp>
#include <planish/schema/units.hpp>
#include <planish/sheet/csv.hpp>
#include <planish/sheet/pattern_facts.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace planish::job {
using namespace schema;
namespace {

using Bodies = std::vector<Outcome<UnfoldReport>>;

const UnfoldReport& report_of(const Outcome<UnfoldReport>& body) {
  return body ? *body : body.error().shown.value();
}

int unfolded(const Bodies& bodies) {
  return static_cast<int>(
      std::ranges::count_if(bodies, [](const auto& body) { return body.has_value(); }));
}

// Of all bodies together: refused only if no body has a pattern.
Status status_of(const Bodies& bodies) {
  if (unfolded(bodies) == 0) return Status::refused;
  const bool clean = std::ranges::all_of(
      bodies, [](const auto& body) { return body && body->status() == Status::ok; });
  return clean ? Status::ok : Status::warning;
}

LengthUnit unit_of(const Bodies& bodies) {
  return bodies.empty() ? LengthUnit::mm : report_of(bodies.front()).units;
}

int pieces(const Bodies& bodies) {
  return sum_of(bodies, [](const auto& body) { return report_of(body).quantity; });
}

using Cells = std::vector<std::string>;

Cells fields(const UnfoldReport& report) {
  const Units units(report.units);
  Cells cells{fmt::format("{}", report.number),
              report.body,
              fmt::format("{}", report.quantity),
              std::string(status_name(report.status())),
              report.refusal ? std::string(code_name(report.refusal->code)) : "",
              report.refusal ? said_on_command_line(*report.refusal) : "",
              std::string(units.name())};
  const auto add = [&cells](bool known, const std::string& cell) {
    cells.push_back(known ? cell : "");
  };
  const bool sheet = sheet_known(report), flat = flat_known(report);
  const bool certified = certificate_known(report);
  add(sheet, csv_number(units.length(report.summary.thickness)));
  add(flat, csv_number(units.length(report.size.x())));
  add(flat, csv_number(units.length(report.size.y())));
  add(flat, csv_number(units.area(report.flat.area)));
  add(flat, csv_number(units.length(outer_cutting_length(report.flat))));
  add(flat, csv_number(units.length(inner_cutting_length(report.flat))));
  add(flat, fmt::format("{}", report.flat.openings.size()));
  add(sheet, fmt::format("{}", report.summary.bends));
  add(report.mass.has_value(), csv_number(or_nan(report.mass)));
  add(certified, csv_number(or_nan(report.certificate.volume_ratio)));
  add(certified, csv_number(units.length(report.certificate.length_error)));
  add(certified, csv_number(units.length(or_nan(report.certificate.refold_deviation))));
  const auto warnings = std::ranges::count_if(
      report.findings, [](const auto& f) { return f.severity != Severity::info; });
  cells.push_back(fmt::format("{}", warnings));
  cells.push_back(fmt::format("{}", fmt::join(report.files, ";")));
  return cells;
}

const Cells& field_names() {
  static const Cells names{
      "number",  "body",          "quantity",      "status",           "reason",
      "message", "units",         "thickness",     "length",           "width",
      "area",    "outer_cutting", "inner_cutting", "openings",         "bends",
      "mass",    "volume_ratio",  "length_error",  "refold_deviation", "warnings",
      "files"};
  return names;
}

// The last column of the terminal's table.
std::string outcome(const UnfoldReport& report) {
  if (!report.refusal) return fmt::format("{}", fmt::join(report.files, ", "));
  return fmt::format("{}: {}", code_name(report.refusal->code),
                     said_on_command_line(*report.refusal));
}

// Thickness, blank, number of bends and certificate, as far as known.
Cells measures(const UnfoldReport& report, const Units& units) {
  Cells cells(6);
  if (sheet_known(report)) {
    cells[0] = units.short_text(report.summary.thickness);
    cells[2] = fmt::format("{}", report.summary.bends);
  }
  if (flat_known(report)) {
    cells[1] = fmt::format("{} × {}", units.length_text(report.size.x()),
                           units.length_text(report.size.y()));
  }
  if (certificate_known(report)) {
    const Certificate& certificate = report.certificate;
    cells[3] = fmt::format("{:.6f}", or_nan(certificate.volume_ratio));
    cells[4] = units.tiny_text(certificate.length_error);
    cells[5] = units.tiny_text(or_nan(certificate.refold_deviation));
  }
  return cells;
}

std::string warnings_text(const Bodies& bodies) {
  std::string text;
  for (const auto& body : bodies) {
    const UnfoldReport& report = report_of(body);
    for (const Finding& finding : report.findings) {
      if (finding.severity == Severity::info) continue;
      text += fmt::format("  body {}: {} [{}]: {}\n", report.number,
                          severity_name(finding.severity), finding.code,
                          printable(finding.message));
    }
  }
  return text;
}

}  // namespace

std::string summary_json(const Bodies& bodies) {
  Json json;
  json["format"] = "planish/summary";
  json["version"] = 1;
  json["command"] = "unfold";
  json["input"] = bodies.empty() ? "" : report_of(bodies.front()).input;
  json["units"] = Units(unit_of(bodies)).name();
  json["status"] = status_name(status_of(bodies));
  json["unfolded"] = unfolded(bodies);
  json["refused"] = static_cast<int>(bodies.size()) - unfolded(bodies);
  json["pieces"] = pieces(bodies);
  json["surface_bodies"] = bodies.empty() ? 0 : report_of(bodies.front()).surface_bodies;
  json["bodies"] = Json::array();
  for (const auto& body : bodies)
    json["bodies"].push_back(report_value(report_of(body)));
  return text_of(json);
}

std::string summary_csv(const Bodies& bodies) {
  std::string text = csv_row(field_names());
  for (const auto& body : bodies)
    text += csv_row(fields(report_of(body)));
  return text;
}

std::string summary_text(const Bodies& bodies) {
  using Align = Table::Align;
  const Units units(unit_of(bodies));
  Table table({{"no", Align::right},
               {"body", Align::left, kNameShown},
               {"quantity", Align::right},
               {"status"},
               {"thickness", Align::right},
               {"blank", Align::right},
               {"bends", Align::right},
               {"volume", Align::right},
               {"edges", Align::right},
               {"refold", Align::right},
               {"file or reason"}});
  for (const auto& body : bodies) {
    const UnfoldReport& report = report_of(body);
    Cells cells{fmt::format("{}", report.number), report.body, fmt::format("{}", report.quantity),
                std::string(status_name(report.status()))};
    for (std::string& cell : measures(report, units))
      cells.push_back(std::move(cell));
    cells.push_back(outcome(report));
    table.add(std::move(cells));
  }
  std::string note;
  if (!bodies.empty() && report_of(bodies.front()).surface_bodies > 0)
    note = fmt::format("note: {}\n", note_of_surfaces(report_of(bodies.front())));
  return fmt::format("{} of {} unfolded ({} in all), lengths in {}\n{}{}{}", unfolded(bodies),
                     counted(bodies.size(), "different body/different bodies"),
                     counted(pieces(bodies), "piece"), units.name(), table.text("  "),
                     warnings_text(bodies), note);
}

}  // namespace planish::job
