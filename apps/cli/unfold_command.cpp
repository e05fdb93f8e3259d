#include "commands.hpp"
#include "ending.hpp"
#include "terminal.hpp"
#include "unfold_files.hpp"
#include "unfold_plan.hpp"

#include <planish/job/unfold.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace planish::cli {
namespace {

using job::UnfoldReport;

constexpr int kDone = 0;

// The report of a request that failed as a whole.
int end_failed(const UnfoldArguments& arguments, const job::UnfoldRequest& request,
               const Error& error) {
  return end_failed(arguments, error, job::report_json(job::failed(request, error)));
}

int run_one(const UnfoldArguments& arguments, const UnfoldPlan& plan, ProgressLine& line) {
  auto report = job::unfold(plan.request, line.progress());
  if (!report) return end_failed(arguments, plan.request, report.error());
  if (interrupted()) return complain({ErrorCode::cancelled, "cancelled", {}});
  if (report->has_pattern() && !arguments.check) {
    report->refusal = write_pattern(*report, plan);
  }
  return end_reported(arguments, *report);
}

int end_all(const UnfoldArguments& arguments, const std::vector<UnfoldReport>& reports) {
  if (const auto error = write_report(arguments.json, job::summary_json(reports))) {
    return complain(*error);
  }
  print_summary(arguments, job::summary_text(reports));
  if (std::any_of(reports.begin(), reports.end(), [](const auto& r) { return r.has_pattern(); })) {
    return kDone;
  }
  // The first reason stands for all; the table has every one.
  Error none = *reports.front().refusal;
  if (reports.size() > 1) {
    none.message = fmt::format("none of the {} bodies has a flat pattern, the first because: {}",
                               reports.size(), none.message);
  }
  return complain(none);
}

int run_all(const UnfoldArguments& arguments, const UnfoldPlan& plan, ProgressLine& line) {
  auto reports = job::unfold_all(plan.request, line.progress());
  if (!reports) return end_failed(arguments, plan.request, reports.error());
  if (interrupted()) return complain({ErrorCode::cancelled, "cancelled", {}});
  if (!arguments.check) {
    if (const auto error = write_patterns(*reports, plan)) {
      return end_failed(arguments, plan.request, *error);
    }
  }
  return end_all(arguments, *reports);
}

// Not even the side files of the request could be read.
int end_unplanned(const UnfoldArguments& arguments, const Error& error) {
  job::UnfoldRequest request;
  request.input = arguments.input;
  request.body = arguments.body;
  request.units = arguments.units.value_or(LengthUnit::mm);
  return end_unplanned(arguments, error, job::report_json(job::failed(request, error)));
}

}  // namespace

int run_unfold(const UnfoldArguments& arguments) {
  const auto plan = planned(arguments);
  if (!plan) return end_unplanned(arguments, plan.error());
  ProgressLine line(!arguments.quiet);
  return arguments.all ? run_all(arguments, *plan, line) : run_one(arguments, *plan, line);
}

}  // namespace planish::cli
