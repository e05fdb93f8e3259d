#pragma once

#include <planish/geometry/curve.hpp>

#include <vector>

namespace planish {

/// A plane Bézier curve of any degree, by its poles (mm); parameter t from 0 to 1.
struct BezierCurve {
  std::vector<Vec2> poles;
  friend bool operator==(const BezierCurve&, const BezierCurve&) = default;
};

/// Whether a curve has poles, all of them finite and within `kFarthest`. The functions here take
/// that for granted.
bool is_regular(const BezierCurve& curve);

/// A point of a curve with its first two derivatives with respect to t.
struct BezierPoint {
  Vec2 point = Vec2::Zero();
  Vec2 first = Vec2::Zero();
  Vec2 second = Vec2::Zero();
};

/// By de Casteljau's construction, stable for every degree. At least one pole is required.
/// O(degree²).
BezierPoint bezier_at(const BezierCurve& curve, double t);

/// Arc length, mm, to 1e-12 of the length of the control polygon if the curve has no cusp.
double length(const BezierCurve& curve);

/// Points at arc lengths (mm) from the curve's start, to 1e-4 of its length; lengths beyond the
/// ends give the ends.
std::vector<Vec2> points_at_lengths(const BezierCurve& curve, const std::vector<double>& lengths);

/// Smallest radius of curvature between two parameters and where it is. Infinite for straight
/// lines, 0 at a cusp. Found on 64 samples per degree, then refined between neighbouring samples.
struct TightestBend {
  double radius = 0.0;  ///< mm
  double t = 0.0;
};
TightestBend tightest_bend(const BezierCurve& curve, double from = 0.0, double to = 1.0);

/// Finds nearest points on one curve: among samples first, then by Newton's method on
/// (p − c)·c′ = 0.
class BezierSearch {
 public:
  explicit BezierSearch(BezierCurve curve);

  /// Nearest point and its derivative with respect to p: t tᵀ / (1 − κ d) inside the curve, 0 where
  /// an end is nearest.
  struct Foot {
    double t = 0.0;
    Vec2 point = Vec2::Zero();
    Eigen::Matrix2d derivative = Eigen::Matrix2d::Zero();
  };
  Foot nearest(const Vec2& p) const;

  const BezierCurve& curve() const { return curve_; }

 private:
  BezierCurve curve_;
  std::vector<Vec2> samples_;
};

}  // namespace planish
