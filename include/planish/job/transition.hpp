#pragma once

#include <planish/base/progress.hpp>
#include <planish/brep/step.hpp>
#include <planish/job/report.hpp>
#include <planish/job/transition_json.hpp>
#include <planish/transition/transition.hpp>

#include <string>
#include <vector>

namespace planish::job {

/// One piece of a transition, laid flat.
struct TransitionPiece : Report {
  /// The folded solid, or why there is none: the kernel could not make it (a warning in the
  /// report), or the request was refused earlier.
  Result<Body> solid = fail(code::internal, "no folded solid has been made");
};

/// The result of a transition request. As a report it is that of the only piece, or covers all
/// pieces and includes their findings.
struct TransitionReport : Report {
  TransitionSpec spec;
  Transition transition;
  std::vector<TransitionPiece> pieces;
};

/// Makes the transition, lays each piece flat and certifies it. `where` of an error is the file's
/// name, followed by the JSON pointer of the cause. The error shows a report if the profiles have
/// no transition; it shows none if the file cannot be read or is invalid: `cannot_read`, those of
/// `parse_transition`, those of `make_transition` with exit status 3, `bad_option`
/// (`request.allowance` is a rule that needs inside radii).
Outcome<TransitionReport> transition(const Request& request, const Progress& progress = {});

/// The same for a file already read (`request.input` only names it).
Outcome<TransitionReport> transition_between(const TransitionFile& file, const Request& request,
                                             const Progress& progress = {});

/// Report as JSON text with the keys of formats.md#report, and as text for a terminal.
std::string report_json(const TransitionReport& report);
std::string report_text(const TransitionReport& report);

}  // namespace planish::job
