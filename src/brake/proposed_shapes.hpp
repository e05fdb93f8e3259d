#pragma once

#include "proposing.hpp"

namespace planish::brake_detail {

/// Changes of the part by which it can be bent, told to 0.1 mm: flanges that end too near to a bend
/// longer, the web of a narrow Z wider, a flange that hits shorter, two parts instead of one.
void try_longer(Trying& trying);
void try_wider(Trying& trying);
void try_shorter(Trying& trying);
void try_split(Trying& trying);

}  // namespace planish::brake_detail
