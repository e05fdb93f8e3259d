#pragma once

#include <tl/expected.hpp>

#include <string>
#include <string_view>

namespace planish {

/// What went wrong, as a closed list: scripts branch on it. `code_name` gives the name used in
/// reports (formats.md#reason), `exit_status` the status a program ends with.
enum class ErrorCode {
  // The request is wrong (exit status 2).
  bad_option,    ///< an option value out of range or unknown
  no_such_body,  ///< --body names a body that the file does not hold
  no_such_face,  ///< --root or --up names a face that the body does not have
  // The input cannot be read or is invalid (exit status 3).
  cannot_read,      ///< the file is missing or may not be read
  cannot_write,     ///< an output file cannot be created
  cannot_draw,      ///< pages cannot be drawn: a library or font is missing
  empty_file,       ///< the file has no content
  not_step,         ///< the content is not ISO 10303-21
  truncated_file,   ///< the file starts as STEP but ends early
  invalid_input,    ///< the content is understood but breaks its format
  too_few_corners,  ///< a polygon of fewer than three corners
  repeated_corner,  ///< two corners of a polygon at one place
  not_planar,       ///< corners of a plate that do not lie in one plane
  self_crossing,    ///< a polygon that crosses itself
  unknown_plate,    ///< an id that no plate has
  unknown_edge,     ///< edges that a plate does not have, or that cannot carry one bend together
  unknown_seam,     ///< an edge or corner for the seam that the profile does not have
  bend_loop,        ///< bends given that close a loop of plates
  not_connected,    ///< bends given that leave a plate unconnected
  unknown_strip,    ///< a strip that the slit sheet does not have
  unknown_ridge,    ///< a ridge that a strip does not have
  empty_scan,       ///< a scan without points
  scan_too_large,   ///< a scan of more points than are searched
  bad_tools,        ///< tools of a press brake that cannot be as they are given
  no_input,         ///< a batch without anything to work on
  worker_died,      ///< the process that worked on a part of a batch ended, and why
  no_solid,         ///< the file holds no solid body (wires, points, nothing)
  shell_not_solid,  ///< the file holds surfaces or open shells only
  too_far_away,     ///< coordinates beyond what can be computed with
  kernel_failed,    ///< the CAD kernel gave up with an exception
  crashed,          ///< work in a process of its own ended with a crash
  // Understood, but no flat pattern exists (exit status 4).
  not_a_sheet,             ///< no two skins at a constant distance: a solid block, casting,
                           ///< machined part
  thickness_not_constant,  ///< skins exist but their distance varies
  doubly_curved,           ///< a bend or flange is curved in two directions (drawn, not bent)
  closed_loop,             ///< a loop of flanges and bends with nothing to open it
  overlap,                 ///< the flat pattern covers itself
  plates_intersect,        ///< two plates pass through each other
  plates_touch,            ///< two plates meet where a bend between them would have to be
  plates_coplanar,         ///< two plates to be joined by a bend lie in one plane
  plates_offset,           ///< two plates in parallel planes that no half-turn joins
  no_bend_fits,            ///< no tangent line leaves both plates whole, with what is given
  radius_too_small,        ///< the thickness is too large for the radius of a bend
  apex_in_span,            ///< the apex of a cone lies within the span of its edges
  no_common_width,         ///< a bend would run over the interior of a plate on all of its width
  too_far_apart,           ///< plates that only a bend longer than the largest span would join
  profile_not_convex,      ///< a profile of a transition that turns inwards somewhere
  profiles_meet,      ///< profiles of a transition that touch each other's plane, or lie in one
  profile_hidden,     ///< a part of a profile would be hidden inside the transition
  curve_too_short,    ///< a curve shorter than the slit sheet along it
  curve_too_long,     ///< a curve longer than the slit sheet along it
  out_of_reach,       ///< a place that a strip is too short to reach
  pattern_wrong,      ///< the certificate's residuals exceed what can be trusted
  no_straight_bend,   ///< nothing that a press brake could press: no bend has a straight bend line
  no_tool,            ///< a thickness, radius or hem that no tool bears
  cannot_bend,        ///< no order of strokes forms all bends with these tools
  unsupported_shape,  ///< a shape that is a sheet, but which Planish cannot unfold yet
  out_of_time,        ///< the time allowed has passed
  time_limit,         ///< a part of a batch took longer than it may
  out_of_memory,      ///< the memory allowed does not suffice
  // Others.
  invalid_sheet,  ///< a sheet that breaks a rule of `check`: a defect of its maker (exit status 1)
  cancelled,      ///< the caller asked to stop (exit status 1)
  internal,       ///< a defect of Planish or its kernel (exit status 1)
};

/// Name of a code as reports spell it, e.g. "not_a_sheet".
std::string_view code_name(ErrorCode code);

/// Exit status of a program that ends with this error (formats.md#exit-status).
int exit_status(ErrorCode code);

/// A foreseeable failure. `message` is one sentence holding numbers, units and the remedy; `where`
/// names the place: a file, a face, a bend, or the path of a field of the request as a JSON pointer
/// (`/bends/1/inside_radius`); empty when the whole input is meant.
struct Error {
  ErrorCode code = ErrorCode::internal;
  std::string message;
  std::string where;
};

template <typename T>
using Result = tl::expected<T, Error>;

/// Shorthand for `tl::unexpected(Error{...})`.
inline tl::unexpected<Error> fail(ErrorCode code, std::string message, std::string where = {}) {
  return tl::unexpected<Error>(Error{code, std::move(message), std::move(where)});
}

}  // namespace planish
