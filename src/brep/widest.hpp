#pragma once

#include "rim.hpp"

namespace planish::brep {

/// Where the wall of a cut widens below a skin's border (chamfers, fillets,
/// countersinks), the blank must reach as far as the material does: the use of the edge at which
/// the wall stops to widen, run the same way as the border. The border's own use where the wall
/// goes straight down or inwards.
CoEdge widest_edge(const SolidModel& model, const Rim& rim, double thickness, int skin_face,
                   const CoEdge& border);

}  // namespace planish::brep
