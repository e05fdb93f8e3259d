#include "commands.hpp"
#include "make_run.hpp"

#include <planish/brep/step.hpp>
#include <planish/job/connect.hpp>

namespace planish::cli {
namespace {

using job::ConnectReport;

// The folded part as the name of its file asks for it.
Result<std::string> folded_text(const ConnectReport& report, const std::filesystem::path& path) {
  if (!is_mesh_name(path)) return report.solid;
  const auto mesh = folded_mesh(with_open_seam(report.connection.sheet));
  if (!mesh) return tl::unexpected(mesh.error());
  return mesh_text(*mesh, path, stem_of(report.input));
}

Result<std::vector<File>> files_of(const ConnectReport& report, const MakePlan& plan) {
  std::vector<File> files;
  for (const auto& path : plan.folded) {
    auto text = folded_text(report, path);
    if (!text) return tl::unexpected(text.error());
    files.push_back({path, std::move(*text)});
  }
  return with_flat_files(std::move(files), report, plan);
}

}  // namespace

int run_connect(const MakeArguments& arguments) {
  return run_making<ConnectReport>(arguments, {job::connect, job::failed, files_of});
}

}  // namespace planish::cli
