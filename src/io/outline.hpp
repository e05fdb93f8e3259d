#pragma once

#include <planish/geometry/curve.hpp>
#include <planish/io/flat_writers.hpp>

#include <variant>
#include <vector>

namespace planish::io_detail {

/// Corner of a closed polyline; `bulge` = tan(sweep / 4) of the arc that starts here; 0: straight.
struct BulgeVertex {
  Vec2 point;
  double bulge = 0.0;
};

struct Polyline {
  std::vector<BulgeVertex> vertices;
};

struct Circle {
  Vec2 center;
  double radius = 0.0;
};

/// A contour in a form that DXF can hold. A contour with splines is a `Loop` whose curves share
/// ends and whose arcs turn by at most half a turn.
using Outline = std::variant<Circle, Polyline, Loop>;

struct OutlineOptions {
  Splines splines = Splines::arcs;
  double arc_tolerance = 0.01;  ///< mm
  double scale = 1.0;           ///< units of the file in one mm
};

/// The loop (mm) as a circle, a closed polyline without doubled vertices, or a chain, scaled.
Outline outline_of(const Loop& loop, const OutlineOptions& options);

/// The arc (or segment, when the bulge is below 1e-12) from `a` to `b`.
Curve2 bulge_curve(const Vec2& a, const Vec2& b, double bulge);

Box2 bounds(const Outline& outline);

}  // namespace planish::io_detail
