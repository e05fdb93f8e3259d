#pragma once

#include <planish/geometry/frame.hpp>

#include <limits>
#include <variant>
#include <vector>

namespace planish {

/// A straight line from `a` to `b`.
struct Segment {
  Vec2 a;
  Vec2 b;
};

/// A circular arc from angle `start`, turned by `sweep` (radians, counter-clockwise positive,
/// `0 < |sweep| <= 2π`). A full circle has `|sweep| = 2π` exactly.
struct Arc {
  Vec2 center;
  double radius = 0.0;
  double start = 0.0;
  double sweep = 0.0;
};

/// A chain of cubic Bézier spans: poles 3i … 3i+3 form span i; 3n+1 poles in all. Fitted chains
/// are tangent-continuous.
struct CubicSpline {
  std::vector<Vec2> poles;
};

using Curve2 = std::variant<Segment, Arc, CubicSpline>;

/// The farthest out that points of a curve may lie, mm: beyond, doubles no longer place them to the
/// micrometre that a chord is held to. Arcs that are nearly straight may have their centre
/// `kLargestRadius` away.
inline constexpr double kFarthest = 1e7, kLargestRadius = 1e15;

/// Whether a curve is one: numbers finite and in reach, an arc with a radius above 0 and
/// `|sweep| <= 2π`, a spline of 3n+1 poles. Every other function here takes that for granted.
bool is_regular(const Curve2& curve);

/// Consecutive curves: each starts where the one before ends, and the last ends where the first
/// starts. Outer loops run counter-clockwise, openings clockwise.
using Loop = std::vector<Curve2>;

/// Whether each curve is.
bool is_regular(const Loop& loop);

/// Point at `t` in [0, 1]; for a spline each span takes an equal share of t.
Vec2 point_at(const Curve2& curve, double t);
/// Derivative with respect to `t`.
Vec2 derivative_at(const Curve2& curve, double t);
Vec2 start_of(const Curve2& curve);
Vec2 end_of(const Curve2& curve);
Curve2 reversed(const Curve2& curve);
/// The loop run the other way.
Loop reversed(const Loop& loop);
/// Exact for segments, arcs and splines; reflections reverse an arc's sweep.
Curve2 transformed(const Curve2& curve, const Isometry2& motion);
Loop transformed(const Loop& loop, const Isometry2& motion);
/// Scaled by a factor above 0 about a point. Exact for segments, arcs and splines.
Curve2 scaled(const Curve2& curve, double factor, const Vec2& about = Vec2::Zero());
Loop scaled(const Loop& loop, double factor, const Vec2& about = Vec2::Zero());

/// Length: exact for segments and arcs, relative error below 1e-12 for splines (adaptive Gauss).
double length(const Curve2& curve);
double length(const Loop& loop);
/// The curve's share of the Green integral ½∮(x dy − y dx); exact for all three kinds.
double green_area(const Curve2& curve);
/// Signed enclosed area, positive for counter-clockwise loops.
double signed_area(const Loop& loop);

struct Box2 {
  Vec2 lo = Vec2::Constant(std::numeric_limits<double>::infinity());
  Vec2 hi = Vec2::Constant(-std::numeric_limits<double>::infinity());
  void add(const Vec2& p) {
    lo = lo.cwiseMin(p);
    hi = hi.cwiseMax(p);
  }
  void add(const Box2& b) {
    lo = lo.cwiseMin(b.lo);
    hi = hi.cwiseMax(b.hi);
  }
  bool empty() const { return lo.x() > hi.x(); }
  Vec2 size() const { return hi - lo; }
  bool overlaps(const Box2& b) const {
    return lo.x() < b.hi.x() && b.lo.x() < hi.x() && lo.y() < b.hi.y() && b.lo.y() < hi.y();
  }
};
/// Exact bounding box; of a spline that of the curve, not of its poles (extrema solved).
Box2 bounds(const Curve2& curve);
Box2 bounds(const Loop& loop);

/// Points along the curve, first and last included, chords within `chord` of it (mm).
std::vector<Vec2> sampled(const Curve2& curve, double chord);
/// Closed polygon of a loop, last point not repeated.
std::vector<Vec2> sampled(const Loop& loop, double chord);

/// Distance from p to the curve, and the parameter of the nearest point.
struct Nearest {
  double distance = 0.0;
  double t = 0.0;
};
Nearest nearest(const Curve2& curve, const Vec2& p);

/// Parameters in [0, 1], ascending, where the curve meets the infinite line through `origin` with
/// direction `direction`; empty for a curve that lies on the line. Touching points may be missing
/// or doubled.
std::vector<double> crossings(const Curve2& curve, const Vec2& origin, const Vec2& direction);

/// The part of the curve between parameters t0 < t1.
Curve2 trimmed(const Curve2& curve, double t0, double t1);

}  // namespace planish
