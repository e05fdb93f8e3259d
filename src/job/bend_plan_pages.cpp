#include "bend_pages.hpp"
#include "bending.hpp"

#include <planish/job/bend_plan_pages.hpp>

namespace planish::job {

std::vector<Page> bend_plan_pages(const Report& report, const Bending& bending) {
  if (!report.plan) return bend_pages(report, bending, {});
  const BrakeTools& tools = tools_of(bending);
  return bend_pages(
      report, bending,
      stroke_pictures(report.sheet, report.layout, tools, bending.plan, *report.plan));
}

Result<std::string> bend_plan_file(const Made& made, const Bending& bending, PageFormat format) {
  std::vector<Page> pages;
  for (int piece = 0; piece < made.pieces(); ++piece)
    for (Page& page : bend_plan_pages(made.piece(piece), bending))
      pages.push_back(std::move(page));
  if (format == PageFormat::svg) return pages_svg(pages);
  return pages_pdf(pages, made.report().body + ", bend plan");
}

}  // namespace planish::job
