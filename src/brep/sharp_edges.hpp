#pragma once

#include "face_pairs.hpp"

namespace planish::brep {

/// An edge where two faces of a skin meet at an angle: a bend without radius on this skin.
struct SharpEdge {
  int edge = 0;
  bool concave = false;  ///< the inside of the bend; the other skin is mitred or rounded there
  bool rounded = false;  ///< rounded, not mitred
};

/// The rounded outside of a bend with zero inside radius: a cylinder of the sheet's thickness about
/// a concave edge. It counts as skin although no face lies opposite.
struct RoundedOutside {
  int edge = 0;
  int face = 0;
};

/// Rounded outsides of the concave edges between skin candidates (flags by face), found among the
/// other faces.
std::vector<RoundedOutside> rounded_outsides(const SolidModel& model,
                                             const std::vector<Outline>& outlines,
                                             const std::vector<bool>& candidates, double thickness,
                                             double slack);

/// Edges between skin candidates at which a skin is folded sharply: the partners of both faces meet
/// sharply too, in the opposite sense, or are rounded about the edge. A wall of a cut meets both
/// skins convexly and so is never included.
std::vector<SharpEdge> find_sharp_edges(const SolidModel& model,
                                        const std::vector<std::vector<int>>& partners,
                                        const std::vector<bool>& candidates,
                                        const std::vector<RoundedOutside>& rounded,
                                        double thickness);

}  // namespace planish::brep
