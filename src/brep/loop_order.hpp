#pragma once

#include "solid_model.hpp"

namespace planish::brep {

/// Whether each use of an edge starts at the vertex where the one before ends, all round.
bool in_order(const std::vector<SolidEdge>& edges, const std::vector<CoEdge>& loop);

/// The uses in the order in which each next one starts nearest to where the one before ends; the
/// first stays first.
std::vector<CoEdge> chained(const std::vector<SolidEdge>& edges, std::vector<CoEdge> uses);

}  // namespace planish::brep
