#pragma once

#include <compare>
#include <numbers>

namespace planish {

/// A plane angle. Files speak degrees, the program radians; this type keeps them apart.
class Angle {
 public:
  constexpr Angle() = default;
  static constexpr Angle radians(double value) { return Angle(value); }
  static constexpr Angle degrees(double value) { return Angle(value * std::numbers::pi / 180.0); }

  constexpr double radians() const { return radians_; }
  constexpr double degrees() const { return radians_ * 180.0 / std::numbers::pi; }

  friend constexpr auto operator<=>(Angle, Angle) = default;
  friend constexpr Angle operator+(Angle a, Angle b) { return Angle(a.radians_ + b.radians_); }
  friend constexpr Angle operator-(Angle a, Angle b) { return Angle(a.radians_ - b.radians_); }
  friend constexpr Angle operator-(Angle a) { return Angle(-a.radians_); }
  friend constexpr Angle operator*(double s, Angle a) { return Angle(s * a.radians_); }

 private:
  constexpr explicit Angle(double value) : radians_(value) {}
  double radians_ = 0.0;
};

}  // namespace planish
