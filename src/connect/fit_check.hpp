#pragma once

#include "parts.hpp"

#include <planish/base/result.hpp>

namespace planish::connect_detail {

/// Whether both plates of a bend keep all of their material beside it and the other bends that they
/// have so far, and meet it along some width, and whether a bend round their back leaves them room.
/// Errors: `no_common_width`, `overlap`, `plates_touch`.
Result<void> check_on_plates(const Parts& parts, int bend);

/// Whether the sheets of the two plates of a bend, extended, have room beside each other. Error:
/// `plates_touch`.
Result<void> check_room(const Parts& parts, int bend);

/// Whether a bend and its two plates, alone, lie flat without covering each other. Errors:
/// `overlap`, and those of `lay_out`.
Result<void> check_flat(const Parts& parts, int bend, double k_factor);

/// Refuses a bend that goes round the backs of the plates in `rows`, for the reason why none in
/// front holds, if that is known.
Result<void> check_in_front(const Parts& parts, const std::vector<int>& rows, const BendFit& fit);

}  // namespace planish::connect_detail
