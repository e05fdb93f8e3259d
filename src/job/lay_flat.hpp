#pragma once

#include <planish/base/progress.hpp>
#include <planish/brep/step.hpp>
#include <planish/job/report.hpp>
#include <planish/sheet/certificate.hpp>
#include <planish/sheet/flat_pattern.hpp>
#include <planish/sheet/sheet.hpp>

#include <array>
#include <chrono>
#include <optional>
#include <vector>

namespace planish::job {

/// The solid of a folded sheet.
struct FoldedBody {
  Body body;
  const Sheet& sheet;  ///< as it was folded: a seam may be open, a tip too sharp to fold cut off
  /// Lines along which edges meet to be welded; there they may overlap.
  std::vector<std::array<Vec3, 2>> seams = {};
};

/// A sheet from any maker, and how to make and check its flat pattern.
struct SheetToLay {
  const Sheet& sheet;
  const EdgeDistance& distance;
  const PatternChecks& checks;
  std::optional<FoldedBody> folded = {};  ///< empty if there is none, or if nobody asks
  ReliefOptions relief = {.shape = Relief::none};
  bool takes_relief = false;  ///< whether `relief` is an option of who asks
};

SheetSummary summary_of(const Sheet& sheet);

/// Lays the sheet flat, certifies and inspects it, and stores the results in the report. Returns
/// what is wrong; the report then holds what was found before.
std::optional<Error> lay_flat(Report& report, const SheetToLay& given,
                              const FlattenOptions& options, const Progress& progress);

/// What rips would open must lie flat without covering itself, with small overlaps mended. Errors:
/// `overlap`, `cancelled`, those of `flat_sheet`.
Result<void> lies_uncovered(const Sheet& sheet, const FlattenOptions& options,
                            const Progress& progress);

/// `recognize`, where a refusal names a rip only if rips lead to a pattern that does not cover
/// itself, which is checked here. Errors: those of `recognize`, `cancelled`.
Result<Recognized> found_sheet(const Body& body, RecognizeOptions options = {},
                               const Progress& progress = {});
/// What is looked for, as a request says.
RecognizeOptions sought_by(const Request& request);

/// Writes the sentences of findings and refusal in the report's unit.
void say_in_its_units(Report& report);

/// The report that `fill` completes, its sentences in its unit, with the time it took. An error
/// with exit status 4 is the report's refusal; any other leaves nothing to show.
template <typename R, typename Fill>
Outcome<R> reported(R report, const Fill& fill) {
  const auto start = std::chrono::steady_clock::now();
  std::optional<Error> error = fill(report);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  if (error && error->code.status != ExitStatus::refused)
    return fail(in_units(std::move(*error), report.units));
  report.unfold_seconds = taken.count();
  report.refusal = std::move(error);
  say_in_its_units(report);
  return report;
}

}  // namespace planish::job
