#pragma once

#include <planish/slit/mould.hpp>

#include <vector>

namespace planish::slit_detail {

/// A rib's facets with what is below them, down to the base: top, base, sides and ends, closed, its
/// outside counter-clockwise. Points: left and right of every ridge, then those below them.
Mesh closed_mesh(const MouldRib& rib, const Frame& base);

/// The rib's outline as the base sees it, counter-clockwise.
std::vector<Vec2> footprint_of(const MouldRib& rib, const Frame& base);

}  // namespace planish::slit_detail
