#pragma once

#include "support/sheets.hpp"

#include <planish/brake/tools.hpp>

#include <vector>

// A second answer to whether a stroke can be made, for strips whose bends are all parallel: by
// geometry in the plane of its own, with turns and borders looked at in small steps.

namespace planish::test {

struct ProfileBend {
  Angle angle;
  double radius = 0.0;
  bool up = true;
  double after = 0.0;  ///< length of the flange behind it
};

/// flange | bend | flange | …, seen along its bend lines.
struct Profile {
  double first = 0.0;
  std::vector<ProfileBend> bends;
  double thickness = 1.0, k = 0.44;
  std::vector<StripPart> strip() const;
};

struct PlaneStroke {
  std::vector<bool> formed;  ///< by bend
  int pressed = 0;
  bool gauge_behind = true;  ///< whether the flanges behind the bend lie towards the gauge
  double springback = 0.0;   ///< radians
};

enum class PlaneVerdict { clear, blocked, close };

/// `close`: nearer to a limit than the steps tell.
PlaneVerdict plane_verdict(const Profile& profile, const PlaneStroke& stroke, const Punch& punch,
                           const Die& die, const ToolProfile& upper_beam);

}  // namespace planish::test
