#pragma once

#include <planish/geometry/curve.hpp>

#include <functional>

namespace planish {

/// A parametric curve with its derivative, as fitting sees it.
struct CurveSample {
  Vec2 point;
  Vec2 derivative;
};
using CurveFunction = std::function<CurveSample(double)>;

struct FitReport {
  CubicSpline spline;
  double deviation = 0.0;  ///< largest at the check points, or a bound of it, in the curve's units;
                           ///< above `tolerance` if the spans did not suffice
};

/// Approximates f on [t0, t1] by tangent-continuous cubics: Hermite spans, halved until the
/// deviation at several points between the knots is below `tolerance`. Ends are met exactly.
/// Halving stops at 2^12 spans; `deviation` then shows the error. Where the derivative vanishes,
/// the tangent is the direction in which the curve continues; at a cusp, spans become as small as
/// the tolerance requires.
FitReport fit_cubics(const CurveFunction& f, double t0, double t1, double tolerance);

/// The same for a curve in the parameters (u, v) of a surface on which a unit step in u is about
/// `u_scale` long and a unit step in v has length 1: within `tolerance` on the surface.
CubicSpline fit_cubics_on_surface(const CurveFunction& f, double t0, double t1, double u_scale,
                                  double tolerance);

/// The simplest curve within `tolerance` of the spline: a segment, else an arc (a full circle if it
/// closes), else the spline itself. The bound is checked without sampling. Both ends are kept:
/// exactly by a segment, to a few ε·(radius + |centre|) by an arc.
Curve2 recognized(const CubicSpline& spline, double tolerance);

/// Splines become arcs and segments (biarcs) within `tolerance`; segments and arcs pass unchanged.
/// Ends and, at inner joints, tangents are kept. Consecutive results meet exactly, arcs to a few
/// ε·radius. An arc turning by less than 1e-5 is replaced by its chord; corners (more than 1e-3)
/// stay corners; next to a cusp, chords shorter than the tolerance may replace the curve.
std::vector<Curve2> to_arcs(const Curve2& curve, double tolerance);

/// A loop with neighbouring curves joined if they are one line or one circle within `tolerance`;
/// `first_input[i]` is the input index where output i begins (output i covers inputs first_input[i]
/// … first_input[i+1]−1, cyclically). A circle given as several curves becomes one full-circle Arc.
/// Curves shorter than `tolerance` are absorbed by their neighbours. Recognising, absorbing and
/// joining move the path by at most `tolerance` each. Results meet: to the bit unless both are
/// arcs, else to 1e-12 of the size (or a few ε·radius, if that is more). A loop that would lose all
/// its area stays unchanged. O(n log n).
struct MergedLoop {
  Loop loop;
  std::vector<int> first_input;
};
MergedLoop merged(const Loop& loop, double tolerance);

}  // namespace planish
