#include "part_drawing.hpp"

#include "facts.hpp"

#include <planish/base/message.hpp>
#include <planish/drawing/part_pages.hpp>
#include <planish/job/output_paths.hpp>
#include <planish/schema/units.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace planish::job {
using namespace drawing;
using namespace schema;
namespace {

std::string plan_words(const Report& report) {
  if (report.flat.bends.empty()) return "nothing to bend";
  const auto found = mapped(report.findings, &Finding::code);
  if (std::ranges::count(found, "cannot_bend")) return "cannot be bent";
  if (std::ranges::count(found, "no_plan")) return "no order found";
  return has_order(report.flat) ? "can be bent" : "not planned";
}

std::vector<std::pair<std::string, std::string>> facts_of(const Report& report) {
  const Units units(report.units);
  const auto length = [&](double mm) {
    return fmt::format("{} {}", units.short_text(mm), units.symbol());
  };
  const FlatPattern& flat = report.flat;
  std::vector<std::pair<std::string, std::string>> facts{
      {"material", report.material.empty() ? "unknown" : report.material},
      {"thickness", length(flat.thickness)},
      {"blank", units.short_text(report.size.x()) + " × " + length(report.size.y())},
      {"cutting length", length(flat.perimeter)},
      {"openings", std::to_string(flat.openings.size())},
      {"bends", std::to_string(flat.bends.size())},
      {"press brake", plan_words(report)}};
  if (report.mass) facts.emplace_back("mass", number_text(*report.mass, 3) + " kg");
  return facts;
}

}  // namespace

Result<std::string> part_drawing(const Made& made, int piece) {
  const Report& report = made.piece(piece);
  PartDrawing drawing{.title = is_nameless(report.body) ? stem_of_input(report.input) : report.body,
                      .subtitle = std::filesystem::path(report.input).filename().string(),
                      .facts = facts_of(report),
                      .flat = &report.flat,
                      .warnings = {},
                      .notes = report.notes,
                      .units = report.units};
  if (made.pieces() > 1)
    drawing.subtitle += fmt::format(", piece {} of {}", piece + 1, made.pieces());
  std::optional<PartView> view;
  if (!report.sheet.faces.empty()) view = isometric_view(report.sheet, report.layout);
  if (view) drawing.view = &*view;
  for (const Finding& finding : made.report().findings)
    if (finding.severity != Severity::info) drawing.warnings.push_back(finding.message);
  return pages_pdf(part_pages(drawing), drawing.title);
}

}  // namespace planish::job
