#pragma once

#include <planish/base/progress.hpp>
#include <planish/base/result.hpp>
#include <planish/inspect/findings.hpp>
#include <planish/io/flat_writers.hpp>
#include <planish/sheet/certificate.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace planish {
class Body;
}

namespace planish::job {

/// Beyond these a certificate is doubted (a warning with its place) or disbelieved (the pattern is
/// refused as `pattern_wrong`).
struct CertificateBounds {
  double volume_warning =
      1e-3;  ///< |volume_ratio − 1|; models agree to far better, so it is a feature
  double volume_refusal = 0.02;  ///< |explained_ratio − 1|: more than slanted cuts make
  double unmeasured_refusal = 0.08;  ///< |volume_ratio − 1| where features could not be measured
  double length_warning = 0.01;  ///< mm; what a laser cutter holds
  double length_refusal = 0.5;   ///< mm
  double refold_warning = 0.02;  ///< mm; twice that, as two borders meet in a corner
  double refold_refusal = 0.5;   ///< mm
};

/// One request to unfold one body of a STEP file, as data.
struct UnfoldRequest {
  std::filesystem::path input;  ///< "-" reads standard input
  std::string body;             ///< number (1-based) or name; empty: the only body
  AllowanceRule allowance = ConstantK{};
  std::string root = "largest";  ///< "largest" or a face number
  std::string up =
      "auto";  ///< "auto", "reference", "other", or the number of a face that shall face up
  Rules rules;
  bool write_overlapping = false;     ///< write the pattern although it covers itself
  LengthUnit units = LengthUnit::mm;  ///< of the report
  CertificateBounds bounds;
  std::optional<double> density;  ///< kg/dm³; gives the mass
};

struct SheetSummary {
  double thickness = 0.0, thickness_spread = 0.0, volume = 0.0;
  int flanges = 0, bends = 0;
  std::optional<double>
      k_factor;          ///< of all bends; of the rule without bends; empty where they differ
  std::string k_source;  ///< likewise, "mixed" where they differ
};

enum class Status { ok, warning, refused };

/// What came of one body. `refusal` set: there is no pattern; `sheet` (thickness > 0) and `flat`
/// (outer contour not empty) then hold what was known. Lengths are mm; `units` is for the reports.
struct UnfoldReport {
  std::string input, body;
  int number = 1;          ///< of the body in its file, as `planish info` counts
  int bodies_in_file = 1;  ///< different ones
  int quantity = 1;
  std::optional<Error> refusal;
  SheetSummary sheet;
  FlatPattern flat;
  Vec2 size = Vec2::Zero();  ///< smallest enclosing rectangle, longer side first, mm
  Certificate certificate;
  std::vector<Finding> findings;
  std::vector<std::string> notes;
  std::optional<double> mass;      ///< kg, when the density is known
  std::vector<std::string> files;  ///< written, as the one who wrote them names them
  LengthUnit units = LengthUnit::mm;
  double read_seconds = 0.0, unfold_seconds = 0.0;
  bool has_pattern() const { return !refusal; }
  bool has_warnings() const;
  Status status() const;
};

/// Unfolds one body. An error means that the input could not be read or the request is wrong; a
/// body without flat pattern gives a report with `refusal`. Errors beyond those of `read_step`:
/// `no_such_body` (also for several bodies of which none is chosen), `no_such_face`, `bad_option`.
Result<UnfoldReport> unfold(const UnfoldRequest& request, const Progress& progress = {});

/// Unfolds every distinct body of the file (`request.body` is ignored), in file order. Whatever
/// goes wrong with one body is the refusal in its report; the others go on.
Result<std::vector<UnfoldReport>> unfold_all(const UnfoldRequest& request,
                                             const Progress& progress = {});

/// The part of both that begins with a body already read (`request.input` and `request.body` are
/// not looked at; `input`, `number`, `bodies_in_file` and `read_seconds` of the report not set).
Result<UnfoldReport> unfold_body(const Body& body, const UnfoldRequest& request,
                                 const Progress& progress = {});

/// The report of a request that ended with an error, so that scripts find its reason in one place.
UnfoldReport failed(const UnfoldRequest& request, const Error& error);

/// Report as JSON text with the keys of FORMATS.
std::string report_json(const UnfoldReport& report);
/// Summary of several bodies as JSON and as CSV (one row a body).
std::string summary_json(const std::vector<UnfoldReport>& reports);
std::string summary_csv(const std::vector<UnfoldReport>& reports);
/// The report as a person reads it on a terminal, and the summary of several bodies.
std::string report_text(const UnfoldReport& report);
std::string summary_text(const std::vector<UnfoldReport>& reports);

}  // namespace planish::job
