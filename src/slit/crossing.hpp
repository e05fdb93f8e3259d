#pragma once

#include "strip_problem.hpp"

#include <vector>

namespace planish::slit_detail {

/// Whether an edge of one strip goes through a quad of the other; touching does not count, nor
/// what goes through it nearer than `within` to its edges, mm.
/// O(quads²), less where boxes are apart.
bool cross(const FoldedStrip& a, const FoldedStrip& b, double within = 0.0);

/// Planes that keep a strip on its side of a fixed neighbour: through the point of the neighbour's
/// near border next to each of its own near ridge ends, perpendicular to the neighbour there. Ends
/// farther from the neighbour's surface than the strip's width are left free.
std::vector<HalfSpace> planes_beside(const FoldedStrip& strip, const FoldedStrip& neighbour,
                                     StripEdge where_neighbour_is);

/// Planes that keep a strip on its side of x = 0, `sign` being that of x there.
std::vector<HalfSpace> planes_before_mirror(int quads, double sign);
/// Planes that keep a strip above a height, and how far below it some of it goes, mm.
std::vector<HalfSpace> planes_above(int quads, double height);
double depth_below(const FoldedStrip& strip, double height);
/// How far the strip reaches through x = 0, mm.
double depth_behind_mirror(const FoldedStrip& strip, double sign);

}  // namespace planish::slit_detail
