#include "make_run.hpp"

namespace planish::cli {

Result<std::vector<File>> with_flat_files(std::vector<File> files, const job::Report& report,
                                          const MakePlan& plan) {
  DxfOptions dxf = plan.dxf;
  dxf.units = report.units;
  for (const Target& target : plan.flat) {
    auto text = job::composed(report, target.format, dxf, plan.svg);
    if (!text) return tl::unexpected(text.error());
    files.push_back({target.path, std::move(*text)});
  }
  return files;
}

Result<void> spare_inputs(const MakePlan& plan, const std::string& json,
                          const std::vector<std::filesystem::path>& inputs) {
  std::vector<std::filesystem::path> outputs = plan.folded;
  for (const Target& target : plan.flat)
    outputs.push_back(target.path);
  outputs.insert(outputs.end(), plan.mould.begin(), plan.mould.end());
  if (!json.empty() && json != "-") outputs.emplace_back(json);
  for (const auto& output : outputs)
    if (auto spared = spare_inputs(output, inputs); !spared) return spared;
  return {};
}

}  // namespace planish::cli
