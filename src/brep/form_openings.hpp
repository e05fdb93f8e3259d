#pragma once

#include "assembly.hpp"

namespace planish::brep {

/// Enters what is cut within a formed feature that shows on the plane reference face
/// `feature.face`, whose frame is `plane`: its holes, with the pilot holes from which an extruded
/// hole is drawn (math.md#pilot-holes), its free edges as slits, and how many openings of the solid
/// that leaves without a cut.
void add_form_openings(FormedFeature& feature, const Frame& plane, const Recognition& of,
                       const RimPart& part);

/// The openings that a part on one skin has by itself, such as a tunnel between two recesses. A
/// groove all round an island is none: there the island's face is cut off from its skin.
int hidden_openings(const Recognition& of, const RimPart& part);

}  // namespace planish::brep
