#pragma once

#include "brake/stroke_room.hpp"

namespace planish::test {

inline constexpr double kFlatPunch = 15.0;  // half its width

/// Acute tools and flat ones.
inline BrakeTools hemming_tools() {
  BrakeTools tools = plain_tools({Angle::degrees(28), 8.0, 150.0, 0.4},
                                 {8.0, Angle::degrees(30), 1.0, 12.0});
  tools.punches.push_back(
      {"F",
       {{0, 0}, {kFlatPunch, 0}, {kFlatPunch, 150}, {-kFlatPunch, 150}, {-kFlatPunch, 0}},
       0.0,
       Angle::degrees(180),
       {500, 200, 100, 50, 20, 10}});
  tools.dies.push_back({"F",
                        0.0,
                        Angle::degrees(180),
                        0.0,
                        {{-30, 0}, {-30, -100}, {30, -100}, {30, 0}},
                        {500, 200, 100, 50, 20, 10}});
  return tools;
}

}  // namespace planish::test
