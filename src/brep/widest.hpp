#pragma once

#include "rim.hpp"

namespace planish::brep {

/// The edge that the blank is cut along for a border of a skin. Where the wall widens below the
/// skin (chamfers, fillets, countersinks) it is the edge at which that ends, as the blank must
/// reach as far as the material does; its use runs the same way as the border. Where the wall goes
/// straight down or inwards it is the border itself.
CoEdge widest_edge(const SolidModel& model, const Rim& rim, double thickness, int skin_face,
                   const CoEdge& border);

}  // namespace planish::brep
