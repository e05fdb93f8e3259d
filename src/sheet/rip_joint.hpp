#pragma once

#include <planish/sheet/sheet.hpp>

namespace planish::sheet_detail {

/// Whether a rip can part the faces of a joint: it has an edge, and sharply folded walls meet there
/// by their inside.
bool can_be_ripped(const Sheet& sheet, const Joint& joint);

}  // namespace planish::sheet_detail
