#pragma once

#include "pair_search.hpp"

namespace planish::connect_detail {

/// Edges that are drawn up to the bend, by side, where the edges chosen say so: both plates have
/// them on one tangent line. If a recess lies between such edges of a plate (a bend in several
/// stretches), the bend uses one of them and leaves the recess open. If the edges chosen are all on
/// the line but end beside each other, and some of them end opposite each other, it uses these.
/// Empty: the edges chosen are right.
std::optional<std::array<std::vector<int>, 2>> drawn_edges(const PairChoice& choice);

}  // namespace planish::connect_detail
