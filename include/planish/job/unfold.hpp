#pragma once

#include <filesystem>
#include <optional>
#include <planish/base/progress.hpp>
#include <planish/base/result.hpp>
#include <planish/inspect/findings.hpp>
#include <planish/io/flat_writers.hpp>
#include <planish/sheet/certificate.hpp>
#include <string>
#include <vector>

namespace planish::job {

/// One request to unfold one body of a STEP file, as data.
struct UnfoldRequest {
  std::filesystem::path input;  ///< "-" reads standard input
  std::string body;             ///< number (1-based) or name; empty: the only body
  AllowanceRule allowance = ConstantK{};
  std::string root = "largest";  ///< "largest" or a face number
  std::string up = "auto";       ///< "auto", "reference", "other", or the number of a face that shall face up
  Rules rules;
  bool write_overlapping = false;  ///< write the pattern although it covers itself
  LengthUnit units = LengthUnit::mm;  ///< of the report
};

struct SheetSummary {
  double thickness = 0.0, thickness_spread = 0.0, volume = 0.0;
  int flanges = 0, bends = 0;
};

/// What came of one body. `refusal` set: there is no pattern.
struct UnfoldReport {
  std::string input, body;
  int quantity = 1;
  std::optional<Error> refusal;
  SheetSummary sheet;
  FlatPattern flat;
  Vec2 size = Vec2::Zero();       ///< smallest enclosing rectangle, longer side first, mm
  Certificate certificate;
  std::vector<Finding> findings;
  std::vector<std::string> notes;
  LengthUnit units = LengthUnit::mm;
  double read_seconds = 0.0, unfold_seconds = 0.0;
  bool has_pattern() const { return !refusal; }
  bool has_warnings() const;
};

/// Unfolds one body. An error means that the input could not be read or the request is wrong; a
/// body without flat pattern gives a report with `refusal`.
Result<UnfoldReport> unfold(const UnfoldRequest& request, const Progress& progress = {});

/// Unfolds every distinct body of the file (`request.body` is ignored), in file order.
Result<std::vector<UnfoldReport>> unfold_all(const UnfoldRequest& request, const Progress& progress = {});

/// Report as JSON text with the keys of FORMATS.
std::string report_json(const UnfoldReport& report);
/// Summary of several bodies as JSON and as CSV (one row a body).
std::string summary_json(const std::vector<UnfoldReport>& reports);
std::string summary_csv(const std::vector<UnfoldReport>& reports);
/// The report as a person reads it on a terminal.
std::string report_text(const UnfoldReport& report);

}  // namespace planish::job
