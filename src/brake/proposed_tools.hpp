#pragma once

#include "proposing.hpp"

namespace planish::brake_detail {

/// Other tools, or the same used otherwise, with which a sheet can be bent: of each kind the least
/// change that does.
void try_openings(Trying& trying);
void try_segments(Trying& trying);
void try_punches(Trying& trying);
void try_dies(Trying& trying);
void try_lower_ears(Trying& trying);
void try_short_punch(Trying& trying);
void try_taller(Trying& trying);

}  // namespace planish::brake_detail
