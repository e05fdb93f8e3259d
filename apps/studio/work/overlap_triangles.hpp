#pragma once

#include <planish/sheet/layout.hpp>

#include <vector>

namespace planish::studio {

/// Triangles, three points each, of what two faces cover both in the flat pattern of a sheet of
/// that thickness.
std::vector<Vec2> overlap_triangles(const Layout& layout, double thickness);

/// Triangles of the inside of a ring that does not cross itself, by cutting off ears. O(n³), n² for
/// most.
std::vector<Vec2> ring_triangles(std::vector<Vec2> ring);

}  // namespace planish::studio
