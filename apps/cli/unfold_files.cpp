#include "unfold_files.hpp"

#include "output_files.hpp"

namespace planish::cli {
namespace {

namespace fs = std::filesystem;

// All files of one body, or the first reason why one cannot be composed.
Result<std::vector<File>> files_of(const job::UnfoldReport& report,
                                   const std::vector<Target>& targets, const UnfoldPlan& plan) {
  DxfOptions dxf = plan.dxf;
  dxf.units = report.units;
  std::vector<File> files;
  for (const Target& target : targets) {
    auto text = job::composed(report, target.format, dxf);
    if (!text) return tl::unexpected(text.error());
    files.push_back({target.path, std::move(*text)});
  }
  return files;
}

std::vector<Target> targets_in(const fs::path& folder, const std::string& stem,
                               const std::vector<job::OutputFormat>& formats) {
  std::vector<Target> targets;
  for (const job::OutputFormat format : formats) {
    targets.push_back({folder / job::file_name(stem, format), format});
  }
  return targets;
}

}  // namespace

std::optional<Error> write_pattern(job::UnfoldReport& report, const UnfoldPlan& plan) {
  auto files = files_of(report, plan.targets, plan);
  if (!files) return files.error();
  for (const File& file : *files) {
    if (!file.path.has_parent_path()) continue;
    if (auto error = make_folder(file.path.parent_path())) return error;
  }
  if (auto error = write_all(*files, plan.inputs)) return error;
  append_names(report.files, *files);
  return std::nullopt;
}

std::optional<Error> write_patterns(std::vector<job::UnfoldReport>& reports,
                                    const UnfoldPlan& plan) {
  const std::vector<std::string> stems = job::stems(reports);
  std::vector<File> all;
  for (std::size_t i = 0; i < reports.size(); ++i) {
    if (!reports[i].has_pattern()) continue;
    auto files = files_of(reports[i], targets_in(plan.folder, stems[i], plan.formats), plan);
    // A body whose pattern cannot be put in words must not stop the others.
    if (!files) {
      reports[i].refusal = files.error();
      continue;
    }
    append_names(reports[i].files, *files);
    for (File& file : *files)
      all.push_back(std::move(file));
  }
  if (auto error = make_folder(plan.folder)) return error;
  all.push_back({plan.folder / "summary.csv", job::summary_csv(reports)});
  all.push_back({plan.folder / "summary.json", job::summary_json(reports)});
  return write_all(all, plan.inputs);
}

}  // namespace planish::cli
