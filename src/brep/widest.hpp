#pragma once

#include "rim.hpp"

namespace planish::brep {

/// The edge along which the blank is cut for a border of a skin. If the wall widens below the skin
/// (chamfers, fillets, countersinks), it is the edge where the widening ends, as the blank must
/// reach as far as the material; its use runs the same way as the border. If the wall goes straight
/// down or inwards, it is the border itself.
CoEdge widest_edge(const SolidModel& model, const Rim& rim, double thickness, int skin_face,
                   const CoEdge& border);

/// The edge across a strip: the other loop of a ring, the opposite side of a face with four sides
/// and slivers. Empty for other faces.
std::optional<int> opposite_edge(const SolidModel& model, int wall, int edge);

/// Whether the wall along a border of a skin, a strip of any kind of surface, leans back from it:
/// that of a chamfer, a fillet, a countersink, or of a slanted cut.
bool leans_back(const SolidModel& model, int skin_face, const CoEdge& border);

}  // namespace planish::brep
