#include "commands.hpp"
#include "make_run.hpp"

#include <planish/job/slit.hpp>

namespace planish::cli {
namespace {

using job::SlitReport;

Result<std::vector<File>> files_of(const SlitReport& report, const MakePlan& plan) {
  auto files = flat_files(report, plan);
  if (!files) return files;
  for (const auto& path : plan.folded) {
    if (is_mesh_name(path)) {
      files->push_back({path, mesh_text(mesh_of(report.folded), path, report.body)});
      continue;
    }
    if (!report.surface) return tl::unexpected(report.surface.error());
    files->push_back({path, *report.surface});
  }
  return files;
}

}  // namespace

int run_slit(const MakeArguments& arguments) {
  // Ridges are drawn but too many to be labelled; strips are.
  return run_making<SlitReport>(arguments, {job::slit, job::failed_slit, files_of, {.labels = false}});
}

}  // namespace planish::cli
