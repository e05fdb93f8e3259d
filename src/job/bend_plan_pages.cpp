#include "bend_pages.hpp"

#include <planish/job/bend_plan_pages.hpp>
#include <planish/job/tools_json.hpp>

namespace planish::job {

std::vector<Page> bend_plan_pages(const Report& report, const Bending& bending) {
  if (!report.plan) return bend_pages(report, bending, {});
  const BrakeTools& tools = bending.tools ? *bending.tools : default_tools();
  return bend_pages(
      report, bending,
      stroke_pictures(report.sheet, report.layout, tools, bending.plan, *report.plan));
}

}  // namespace planish::job
