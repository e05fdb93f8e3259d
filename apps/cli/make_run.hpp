#pragma once

#include "ending.hpp"
#include "make_plan.hpp"
#include "output_files.hpp"
#include "terminal.hpp"

#include <planish/base/progress.hpp>
#include <planish/base/result.hpp>
#include <planish/job/report.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace planish::cli {

/// How one command makes a sheet of what a file describes.
template <typename Report>
struct Making {
  Result<Report> (*make)(const job::MakeRequest&, const Progress&);
  Report (*failed)(const job::MakeRequest&, const Error&);
  /// All files, or the first reason why one cannot be composed.
  Result<std::vector<File>> (*files)(const Report&, const MakePlan&);
  SvgOptions svg = {};
  /// Files that the described file names and the command reads; empty where there are none.
  std::vector<std::filesystem::path> (*further_inputs)(const std::filesystem::path& input) =
      nullptr;
};

/// `files`, and behind them the flat pattern of a report in every format that is asked for.
Result<std::vector<File>> with_flat_files(std::vector<File> files, const job::Report& report,
                                          const MakePlan& plan);

/// `bad_option` when one of the outputs is one of `inputs`.
Result<void> spare_inputs(const MakePlan& plan, const std::string& json,
                          const std::vector<std::filesystem::path>& inputs);

/// Plans, makes, writes and reports. Returns the exit status.
template <typename Report>
int run_making(const MakeArguments& arguments, const Making<Report>& making) {
  auto plan = planned(arguments);
  if (!plan) {
    job::MakeRequest request;
    request.input = arguments.input;
    request.units = arguments.units;
    return end_unplanned(arguments, plan.error(),
                         report_json(making.failed(request, plan.error())));
  }
  plan->svg = making.svg;
  if (making.further_inputs)
    if (auto spared = spare_inputs(*plan, arguments.json, making.further_inputs(arguments.input));
        !spared)
      return complain(spared.error());
  ProgressLine line(!arguments.quiet);
  auto report = making.make(plan->request, line.progress());
  if (!report)
    return end_failed(arguments, report.error(),
                      report_json(making.failed(plan->request, report.error())));
  const Error cancelled{ErrorCode::cancelled, "cancelled", {}};
  if (interrupted()) return complain(cancelled);
  if (!report->has_pattern()) return end_reported(arguments, *report);
  const auto files = making.files(*report, *plan);
  if (interrupted()) return complain(cancelled);
  report->refusal = files ? write_all(*files, plan->inputs) : std::optional(files.error());
  if (!report->refusal) append_names(report->files, *files);
  return end_reported(arguments, *report);
}

}  // namespace planish::cli
