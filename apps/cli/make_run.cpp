#include "make_run.hpp"

namespace planish::cli {

Result<std::vector<File>> with_flat_files(std::vector<File> files, const job::Report& report, const MakePlan& plan) {
  DxfOptions dxf = plan.dxf;
  dxf.units = report.units;
  for (const Target& target : plan.flat) {
    auto text = job::composed(report, target.format, dxf, plan.svg);
    if (!text) return tl::unexpected(text.error());
    files.push_back({target.path, std::move(*text)});
  }
  return files;
}

}  // namespace planish::cli
