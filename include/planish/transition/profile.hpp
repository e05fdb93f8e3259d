#pragma once

#include <planish/geometry/frame.hpp>

#include <variant>
#include <vector>

namespace planish {

/// Corners, either way round. Edge i runs from corner i to corner i + 1. The second profile of a
/// transition may also be a ridge, of two corners, or an apex, of one.
struct PolygonProfile {
  std::vector<Vec2> corners;
};

/// About the origin. A circle has rx = ry.
struct EllipseProfile {
  double rx = 0.0, ry = 0.0;
};

/// A rectangle about the origin with rounded corners. Edges 0 … 3: bottom, right, top, left.
struct RoundedRectangleProfile {
  double width = 0.0, height = 0.0, radius = 0.0;
};

/// Two half circles with straight sides between them, centred on the origin; `length` overall,
/// along x.
struct ObroundProfile {
  double length = 0.0, width = 0.0;
};

/// The closed C² cubic spline through points, parametrised by chord length.
struct SplineProfile {
  std::vector<Vec2> points;
};

using Profile = std::variant<PolygonProfile, EllipseProfile, RoundedRectangleProfile,
                             ObroundProfile, SplineProfile>;

/// A profile in space: in the x–y plane of its frame.
struct PlacedProfile {
  Profile profile;
  Frame frame;
};

}  // namespace planish
