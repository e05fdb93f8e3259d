#include "bend_pages.hpp"

#include <planish/job/bend_plan_pages.hpp>
#include <planish/job/tools_json.hpp>

namespace planish::job {
namespace {

Result<std::vector<Page>> pages_of(const Report& report, const Bending& bending) {
  if (!report.plan || report.plan->strokes.empty())
    return fail(ErrorCode::bad_option, "there is no order of strokes to draw");
  const BrakeTools& tools = bending.tools ? *bending.tools : default_tools();
  return bend_pages(
      report, stroke_pictures(report.sheet, report.layout, tools, bending.plan, *report.plan));
}

}  // namespace

Result<std::string> bend_plan_pdf(const Report& report, const Bending& bending) {
  const auto pages = pages_of(report, bending);
  if (!pages) return tl::unexpected(pages.error());
  return pages_pdf(*pages, report.body + ", bend plan");
}

Result<std::string> bend_plan_svg(const Report& report, const Bending& bending) {
  const auto pages = pages_of(report, bending);
  if (!pages) return tl::unexpected(pages.error());
  return pages_svg(*pages);
}

}  // namespace planish::job
