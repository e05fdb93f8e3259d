#pragma once

#include "output_files.hpp"
#include "pattern_arguments.hpp"
#include "terminal.hpp"

#include <planish/base/result.hpp>

#include <string>

namespace planish::cli {

/// Says on the terminal what was done, unless quiet; on standard error where standard output
/// belongs to the JSON report.
void print_summary(const PatternArguments& arguments, const std::string& text);

/// Ends a request that failed as a whole: complains, and writes `json`, the report that says so, so
/// that scripts find the reason in the same place. Returns the exit status.
int end_failed(const PatternArguments& arguments, const Error& error, const std::string& json);

/// A command line that contradicts itself has no report; a side file that cannot be read has.
int end_unplanned(const PatternArguments& arguments, const Error& error, const std::string& json);

/// Ends a request that gave a report. Returns the exit status.
template <typename Report>
int end_reported(const PatternArguments& arguments, const Report& report) {
  if (const auto error = write_report(arguments.json, report_json(report))) {
    return complain(*error);
  }
  if (report.refusal) return complain(*report.refusal);
  print_summary(arguments, report_text(report));
  return 0;
}

}  // namespace planish::cli
