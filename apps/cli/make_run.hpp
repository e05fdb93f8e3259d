#pragma once

#include "ending.hpp"
#include "make_plan.hpp"
#include "output_files.hpp"
#include "terminal.hpp"

#include <planish/base/progress.hpp>
#include <planish/base/result.hpp>
#include <planish/job/report.hpp>

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
};

/// `files`, and behind them the flat pattern of a report in every format that is asked for.
Result<std::vector<File>> with_flat_files(std::vector<File> files, const job::Report& report, const MakePlan& plan);

template <typename Report>
std::optional<Error> write_files(Report& report, const MakePlan& plan, const Making<Report>& making) {
  const auto files = making.files(report, plan);
  if (!files) return files.error();
  if (auto error = write_all(*files, plan.inputs)) return error;
  append_names(report.files, *files);
  return std::nullopt;
}

/// Plans, makes, writes and reports. Returns the exit status.
template <typename Report>
int run_making(const MakeArguments& arguments, const Making<Report>& making) {
  auto plan = planned(arguments);
  if (!plan) {
    job::MakeRequest request;
    request.input = arguments.input;
    request.units = arguments.units;
    return end_unplanned(arguments, plan.error(), report_json(making.failed(request, plan.error())));
  }
  plan->svg = making.svg;
  ProgressLine line(!arguments.quiet);
  auto report = making.make(plan->request, line.progress());
  if (!report) return end_failed(arguments, report.error(), report_json(making.failed(plan->request, report.error())));
  if (interrupted()) return complain({ErrorCode::cancelled, "cancelled", {}});
  if (report->has_pattern()) report->refusal = write_files(*report, *plan, making);
  return end_reported(arguments, *report);
}

}  // namespace planish::cli
