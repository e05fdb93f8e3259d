#pragma once

#include "convex_boundary.hpp"
#include "periodic_spline.hpp"

#include <functional>
#include <vector>

namespace planish::transition_detail {

using PlaneCurve = std::function<PlanePoint(double)>;

/// An element in the profile's own plane, run counter-clockwise.
struct PlaneElement {
  PlaneCurve curve;
  double t0 = 0.0, t1 = 1.0;
  bool straight = false;
  int source = 0;
  double period = 0.0;
  std::vector<double> knots;
  double circle_radius = 0.0;  ///< 0: not a circle
  Vec2 circle_centre = Vec2::Zero();
  std::vector<GivenEdge> edges;      ///< that it is made of
  std::vector<GivenCorner> corners;  ///< at its start and within
};

PlaneElement straight(const Vec2& a, const Vec2& b, int source);

/// A profile that is one point.
PlaneElement standing(const Vec2& point);

/// The curve offset to the right by d (mm): outwards if it runs counter-clockwise. Its third
/// derivative, which is not used, is left zero.
PlaneCurve set_off(PlaneCurve curve, double d);

/// The part of a circle or ellipse, set `outwards`, from one azimuth to the next, 90° further.
PlaneElement quarter(double rx, double ry, const Vec2& centre, double outwards, double from,
                     int source);

}  // namespace planish::transition_detail
