#pragma once

#include <planish/sheet/flat_pattern.hpp>

#include <vector>

namespace planish::studio {

/// Triangles, three points each, of what two faces of the pattern cover both.
std::vector<Vec2> overlap_triangles(const FlatPattern& pattern);

/// Triangles of the inside of a ring that does not cross itself, by cutting off ears. O(n³), n² for
/// most.
std::vector<Vec2> ring_triangles(std::vector<Vec2> ring);

}  // namespace planish::studio
