#pragma once

#include <planish/base/progress.hpp>
#include <planish/job/report.hpp>
#include <planish/sheet/certificate.hpp>
#include <planish/sheet/flat_pattern.hpp>
#include <planish/sheet/sheet.hpp>

#include <functional>
#include <optional>

namespace planish::job {

/// A sheet however it was made, and how its flat pattern is to be made and looked at.
struct SheetToLay {
  const Sheet& sheet;
  const EdgeDistance& distance;
  const PatternChecks& checks;
};

SheetSummary summary_of(const Sheet& sheet);

/// Lays the sheet flat, certifies and inspects it, and enters all of that in the report. What is
/// wrong comes back; what is known by then is in the report.
std::optional<Error> lay_flat(Report& report, const SheetToLay& given,
                              const FlattenOptions& options, const Progress& progress);

/// Does the work, which fills a report, and takes its time; an error of status 4 becomes the
/// report's refusal, any other comes back.
std::optional<Error> run_reporting(Report& report,
                                   const std::function<std::optional<Error>()>& work);

}  // namespace planish::job
