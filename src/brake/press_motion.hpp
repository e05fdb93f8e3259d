#pragma once

#include "convex.hpp"

namespace planish::brake_detail {

/// A circle that the outside of both sides touches from above: the rounded shoulder of a die, at
/// `across` from the middle of the V.
struct Shoulder {
  double across = 0.0;
  double height = 0.0;  ///< of the centre above the die's top: below 0
  double radius = 0.0;
};

/// What is bent at the line of a stroke.
struct PressedBend {
  double thickness = 0.0;
  double allowance = 0.0;  ///< BA, mm
  double neutral = 0.0;    ///< depth of the neutral surface below the inside skin, K·T, mm
};

/// How the sheet moves in a stroke (math.md#stroke). Each side has a frame of its own: the first
/// coordinate is the distance from the bend line in the lying sheet, the second the height above
/// the inside skin. It is turned to the machine frame whose origin is the lowest point of the
/// inside skin, so that the punch stands still and the die moves; what is on the left of the bend
/// line is seen in a mirror.
class PressMotion {
 public:
  PressMotion(const PressedBend& bend, const Shoulder& shoulder)
      : bend_(bend), shoulder_(shoulder) {}

  const PressedBend& bend() const { return bend_; }

  /// Inside radius at turn θ > 0: BA/θ − K·T, not below 0.
  double inside_radius(double turn) const;
  /// A side's points in the machine frame.
  Convex side(const Convex& points, double turn) const;
  /// The part of the bend between `from` and `to` from the bend line, 0 ≤ from < to ≤ BA/2: its
  /// corners on both skins.
  Convex arc(double from, double to, double turn) const;
  /// The height of the die's top.
  double die_height(double turn) const;
  /// Where the plane side touches the shoulder, from the bend line along the sheet; below BA/2 the
  /// shoulder touches the bend instead.
  double contact(double turn) const;

  // Bounds of |d/dθ|, mm per radian, for all turns up to `turn` < π.
  double side_speed(const Convex& points, double turn) const;
  double arc_speed(double turn) const;
  double die_speed(double turn) const;
  double contact_speed(double turn) const;

 private:
  Vec2 side_start(double turn) const;
  double drop(double turn) const;

  PressedBend bend_;
  Shoulder shoulder_;
};

}  // namespace planish::brake_detail
