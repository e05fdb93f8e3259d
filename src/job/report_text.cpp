#include "report_text.hpp"

#include "facts.hpp"
#include "plan_report.hpp"
#include "report_json.hpp"

#include <planish/base/text.hpp>
#include <planish/job/unfold.hpp>
#include <planish/schema/printable.hpp>
#include <planish/schema/table.hpp>
#include <planish/schema/units.hpp>
#include <planish/sheet/pattern_facts.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace planish::job {
using namespace schema;
namespace {

std::string title(const UnfoldReport& report) {
  std::string text = input_name(report);
  if (report.bodies_in_file > 1) {
    text += fmt::format(", body {} \"{}\"", report.number, printable_name(report.body));
  }
  if (report.quantity > 1) text += fmt::format(" ×{}", report.quantity);
  return text;
}

std::string sheet_line(const Report& report, const Units& units) {
  const SheetSummary& sheet = report.summary;
  std::string text = fmt::format("sheet {} {} (spread {}), {}, {}",
                                 units.short_text(sheet.thickness), units.symbol(),
                                 units.length_text(sheet.thickness_spread),
                                 counted(sheet.flanges, "flange"), counted(sheet.bends, "bend"));
  if (report.mass) text += fmt::format(", {:.3f} kg", *report.mass);
  return text;
}

std::string blank_line(const Report& report, const Units& units) {
  const FlatPattern& flat = report.flat;
  const auto unit = units.symbol();
  std::string text = fmt::format(
      "blank {} × {} {}, area {} {}², cutting length {} {} outer",
      units.length_text(report.size.x()), units.length_text(report.size.y()), unit,
      units.area_text(flat.area), unit, units.length_text(outer_cutting_length(flat)), unit);
  std::vector<std::string> within;
  if (!flat.openings.empty()) within.push_back(counted(flat.openings.size(), "opening"));
  if (!flat.slits.empty()) within.push_back(counted(slit_count(flat), "slit"));
  if (!within.empty())
    text += fmt::format(" + {} {} in {}", units.length_text(inner_cutting_length(flat)), unit,
                        listed(within));
  const std::string forms = forms_text(flat);
  if (!forms.empty()) text += fmt::format("\noutlined, not cut: {}", forms);
  return text + "\n";
}

std::string bend_table(const FlatPattern& flat, const Units& units) {
  if (flat.bends.empty()) return {};
  using Align = Table::Align;
  std::vector<Table::Column> columns{{"bend"},
                                     {"kind"},
                                     {"angle", Align::right},
                                     {"radius", Align::right},
                                     {"direction"},
                                     {"K", Align::right},
                                     {"from"},
                                     {"allowance", Align::right},
                                     {"deduction", Align::right},
                                     {"length", Align::right}};
  const bool planned = has_order(flat);
  if (planned) columns.push_back({"stroke", Align::right});
  Table table(std::move(columns));
  for (const FlatBend& bend : flat.bends) {
    std::vector<std::string> row{bend.id,
                                 std::string(kind_name(bend.kind)),
                                 angle_text(bend.angle),
                                 units.length_text(bend.inside_radius),
                                 std::string(direction_name(bend.direction)),
                                 fmt::format("{:.3f}", bend.allowance.k_factor),
                                 bend.allowance.source,
                                 units.length_text(bend.allowance.allowance),
                                 units.length_text(bend.allowance.deduction),
                                 units.length_text(bend.length)};
    if (planned) row.push_back(bend.stroke ? std::to_string(*bend.stroke) : "-");
    table.add(std::move(row));
  }
  return table.text();
}

std::string residual(double mm, const Units& units) {
  if (!std::isfinite(mm)) return "not measured";
  return fmt::format("within {} {}", units.tiny_text(mm), units.symbol());
}

std::string openings_text(const OpeningCount& openings) {
  if (!openings.solid) return {};
  std::string text = fmt::format(", openings {} of {}", openings.pattern, *openings.solid);
  if (openings.slits > 0)
    text += fmt::format(" ({} {})", openings.slits,
                        openings.slits == 1 ? "is a slit" : "are slits");
  if (openings.features > 0) text += fmt::format(", {} in features", openings.features);
  return text;
}

std::string certificate_line(const Report& report, const Units& units) {
  if (!certificate_known(report)) return {};
  const Certificate& certificate = report.certificate;
  std::string volume = std::isfinite(or_nan(certificate.volume_ratio))
                           ? fmt::format("{:.6f} (K = ½)", or_nan(certificate.volume_ratio))
                           : std::string("not measured");
  const double explained = or_nan(certificate.explained_ratio);
  constexpr double kShown = 5e-7;  // half of the last digit printed
  if (std::isfinite(explained) && std::abs(explained - or_nan(certificate.volume_ratio)) > kShown)
    volume += fmt::format(", {:.6f} without formed features and mitres", explained);
  return fmt::format("certificate: volume {}, edge lengths {}, refold {}{}\n", volume,
                     residual(certificate.length_error, units),
                     residual(or_nan(certificate.refold_deviation), units),
                     openings_text(certificate.openings));
}

std::string place_text(const Finding& finding, const Units& units) {
  if (finding.at.empty()) return {};
  const Vec2& p = finding.at.front();
  return fmt::format(" at ({}, {})", units.length_text(p.x()), units.length_text(p.y()));
}

std::string findings_text(const Report& report, const Units& units) {
  std::string text;
  for (const Finding& finding : report.findings) {
    text += fmt::format("  {} [{}]{}: {}\n", severity_name(finding.severity), finding.code,
                        place_text(finding, units), printable(finding.message));
  }
  return text.empty() ? text : "findings:\n" + text;
}

std::string lines_of(const std::vector<std::string>& items, std::string_view before) {
  std::string text;
  for (const std::string& item : items)
    text += fmt::format("{}{}\n", before, printable(item));
  return text;
}

}  // namespace

std::string angle_text(Angle angle) {
  std::string text = fmt::format("{:.2f}", angle.degrees());
  if (text.back() == '0') text.pop_back();  // always one decimal, a second only if needed
  return text + "°";
}

std::string said_on_command_line(const Error& error) {
  std::string text;
  for (const Piece& piece : wording(error))
    text += piece.option.empty() ? piece.text : flag_of(piece.option);
  return text;
}

std::string input_name(const Report& report) {
  if (report.input == "-") return "standard input";
  return std::filesystem::path(report.input).filename().string();
}

std::string text_of(const Report& report, const std::string& title, const std::string& tables,
                    BendList bends) {
  const Units units(report.units);
  std::string text = printable(title) + ": ";
  if (report.refusal) {
    text += fmt::format("refused [{}]: {}\n", code_name(report.refusal->code),
                        printable(said_on_command_line(*report.refusal)));
    if (sheet_known(report)) text += "  " + sheet_line(report, units) + "\n";
  } else {
    text += sheet_line(report, units) + "\n";
  }
  if (flat_known(report)) {
    text += blank_line(report, units);
    if (bends == BendList::shown) text += bend_table(report.flat, units);
    text += tables;
  }
  if (report.plan) text += plan_text(*report.plan, report);
  text += certificate_line(report, units);
  text += findings_text(report, units);
  text += lines_of(report.notes, "note: ");
  text += lines_of(report.files, "wrote ");
  return text;
}

std::string report_text(const UnfoldReport& report) { return text_of(report, title(report), {}); }

}  // namespace planish::job
