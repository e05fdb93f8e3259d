#pragma once

#include "border_curve.hpp"

#include <Geom2d_Curve.hxx>
#include <Geom_Surface.hxx>

#include <array>

namespace planish::brep {

/// How far both skins lie below the reference surface.
struct Depths {
  double first = 0.0, second = 0.0;
  explicit Depths(const Sheet& sheet)
      : first(-sheet.reference_depth), second(sheet.thickness - sheet.reference_depth) {}
  double between() const { return second - first; }
};

/// The cut edge of the sheet along one free border: the surface between the border on the reference
/// skin and on the other one, and the curves of its four edges in that surface (null on planes,
/// which need none). Parameters: those of the border for the two long edges; 0 … length for the
/// two straight ones across the thickness, from the reference skin to the other.
struct SideWall {
  Handle(Geom_Surface) surface;
  Handle(Geom2d_Curve) on_reference, on_other, at_start, at_end;
  /// Direction out of the material at the middle of the border.
  Vec3 outward = Vec3::Zero();
  /// Surface parameters of that middle.
  Vec2 middle = Vec2::Zero();
};

/// Wall along a straight border whose corners are those of the solid (they differ from the skin's
/// own where a sharp joint mitres them): a plane, or a ruled surface when the four points leave a
/// plane by more than `tolerance`. Corners: start and end on the reference skin, then on the other.
SideWall straight_wall(const std::array<Vec3, 4>& corners, const Vec3& outward, double tolerance);

/// Wall along a curved border between two depths: a plane, cylinder or cone along circles; along
/// planar splines an extrusion; otherwise a ruled surface.
struct CurvedWall {
  SideWall wall;
  /// Both long edges where the wall was fitted; otherwise null.
  Handle(Geom_Curve) reference_edge, other_edge;
};
CurvedWall curved_wall(const Face& face, const BorderCurve& border, const Depths& depths,
                       double tolerance);

/// Direction out of the material across the border at parameter s, in the skin's tangent plane: to
/// the right of the border's direction, seen from outside.
Vec3 outward_across(const Face& face, const BorderCurve& border, double s);

}  // namespace planish::brep
