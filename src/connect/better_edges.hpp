#pragma once

#include "pair_search.hpp"

namespace planish::connect_detail {

/// Chains of one kind.
std::vector<Chain> of_kind(std::vector<Chain> chains, EdgeKind kind);

/// Searches the best edges of a choice's chains. Errors: those of `search_edges`.
Result<void> search(PairChoice& choice, const EdgeSearchOptions& wanted);

/// The search weighs width against length, whatever the edges. Where it has chosen so, in place of
/// edges round the back, beside each other, or in a recess, those are taken that a shop would: in
/// front, opposite each other, the teeth that are drawn up to the bend.
PairChoice with_better_edges(PairChoice choice, const EdgeSearchOptions& wanted);

/// The choice with the edges that are drawn up to the bend, if it has such, and with no more than
/// the bend needs of edges that have to be extended to it.
PairChoice with_used_parts(PairChoice choice, const FitTask& task, const EdgeSearchOptions& wanted);

}  // namespace planish::connect_detail
