#pragma once

#include <planish/base/progress.hpp>

#include <cstdint>
#include <functional>
#include <vector>

namespace planish {

/// The lines that are formed in a stage, or pressed in a stroke: bit i is line i. As many words as
/// the lines need.
using LineSet = std::vector<std::uint64_t>;

/// A way in which a stroke can be made in a stage. Numbers are the caller's: equal means the same.
struct StrokeChoice {
  LineSet lines;  ///< pressed together, none formed before
  int punch = 0;
  int die = 0;
  bool reference_up = true;  ///< the side of the lying sheet that faces up
  int direction = 0;         ///< of the pattern, towards the gauge
  bool gauged = true;
};

struct StrokeWeights {
  double turn_over = 3.0, rotate = 2.0, tool_change = 5.0, stroke = 1.0, ungauged = 4.0;
};

}  // namespace planish
