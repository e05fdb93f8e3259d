#pragma once

#include "ruling_names.hpp"
#include "tip_cuts.hpp"

#include <vector>

namespace planish::transition_detail {

/// The sheet of one piece: flanges are the planes, bends the curved patches and the sharp folds, in
/// the order of `parts`. Names the ends of all rulings that a template shows, as true lengths of
/// that piece. Error: `invalid_sheet`.
Result<Sheet> named_sheet(const Ring& ring, const TransitionSpec& spec,
                          const std::vector<PatchPart>& parts, int piece, RulingNames& names);

/// The same without names, its tips cut off.
Result<Sheet> cut_sheet(const Ring& ring, const TransitionSpec& spec,
                        const std::vector<PatchPart>& parts, const TipCuts& cuts);

}  // namespace planish::transition_detail
