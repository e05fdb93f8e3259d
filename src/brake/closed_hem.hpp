#pragma once

#include "stage_pose.hpp"

namespace planish::brake_detail {

/// A hem once it is closed: its larger side lies, the return is above it. In the frame of the line,
/// all parts on its left.
struct ClosedHem {
  std::vector<PlacedPart> parts;
  double middle = 0.0;     ///< of the return, across the line, mm
  double top = 0.0;        ///< of the return above the inside skin of what lies, mm
  double gap = 0.0;        ///< least between both sides, mm
  bool left_folds = true;  ///< the return is on the left of the line
};

/// `line` is the one that closes the hem, `open` the parts of the tree while both sides lie.
ClosedHem closed_hem(const Workpiece& work, const PartTree& tree, const BrakeLine& line,
                     const std::vector<const PlacedPart*>& open);

}  // namespace planish::brake_detail
