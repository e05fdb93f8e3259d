#pragma once

#include <planish/base/progress.hpp>
#include <planish/base/result.hpp>
#include <planish/job/report.hpp>

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace planish {
class Body;
struct Recognized;
}  // namespace planish

namespace planish::job {

/// What came of one body.
struct UnfoldReport : Report {
  int number = 1;          ///< of the body in its file, as `planish info` counts
  int bodies_in_file = 1;  ///< different ones
  int quantity = 1;
};

/// Unfolds one body. An error means that the input could not be read or the request is wrong; a
/// body without flat pattern gives a report with `refusal`. Errors beyond those of `read_step`:
/// `no_such_body` (also for several bodies of which none is chosen), `no_such_face`, `bad_option`.
Result<UnfoldReport> unfold(const Request& request, const Progress& progress = {});

/// What whoever unfolds all bodies knows and wants to know; bodies count from 0.
struct AllBodies {
  std::map<int, Error> given_up;    ///< not tried: the reason is the refusal
  std::function<void(int)> begins;  ///< hears of each body before it is tried
};

/// Unfolds every distinct body of the file (`request.body` is ignored), in file order. Whatever
/// goes wrong with one body is the refusal in its report; the others go on.
Result<std::vector<UnfoldReport>> unfold_all(const Request& request, const Progress& progress = {},
                                             const AllBodies& all = {});

/// The part of both that begins with a body already read (`request.input` and `request.body` are
/// not looked at; `input`, `number`, `bodies_in_file` and `read_seconds` of the report not set).
Result<UnfoldReport> unfold_body(const Body& body, const Request& request,
                                 const Progress& progress = {});

/// The part of it that begins with what `recognize` found in the body, or why it found no sheet.
Result<UnfoldReport> unfold_recognized(const Body& body, const Result<Recognized>& found,
                                       const Request& request, const Progress& progress = {});

/// The report of a request that ended with an error, so that scripts find its reason in one place.
UnfoldReport failed_unfold(const Request& request, const Error& error);

class Made;
/// The report as artifacts are written from it; the mesh of its body is not known.
std::unique_ptr<Made> made_of(const UnfoldReport& report);

/// Report as JSON text with the keys of formats.md#report.
std::string report_json(const UnfoldReport& report);
/// Summary of several bodies as JSON and as CSV (one row a body).
std::string summary_json(const std::vector<UnfoldReport>& reports);
std::string summary_csv(const std::vector<UnfoldReport>& reports);
/// The report as a person reads it on a terminal, and the summary of several bodies.
std::string report_text(const UnfoldReport& report);
std::string summary_text(const std::vector<UnfoldReport>& reports);

}  // namespace planish::job
