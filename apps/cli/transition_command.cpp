#include "commands.hpp"
#include "make_run.hpp"

#include <planish/job/transition.hpp>

#include <fmt/format.h>

namespace planish::cli {
namespace {

using job::TransitionReport;

// net.dxf; of several pieces net-1.dxf, net-2.dxf, …
std::filesystem::path name_of_piece(const std::filesystem::path& path, std::size_t piece,
                                    std::size_t pieces) {
  if (pieces == 1) return path;
  return path.parent_path() /
         fmt::format("{}-{}{}", path.stem().string(), piece + 1, path.extension().string());
}

// All files, or the first reason why one cannot be composed. A mesh is that of the whole surface.
Result<std::vector<File>> files_of(const TransitionReport& report, const MakePlan& plan) {
  std::vector<File> files;
  const std::size_t count = report.pieces.size();
  for (const auto& path : plan.folded) {
    if (is_mesh_name(path))
      files.push_back({path, mesh_text(report.transition.mesh, path, report.body)});
  }
  for (std::size_t i = 0; i < count; ++i) {
    for (const auto& path : plan.folded) {
      if (is_mesh_name(path)) continue;
      if (!report.pieces[i].solid) return tl::unexpected(report.pieces[i].solid.error());
      files.push_back({name_of_piece(path, i, count), *report.pieces[i].solid});
    }
    auto flat = with_flat_files({}, report.pieces[i], plan);
    if (!flat) return flat;
    for (File& file : *flat)
      files.push_back({name_of_piece(file.path, i, count), std::move(file.content)});
  }
  return files;
}

}  // namespace

int run_transition(const MakeArguments& arguments) {
  return run_making<TransitionReport>(arguments,
                                      {job::transition, job::failed_transition, files_of});
}

}  // namespace planish::cli
