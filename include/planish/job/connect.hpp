#pragma once

#include <planish/base/progress.hpp>
#include <planish/brep/step.hpp>
#include <planish/connect/connect.hpp>
#include <planish/job/plates_json.hpp>
#include <planish/job/report.hpp>

#include <string>

namespace planish::job {

/// The result of a connect request. If refused, `connection` holds what was known by then.
struct ConnectReport : Report {
  Connection connection;
  /// The folded solid, or why there is none: the kernel could not make it (a warning in the
  /// report), or the request was refused earlier.
  Result<Body> solid = fail(code::internal, "no folded solid has been made");
};

/// Joins the plates, lays the sheet flat and certifies it: the volume against the kernel's folded
/// solid, edge lengths and refolding against the sheet's own borders. `where` of an error is the
/// file's name, followed by the JSON pointer of the cause. The error shows a report if the plates
/// cannot be joined; it shows none if the file cannot be read or is invalid: `cannot_read`, those
/// of `parse_plates`, those of `planish::connect` with exit status 3.
Outcome<ConnectReport> connect(const Request& request, const Progress& progress = {});

/// The same for a file already read (`request.input` only names it).
Outcome<ConnectReport> connect_plates(const PlatesFile& file, const Request& request,
                                      const Progress& progress = {});

/// Report as JSON text with the keys of formats.md#report, and as a person reads it on a terminal.
std::string report_json(const ConnectReport& report);
std::string report_text(const ConnectReport& report);

}  // namespace planish::job
