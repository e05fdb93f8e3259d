#pragma once

#include <planish/base/progress.hpp>
#include <planish/base/result.hpp>
#include <planish/job/report.hpp>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace planish {
class Body;
struct Recognized;
}  // namespace planish

namespace planish::job {

/// One request to unfold one body of a STEP file, as data.
struct UnfoldRequest : PatternChecks {
  std::filesystem::path input;  ///< "-" reads standard input
  std::string body;             ///< number (1-based) or name; empty: the only body
  AllowanceRule allowance = ConstantK{};
  std::vector<std::pair<std::string, double>> bend_k;  ///< K of single bends, by their ids ("B1"),
                                                       ///< before `allowance`
  std::string root = "largest";                        ///< "largest" or a face number
  std::string up = "auto";  ///< "auto", "reference", "other", or the number of a face that shall
                            ///< face up
  LengthUnit units = LengthUnit::mm;  ///< of the report
};

/// What came of one body.
struct UnfoldReport : Report {
  int number = 1;          ///< of the body in its file, as `planish info` counts
  int bodies_in_file = 1;  ///< different ones
  int quantity = 1;
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

/// The part of it that begins with what `recognize` found in the body, or why it found no sheet.
Result<UnfoldReport> unfold_recognized(const Body& body, const Result<Recognized>& found,
                                       const UnfoldRequest& request, const Progress& progress = {});

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
