#pragma once

#include "assembly.hpp"

#include <functional>
#include <vector>

namespace planish::brep {

/// Where a form that leads from one skin to the other lets through: the closed chains of edges that
/// part its faces into those that belong to the reference skin's side and the rest, so that what
/// they enclose, seen along the normal of `plane`, is least (math.md#pilot-holes). Each runs with
/// the reference side on its left. A smallest cut in the graph of its faces: what looks towards the
/// reference side costs its projected area on the other side, and the other way round; every edge
/// costs a little of its length. Empty where no cut gives as many chains as `RimPart::openings`.
std::vector<std::vector<CoEdge>> passages(const Recognition& of, const RimPart& part,
                                          const Frame& plane);

/// The same where an edge counts another length, mm: of all the ends of an upright wall, which are
/// seen alike, the chain runs along the shortest.
using EdgeLength = std::function<double(int edge)>;
std::vector<std::vector<CoEdge>> passages(const Recognition& of, const RimPart& part,
                                          const Frame& plane, const EdgeLength& length_of);

}  // namespace planish::brep
