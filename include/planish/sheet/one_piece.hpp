#pragma once

#include <planish/sheet/flat_pattern.hpp>

namespace planish {

/// Whether slits leave the material within the contours in one piece: a slit between two places
/// that contours and other slits join already parts it. Ends of slits touch what is within
/// `tolerance`, mm. Slits that cross between their ends do not count. O(slits × curves).
bool is_one_piece(const FlatPattern& pattern, double tolerance);

}  // namespace planish
