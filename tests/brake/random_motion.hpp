#pragma once

#include "brake/stroke_room.hpp"
#include "press_motion.hpp"
#include "tool_shape.hpp"

#include <random>

namespace planish::test {

/// Any sheet, bend and die that a press brake might see.
inline brake_detail::PressMotion random_motion(std::mt19937& random) {
  std::uniform_real_distribution<double> share(0.0, 1.0);
  const double t = 0.5 + 3.0 * share(random), r = 4.0 * share(random);
  const double angle = 0.3 + 1.8 * share(random);
  Die lower = die({6.0 * t + 4.0 * share(random), Angle::degrees(60), 0.5 + share(random)});
  return {{t, angle * (r + 0.44 * t), 0.44 * t}, brake_detail::shoulder_of(lower)};
}

}  // namespace planish::test
