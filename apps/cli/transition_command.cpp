#include "commands.hpp"
#include "ending.hpp"
#include "make_plan.hpp"
#include "output_files.hpp"
#include "terminal.hpp"

#include <planish/job/transition.hpp>

#include <fmt/format.h>

namespace planish::cli {
namespace {

using job::TransitionReport;

std::string failed_json(const job::MakeRequest& request, const Error& error) {
  return job::report_json(job::failed_transition(request, error));
}

// net.dxf; of several pieces net-1.dxf, net-2.dxf, …
std::filesystem::path name_of_piece(const std::filesystem::path& path, std::size_t piece, std::size_t pieces) {
  if (pieces == 1) return path;
  return path.parent_path() / fmt::format("{}-{}{}", path.stem().string(), piece + 1, path.extension().string());
}

// All files, or the first reason why one cannot be composed. A mesh is that of the whole surface.
Result<std::vector<File>> files_of(const TransitionReport& report, const MakePlan& plan) {
  std::vector<File> files;
  const std::size_t count = report.pieces.size();
  DxfOptions dxf = plan.dxf;
  dxf.units = report.units;
  for (const auto& path : plan.folded) {
    if (!is_mesh_name(path)) continue;
    const auto mesh = transition_mesh(report.spec);
    if (!mesh) return tl::unexpected(mesh.error());
    files.push_back({path, mesh_text(*mesh, path, report.body)});
  }
  for (std::size_t i = 0; i < count; ++i) {
    for (const auto& path : plan.folded) {
      if (is_mesh_name(path)) continue;
      if (!report.pieces[i].solid) return tl::unexpected(report.pieces[i].solid.error());
      files.push_back({name_of_piece(path, i, count), *report.pieces[i].solid});
    }
    for (const Target& target : plan.flat) {
      auto text = job::composed(report.pieces[i], target.format, dxf);
      if (!text) return tl::unexpected(text.error());
      files.push_back({name_of_piece(target.path, i, count), std::move(*text)});
    }
  }
  return files;
}

std::optional<Error> write_files(TransitionReport& report, const MakePlan& plan) {
  const auto files = files_of(report, plan);
  if (!files) return files.error();
  if (auto error = write_all(*files, plan.inputs)) return error;
  append_names(report.files, *files);
  return std::nullopt;
}

}  // namespace

int run_transition(const MakeArguments& arguments) {
  const auto plan = planned(arguments);
  if (!plan) {
    job::MakeRequest request;
    request.input = arguments.input;
    request.units = arguments.units;
    return end_unplanned(arguments, plan.error(), failed_json(request, plan.error()));
  }
  ProgressLine line(!arguments.quiet);
  auto report = job::transition(plan->request, line.progress());
  if (!report)
    return end_failed(arguments, report.error(), failed_json(plan->request, report.error()));
  if (interrupted()) return complain({ErrorCode::cancelled, "cancelled", {}});
  if (report->has_pattern()) report->refusal = write_files(*report, *plan);
  return end_reported(arguments, *report);
}

}  // namespace planish::cli
