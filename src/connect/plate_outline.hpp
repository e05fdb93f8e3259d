#pragma once

#include "bend_fit.hpp"

#include <optional>
#include <vector>

namespace planish::connect_detail {

/// A bend as one of its plates sees it.
struct BendOnPlate {
  int bend = 0;  ///< row of the fits
  int side = 0;
  const BendFit* fit = nullptr;
};

/// The outline of a plate extended to its bends, in the plate's own axes, counter-clockwise.
struct ExtendedOutline {
  struct Edge {
    Vec2 a, b;
    std::optional<int> bend = {};  ///< row of the fits whose joint this is; none: a cut
  };
  std::vector<Edge> edges;
};

/// The part of a tangent ruling along which a bend joins its plate, from low to high v. Shorter
/// than the bend if the bend is wider than the edge it lies on.
struct JointRange {
  double low = 0.0, high = 0.0;
};
JointRange joint_range(const BendFit& fit, int side, const PlacedPlate& plate);

/// Adds the plate extensions of math.md#tangent-lines: the selected edges are replaced by the
/// shortest paths from their ends to the lateral boundaries that do not cut the plate, and by the
/// tangent line between. Another ring than 0 is a hole, which runs clockwise; bends on other rings
/// are passed over. Error: `overlap` if extensions run into each other or over the plate.
Result<ExtendedOutline> extended_outline(const PlacedPlate& plate, std::vector<BendOnPlate> bends,
                                         const std::string& id, int ring = 0);

}  // namespace planish::connect_detail
