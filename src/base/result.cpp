#include <planish/base/assert.hpp>
#include <planish/base/result.hpp>

#include <array>
#include <cstdio>
#include <cstdlib>

namespace planish {
namespace {

struct CodeRow {
  ErrorCode code;
  std::string_view name;
  int exit_status;
};

constexpr std::array kCodes{
    CodeRow{ErrorCode::bad_option, "bad_option", 2},
    CodeRow{ErrorCode::no_such_body, "no_such_body", 2},
    CodeRow{ErrorCode::no_such_face, "no_such_face", 2},
    CodeRow{ErrorCode::cannot_read, "cannot_read", 3},
    CodeRow{ErrorCode::cannot_write, "cannot_write", 3},
    CodeRow{ErrorCode::cannot_draw, "cannot_draw", 3},
    CodeRow{ErrorCode::empty_file, "empty_file", 3},
    CodeRow{ErrorCode::not_step, "not_step", 3},
    CodeRow{ErrorCode::truncated_file, "truncated_file", 3},
    CodeRow{ErrorCode::invalid_input, "invalid_input", 3},
    CodeRow{ErrorCode::too_few_corners, "too_few_corners", 3},
    CodeRow{ErrorCode::repeated_corner, "repeated_corner", 3},
    CodeRow{ErrorCode::not_planar, "not_planar", 3},
    CodeRow{ErrorCode::self_crossing, "self_crossing", 3},
    CodeRow{ErrorCode::unknown_plate, "unknown_plate", 3},
    CodeRow{ErrorCode::unknown_edge, "unknown_edge", 3},
    CodeRow{ErrorCode::unknown_seam, "unknown_seam", 3},
    CodeRow{ErrorCode::bend_loop, "bend_loop", 3},
    CodeRow{ErrorCode::not_connected, "not_connected", 3},
    CodeRow{ErrorCode::unknown_strip, "unknown_strip", 3},
    CodeRow{ErrorCode::unknown_ridge, "unknown_ridge", 3},
    CodeRow{ErrorCode::empty_scan, "empty_scan", 3},
    CodeRow{ErrorCode::scan_too_large, "scan_too_large", 3},
    CodeRow{ErrorCode::bad_tools, "bad_tools", 3},
    CodeRow{ErrorCode::no_input, "no_input", 3},
    CodeRow{ErrorCode::worker_died, "worker_died", 3},
    CodeRow{ErrorCode::no_solid, "no_solid", 3},
    CodeRow{ErrorCode::shell_not_solid, "shell_not_solid", 3},
    CodeRow{ErrorCode::too_far_away, "too_far_away", 3},
    CodeRow{ErrorCode::kernel_failed, "kernel_failed", 3},
    CodeRow{ErrorCode::crashed, "crashed", 3},
    CodeRow{ErrorCode::not_a_sheet, "not_a_sheet", 4},
    CodeRow{ErrorCode::thickness_not_constant, "thickness_not_constant", 4},
    CodeRow{ErrorCode::doubly_curved, "doubly_curved", 4},
    CodeRow{ErrorCode::closed_loop, "closed_loop", 4},
    CodeRow{ErrorCode::overlap, "overlap", 4},
    CodeRow{ErrorCode::plates_intersect, "plates_intersect", 4},
    CodeRow{ErrorCode::plates_touch, "plates_touch", 4},
    CodeRow{ErrorCode::plates_coplanar, "plates_coplanar", 4},
    CodeRow{ErrorCode::plates_offset, "plates_offset", 4},
    CodeRow{ErrorCode::no_bend_fits, "no_bend_fits", 4},
    CodeRow{ErrorCode::radius_too_small, "radius_too_small", 4},
    CodeRow{ErrorCode::apex_in_span, "apex_in_span", 4},
    CodeRow{ErrorCode::no_common_width, "no_common_width", 4},
    CodeRow{ErrorCode::too_far_apart, "too_far_apart", 4},
    CodeRow{ErrorCode::profile_not_convex, "profile_not_convex", 4},
    CodeRow{ErrorCode::profiles_meet, "profiles_meet", 4},
    CodeRow{ErrorCode::profile_hidden, "profile_hidden", 4},
    CodeRow{ErrorCode::curve_too_short, "curve_too_short", 4},
    CodeRow{ErrorCode::curve_too_long, "curve_too_long", 4},
    CodeRow{ErrorCode::out_of_reach, "out_of_reach", 4},
    CodeRow{ErrorCode::pattern_wrong, "pattern_wrong", 4},
    CodeRow{ErrorCode::no_straight_bend, "no_straight_bend", 4},
    CodeRow{ErrorCode::no_tool, "no_tool", 4},
    CodeRow{ErrorCode::cannot_bend, "cannot_bend", 4},
    CodeRow{ErrorCode::unsupported_shape, "unsupported_shape", 4},
    CodeRow{ErrorCode::out_of_time, "out_of_time", 4},
    CodeRow{ErrorCode::time_limit, "time_limit", 4},
    CodeRow{ErrorCode::out_of_memory, "out_of_memory", 4},
    CodeRow{ErrorCode::invalid_sheet, "invalid_sheet", 1},
    CodeRow{ErrorCode::cancelled, "cancelled", 1},
    CodeRow{ErrorCode::internal, "internal", 1},
};

const CodeRow& row_of(ErrorCode code) {
  for (const CodeRow& row : kCodes) {
    if (row.code == code) return row;
  }
  return kCodes.back();
}

}  // namespace

std::string_view code_name(ErrorCode code) { return row_of(code).name; }

int exit_status(ErrorCode code) { return row_of(code).exit_status; }

void assertion_failed(const char* condition, const char* file, int line) {
  std::fprintf(stderr, "planish: assertion failed: %s (%s:%d)\n", condition, file, line);
  std::abort();
}

void rule_broken(std::string_view where, std::string_view rule) {
  std::fprintf(stderr, "planish: rule broken at %.*s: %.*s\n", static_cast<int>(where.size()),
               where.data(), static_cast<int>(rule.size()), rule.data());
  std::abort();
}

}  // namespace planish
