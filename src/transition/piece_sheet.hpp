#pragma once

#include "ruling_names.hpp"
#include "tip_cuts.hpp"

#include <vector>

namespace planish::transition_detail {

/// The sheet of one piece, its flanges the planes, its bends what is curved and the sharp folds, in
/// the order of `parts`. The ends of all its rulings that a template shows are named, as true
/// lengths of that piece. Error: `invalid_sheet`.
Result<Sheet> named_sheet(const Ring& ring, const TransitionSpec& spec,
                          const std::vector<PatchPart>& parts, int piece, RulingNames& names);

/// The same without names, its tips cut off.
Result<Sheet> cut_sheet(const Ring& ring, const TransitionSpec& spec,
                        const std::vector<PatchPart>& parts, const TipCuts& cuts);

}  // namespace planish::transition_detail
