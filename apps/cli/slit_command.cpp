#include "commands.hpp"
#include "make_run.hpp"

#include <planish/brep/step.hpp>
#include <planish/job/slit.hpp>
#include <planish/slit/mould.hpp>

namespace planish::cli {
namespace {

using job::SlitReport;

Result<std::vector<File>> files_of(const SlitReport& report, const MakePlan& plan) {
  std::vector<File> files;
  for (const auto& path : plan.folded) {
    if (is_mesh_name(path)) {
      files.push_back({path, mesh_text(mesh_of(report.folded), path, report.body)});
      continue;
    }
    auto surface = folded_surface_step(sheet_of(report.folded), report.body);
    if (!surface) return tl::unexpected(surface.error());
    files.push_back({path, std::move(*surface)});
  }
  if (plan.mould.empty()) return with_flat_files(std::move(files), report, plan);
  const auto mould = mould_of(report.folded);
  if (!mould) return tl::unexpected(mould.error());
  const Mesh mesh = mesh_of(*mould);
  for (const auto& path : plan.mould) {
    auto text = is_mesh_name(path)
                    ? Result<std::string>(mesh_text(mesh, path, report.body + " mould"))
                    : mesh_solid_step(mesh, report.body + " mould");
    if (!text) return tl::unexpected(text.error());
    files.push_back({path, std::move(*text)});
  }
  return with_flat_files(std::move(files), report, plan);
}

}  // namespace

int run_slit(const MakeArguments& arguments) {
  // Ridges are drawn but too many to be labelled; strips are.
  return run_making<SlitReport>(
      arguments, {job::slit, job::failed_slit, files_of, {.labels = false}, job::slit_point_files});
}

}  // namespace planish::cli
