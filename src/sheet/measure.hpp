#pragma once

#include <planish/sheet/flat_pattern.hpp>

namespace planish::sheet_detail {

/// Area and cutting length from the contours and slits.
void measure(FlatPattern& pattern);

}  // namespace planish::sheet_detail
