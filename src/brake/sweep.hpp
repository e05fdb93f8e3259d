#pragma once

#include "press_motion.hpp"
#include "stage_pose.hpp"
#include "tool_shape.hpp"

#include <functional>
#include <optional>

namespace planish::brake_detail {

/// A convex part of the workpiece's section as it moves through a stroke.
struct Moving {
  std::function<Convex(double turn)> at;     ///< in the machine frame, its side seen as the left
  std::function<double(double turn)> speed;  ///< bound of mm per radian up to a turn
  /// Two that make it up, of which one is slower; none if both were as fast.
  std::function<std::vector<Moving>()> halves = {};
};

/// A part that is turned with its side.
Moving turned_with_side(const PressMotion& motion, const Convex& section);
/// A strip of the zone being pressed.
Moving bent(const PressMotion& motion, double from, double to);

/// How closely motion is followed, mm: what comes nearer than an obstacle allows by more than this
/// is found.
inline constexpr double kFollowed = 0.001;

/// A turn in [0, most] at which the part comes nearer to the obstacle than allowed. Empty: proven
/// for every turn in between, by bounds of the motion, to within `kFollowed`.
std::optional<double> hit(const PressMotion& motion, const Moving& part, const Obstacle& obstacle,
                          double most);

/// How closely distances are measured, mm: they are told to 0.1.
inline constexpr double kMeasured = 0.02;

/// The smallest distance of a part from an obstacle over all turns, if that is less than
/// `most_asked`; too large by `kMeasured` at most. 0 if they meet.
struct Closest {
  double distance = std::numeric_limits<double>::infinity();
  double turn = 0.0;
};
Closest closest(const PressMotion& motion, const Moving& part, const Obstacle& obstacle,
                double most, double most_asked);

inline constexpr Interval kEverywhere{-1e9, 1e9};  // mm

/// Where along the bend line a part comes nearer to the obstacle than allowed: intervals of x, a
/// hundredth of a millimetre too wide at most. What lies outside `within` may be missing.
std::vector<Interval> blocked_along(const PressMotion& motion, const PlacedPart& part,
                                    const Obstacle& left, const Obstacle& right, double most,
                                    const Interval& within = kEverywhere);

/// Whether parts of a stage that lie within a range of x come nearer than allowed: the turn.
std::optional<double> hit_within(const PressMotion& motion, const PlacedPart& part,
                                 const Obstacle& left, const Obstacle& right, const Interval& along,
                                 double most);

}  // namespace planish::brake_detail
