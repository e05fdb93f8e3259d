#include "commands.hpp"
#include "make_plan.hpp"
#include "ending.hpp"
#include "output_files.hpp"
#include "terminal.hpp"

#include <planish/brep/step.hpp>
#include <planish/job/connect.hpp>

namespace planish::cli {
namespace {

using job::ConnectReport;

std::string failed_json(const job::MakeRequest& request, const Error& error) {
  return job::report_json(job::failed(request, error));
}

// The folded part as the name of its file asks for it.
Result<std::string> folded_text(const ConnectReport& report, const std::filesystem::path& path) {
  if (!is_mesh_name(path)) return report.solid;
  const auto mesh = folded_mesh(with_open_seam(report.connection.sheet));
  if (!mesh) return tl::unexpected(mesh.error());
  return mesh_text(*mesh, path, stem_of(report.input));
}

// All files, or the first reason why one cannot be composed.
Result<std::vector<File>> files_of(const ConnectReport& report, const MakePlan& plan) {
  std::vector<File> files;
  for (const auto& path : plan.folded) {
    auto text = folded_text(report, path);
    if (!text) return tl::unexpected(text.error());
    files.push_back({path, std::move(*text)});
  }
  DxfOptions dxf = plan.dxf;
  dxf.units = report.units;
  for (const Target& target : plan.flat) {
    auto text = job::composed(report, target.format, dxf);
    if (!text) return tl::unexpected(text.error());
    files.push_back({target.path, std::move(*text)});
  }
  return files;
}

std::optional<Error> write_files(ConnectReport& report, const MakePlan& plan) {
  const auto files = files_of(report, plan);
  if (!files) return files.error();
  if (auto error = write_all(*files, plan.inputs)) return error;
  append_names(report.files, *files);
  return std::nullopt;
}

}  // namespace

int run_connect(const MakeArguments& arguments) {
  const auto plan = planned(arguments);
  if (!plan) {
    job::MakeRequest request;
    request.input = arguments.input;
    request.units = arguments.units;
    return end_unplanned(arguments, plan.error(), failed_json(request, plan.error()));
  }
  ProgressLine line(!arguments.quiet);
  auto report = job::connect(plan->request, line.progress());
  if (!report)
    return end_failed(arguments, report.error(), failed_json(plan->request, report.error()));
  if (interrupted()) return complain({ErrorCode::cancelled, "cancelled", {}});
  if (report->has_pattern()) report->refusal = write_files(*report, *plan);
  return end_reported(arguments, *report);
}

}  // namespace planish::cli
