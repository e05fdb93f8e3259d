#pragma once

#include <planish/sheet/flat_pattern.hpp>

namespace planish {

/// The pattern moved; after a reflection the sheet is seen from its other side, and bends up are
/// bends down.
FlatPattern transformed(FlatPattern pattern, const Isometry2& motion);

}  // namespace planish
