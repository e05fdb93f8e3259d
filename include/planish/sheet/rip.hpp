#pragma once

#include <planish/base/result.hpp>
#include <planish/sheet/sheet.hpp>

#include <span>

namespace planish {

/// The sheet cut open along edges of its solid, by their numbers from 1: its faces stay where they
/// are and no longer meet there. A closed box or tube becomes one that lies flat. Walls that were
/// folded sharply then meet at their inside edge; the corner between them is gone, from the volume
/// too. The solid's openings (`genus`) are counted anew. Cost: linear in the sheet's borders.
/// Errors: `bad_option` for an edge at which no two faces of the sheet meet, or at which walls meet
/// by their outside, which would leave both of them in the corner, and for rips that cut the sheet
/// into several parts.
Result<Sheet> ripped(Sheet sheet, std::span<const int> edges);

}  // namespace planish
