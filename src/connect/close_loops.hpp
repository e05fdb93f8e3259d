#pragma once

#include "parts.hpp"

#include <planish/connect/connect.hpp>

#include <vector>

namespace planish::connect_detail {

/// Joins plates that share an edge and are not joined to each other also there, if the loop that
/// this closes lies flat.
void close_loops(const PlateStructure& structure, const std::vector<SharedEdge>& shared,
                 const ConnectOptions& options, Parts& parts);

/// The shared edges of plates that no bend joins to each other.
std::vector<SharedEdge> left_open(const std::vector<SharedEdge>& shared, const Parts& parts);

}  // namespace planish::connect_detail
