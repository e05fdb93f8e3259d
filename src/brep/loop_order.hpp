#pragma once

#include "solid_model.hpp"

namespace planish::brep {

/// Whether each edge use starts at the vertex where the previous one ends, all around.
bool in_order(const std::vector<SolidEdge>& edges, const std::vector<CoEdge>& loop);

/// The uses reordered so that each starts nearest to the end of the previous one; the first stays
/// first.
std::vector<CoEdge> chained(const std::vector<SolidEdge>& edges, std::vector<CoEdge> uses);

}  // namespace planish::brep
