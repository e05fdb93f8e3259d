#pragma once

#include <planish/base/progress.hpp>
#include <planish/base/result.hpp>
#include <planish/job/report.hpp>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace planish {
class Body;
struct Recognized;
struct StepFile;
}  // namespace planish

namespace planish::job {

/// The result for one body.
struct UnfoldReport : Report {
  int number = 1;          ///< the body's number in its file, as in `planish info`
  int bodies_in_file = 1;  ///< distinct bodies
  int surface_bodies = 0;  ///< shells in the file that belong to no solid: they are left out
};

/// Unfolds one body. The error shows a report if the body has no flat pattern; it shows none if the
/// input could not be read or the request is invalid. Errors of the latter beyond those of
/// `read_step`: `no_such_body` (also if there are several bodies and none is chosen),
/// `no_such_face`, `bad_option`.
Outcome<UnfoldReport> unfold(const Request& request, const Progress& progress = {});

/// Settings for unfolding all bodies; bodies count from 0.
struct AllBodies {
  std::map<int, Error> given_up;              ///< bodies to skip, each with its refusal
  std::function<void(int)> begins;            ///< called before each body
  std::function<bool(int)> wanted = nullptr;  ///< whether a body is to be unfolded; null: all are
};

/// Unfolds every distinct body of the file (`request.body` is ignored), in file order. If one body
/// fails, its outcome is an error that shows a report, and the others continue.
Result<std::vector<Outcome<UnfoldReport>>> unfold_all(const Request& request,
                                                      const Progress& progress = {},
                                                      const AllBodies& all = {});

/// The same for a body already read (`request.input` and `request.body` are ignored; `input`,
/// `number`, `bodies_in_file` and `read_seconds` of the report are not set).
Outcome<UnfoldReport> unfold_body(const Body& body, const Request& request,
                                  const Progress& progress = {});

/// The same, given what `recognize` found in the body, or why it found no sheet.
Outcome<UnfoldReport> unfold_recognized(const Body& body, const Result<Recognized>& found,
                                        const Request& request, const Progress& progress = {});

/// The report of a request that ended with an error, so that scripts find the reason in one place.
UnfoldReport failed_unfold(const Request& request, const Error& error);

/// Says where in its file the body is, from 0, and what else is there: a note, where there is one
/// body.
void place_in_file(UnfoldReport& report, const StepFile& file, int body);

class Made;
/// The report as a source of artifacts; without the mesh of its body.
std::unique_ptr<Made> made_of(const UnfoldReport& report);

/// Report as JSON text with the keys of formats.md#report.
std::string report_json(const UnfoldReport& report);
/// The same as text for a terminal.
std::string report_text(const UnfoldReport& report);
/// Summary of several bodies as JSON, as CSV (one row per body), and as text for a terminal. Each
/// outcome must show a report, as those of `unfold_all` do.
std::string summary_json(const std::vector<Outcome<UnfoldReport>>& bodies);
std::string summary_csv(const std::vector<Outcome<UnfoldReport>>& bodies);
std::string summary_text(const std::vector<Outcome<UnfoldReport>>& bodies);

}  // namespace planish::job
