#pragma once

#include <planish/sheet/layout.hpp>

#include <vector>

namespace planish::studio {

/// Triangles, three points each, of the areas that two faces share in the flat pattern of a sheet
/// of that thickness.
std::vector<Vec2> overlap_triangles(const Layout& layout, double thickness);

/// Triangles of a ring that does not cross itself, by ear clipping. O(n³), mostly n².
std::vector<Vec2> ring_triangles(std::vector<Vec2> ring);

}  // namespace planish::studio
