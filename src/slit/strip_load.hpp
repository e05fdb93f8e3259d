#pragma once

#include "strip_fold.hpp"

#include <vector>

namespace planish::slit_detail {

/// Forces on a strip that keep their direction, for D = 1 N mm: newtons divided by the flexural
/// rigidity of the sheet.
struct StripLoad {
  struct Force {
    double at = 0.0;  ///< share of the strip's length, on the line in its middle
    Vec3 force = Vec3::Zero();
  };
  Vec3 spread = Vec3::Zero();  ///< on each mm²
  std::vector<Force> forces;

  bool empty() const { return forces.empty() && spread.isZero(0.0); }
  StripLoad times(double share) const {
    StripLoad part{share * spread, forces};
    for (Force& one : part.forces)
      one.force *= share;
    return part;
  }
};

/// A point of the middle of a strip: between the middles of two ridges, which are evenly spaced.
struct MiddlePoint {
  int ridge = 0;       ///< before it
  double share = 0.0;  ///< of the way to the next one
};
MiddlePoint middle_point(int quads, double at);

}  // namespace planish::slit_detail
