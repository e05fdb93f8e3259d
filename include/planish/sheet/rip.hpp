#pragma once

#include <planish/base/result.hpp>
#include <planish/sheet/flat_pattern.hpp>
#include <planish/sheet/sheet.hpp>

#include <functional>
#include <span>
#include <vector>

namespace planish {

/// The sheet cut open along edges of its solid, by their numbers from 1: its faces stay where they
/// are and no longer meet there. A closed box or tube becomes one that lies flat. Walls that were
/// folded sharply then meet at their inside edge; the corner between them is gone, from the volume
/// too. The solid's openings (`genus`) are counted anew. Cost: linear in the sheet's borders.
/// Errors: `bad_option` for an edge at which no two faces of the sheet meet, or at which walls meet
/// by their outside, which would leave both of them in the corner, and for rips that cut the sheet
/// into several parts.
Result<Sheet> ripped(Sheet sheet, std::span<const int> edges);

/// Whether a sheet is one that can be made, and lies flat; otherwise why not.
using SheetCheck = std::function<Result<void>(const Sheet&)>;

/// Edges of a sheet that does not lie flat along which rips open it, so that it passes the check:
/// in the order in which a refusal names them. After the first of them the answer is the others, or
/// fewer. The sheet stays in one part, over smooth joints before sharp ones and over long ones
/// before short ones (math.md#rips). Cost: that of a few layouts and checks. Errors: `closed_loop`
/// if no rips are found; if some are, but what they open does not pass, why not.
Result<std::vector<int>> rips_to_open(const Sheet& sheet, const FlattenOptions& options,
                                      const SheetCheck& passes);

/// What to say of a sheet that was refused as `closed_loop`: where the first rip goes, if rips open
/// it; what refuses it after the rips; or that there are none. Only the first names an edge
/// (`where`: "edge 21 between face 7 and face 8"): its places are that edge and those of the other
/// rips, its remedy is the option `rip_edges` with all of them.
Error loop_refusal(const Sheet& sheet, const Error& closed, const FlattenOptions& options,
                   const SheetCheck& passes);

}  // namespace planish
