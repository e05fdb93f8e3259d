#include "bending.hpp"
#include "plan_report.hpp"
#include "proposal_report.hpp"
#include "refusals.hpp"
#include "report_text.hpp"

#include <planish/base/message.hpp>
#include <planish/base/text.hpp>
#include <planish/drawing/bend_pages.hpp>
#include <planish/io/flat_writers.hpp>
#include <planish/job/bend_plan_pages.hpp>
#include <planish/job/output_paths.hpp>

#include <fmt/format.h>

namespace planish::job {
namespace {

/// What the force and the angles are for, and what the file names if that is another metal.
std::string metal_of(const Bending& bending, const Report& report) {
  const bool other = report.plan &&
                     std::ranges::count(report.plan->remarks, "other_metal", &Remark::code) > 0;
  std::string text = other ? report.material + ", reckoned as " : "";
  text += fmt::format("{} {} N/mm²", bending.metal.empty() ? "steel" : bending.metal,
                      number_text(bending.plan.tensile_strength));
  const double springback = bending.plan.springback.degrees();
  return springback == 0.0 ? text : text + fmt::format(", springback {}°", number_text(springback));
}

/// The part as its file is called, and its body where that has a name of its own.
std::string title_of(const Report& report) {
  const std::string file = stem_of_input(input_name(report));
  return says_nothing(report.body, file) ? file : file + " · " + report.body;
}

std::optional<drawing::FlangeCheck> named(const std::optional<CheckDimension>& check) {
  if (!check) return std::nullopt;
  return drawing::FlangeCheck{flange_id(check->flange), check->length};
}

/// What keeps the part of a report from being bent; empty if it can be.
std::vector<BlockedBend> obstacles_of(const Report& report) {
  if (!report.plan || report.plan->status != PlanStatus::infeasible) return {};
  return report.plan->blocked.empty() ? report.plan->in_the_way : report.plan->blocked;
}

drawing::BendDrawing drawing_of(const Report& report, const Bending& bending) {
  drawing::BendDrawing drawing{.title = title_of(report),
                               .metal = metal_of(bending, report),
                               .thickness = report.summary.thickness,
                               .size = report.size,
                               .mass = report.mass,
                               .units = report.units,
                               .flat = report.flat,
                               .layout = report.layout,
                               .machine = tools_of(bending).machine.name,
                               .bed = tools_of(bending).machine.length,
                               .plan = report.plan ? &*report.plan : nullptr};
  for (const BlockedBend& blocked : obstacles_of(report)) {
    drawing.blocked.push_back(blocked.bend);
    drawing.obstacles.push_back(told_of(blocked, report).sentence);
  }
  if (!report.sheet.faces.empty())
    drawing.flanges = drawing::flange_names(report.sheet, report.layout);
  if (!report.plan) return drawing;
  for (const Proposal& proposal : report.plan->proposals)
    drawing.proposals.push_back(proposal_sentence(proposal, report));
  drawing.checks = mapped(checks_of(report, report.plan->strokes), named);
  for (const Remark& remark : report.plan->remarks)
    if (remark.code != kFurthestStage)
      drawing.notes.push_back(capitalized(in_units(remark.told, report.units).sentence) + ".");
  return drawing;
}

}  // namespace

std::vector<Page> bend_plan_pages(const Report& report, const Bending& bending) {
  std::vector<StrokePicture> pictures;
  if (report.plan)
    pictures = stroke_pictures(report.sheet, report.layout, tools_of(bending), bending.plan,
                               *report.plan);
  return drawing::bend_pages(drawing_of(report, bending), pictures);
}

std::vector<Page> bend_plan_pages(const Made& made, const Bending& bending) {
  std::vector<Page> pages;
  for (int piece = 0; piece < made.pieces(); ++piece)
    for (Page& page : bend_plan_pages(made.piece(piece), bending))
      pages.push_back(std::move(page));
  return pages;
}

Result<std::string> dxf_as_made(const Report& report, const Request& request) {
  if (report.not_as_made) return tl::unexpected(*report.not_as_made);
  if (report.as_made && !request.bending.as_made) return fail(refuse::plan_as_drawn, {}, "as_made");
  DxfOptions options = request.dxf;
  options.units = report.units;
  return dxf_text(report.flat, options);
}

}  // namespace planish::job
