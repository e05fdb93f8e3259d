#pragma once

#include "fitted_curve.hpp"
#include "sheet_corners.hpp"

#include <planish/sheet/sheet.hpp>

#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>

#include <functional>

namespace planish::brep {

/// A point `depth` below the reference skin (towards the material, along the outward normal).
Vec3 point_below(const Face& face, const Vec2& uv, double depth);

/// The surface of a face `depth` below the reference skin, as the kernel has it: plane, cylinder,
/// cone, or a B-spline within `tolerance`; its normal is that of the face's surface. `carried`
/// turns a curve in the face's (u, v), run over 0 … length, into one in the surface's parameters,
/// of which u is the same. B-splines stop short of an edge of regression beside the face, even if
/// the rectangle of its (u, v) would contain it. Requires: not past a cylinder's axis or a cone's
/// apex.
struct SkinSurface {
  Handle(Geom_Surface) surface;
  std::function<Handle(Geom2d_Curve)(const Handle(Geom2d_Curve)&, double length)> carried;
};
SkinSurface skin_surface(const Face& face, double depth, double tolerance);

/// Smallest radius of curvature of the skin `depth` below the reference skin within the face, mm;
/// not positive if that skin would fold over. Infinite for planes; ruled faces are checked along
/// their borders.
double smallest_radius(const Face& face, double depth);

/// A circle in space run from `start` (a unit vector) counter-clockwise seen from `axis`.
struct SpaceCircle {
  Vec3 center, axis, start;
  double radius = 0.0;
};

/// One border of a face, run over the parameter 0 … `length`, in (u, v) and in space alike.
struct BorderCurve {
  enum class Shape { line, circle, planar_spline, general };
  Shape shape = Shape::general;
  Handle(Geom2d_Curve) uv;
  double length = 0.0;

  Vec2 at(double s) const;
};

/// Lines (on planes, along rulings) have their length as parameter, circles (on planes, around
/// cylinders and cones) their angle. A border counts as a ruling or a circle if it deviates from it
/// by less than `tolerance`.
BorderCurve border_curve(const Face& face, const Curve2& border, double tolerance);

/// The circle of a border of shape `circle` at that depth.
SpaceCircle circle_below(const Face& face, const BorderCurve& border, double depth);

/// The border in space at that depth, with its parameter; `general` ones within `tolerance`.
Handle(Geom_Curve)
    space_curve_below(const Face& face, const BorderCurve& border, double depth, double tolerance);

/// The points of two depths together, fitted as one path over the border's parameter: coordinates
/// 0–2 and 3–5.
FittedPath fit_two_depths(const Face& face, const BorderCurve& border, double depth0, double depth1,
                          double tolerance);

/// The same border seen from the face across a joint, with the parameter of `border`: its points
/// are those of `border`, its (u, v) those of `other`. `reversed_other` is the border as `other`
/// has it, reversed; it is used if its points agree within `tolerance`, or as well as its ends do.
/// Otherwise, if it runs at another speed, `border` is projected onto `other`.
Handle(Geom2d_Curve) across_joint(const Face& face, const BorderCurve& border, const Face& other,
                                  const Curve2& reversed_other, double tolerance);

/// A border in its own face's surface, with the parameter of the edge that it shares: null on
/// planes, otherwise the curve of the border that leads its joint, `leading`, or that across the
/// joint.
Handle(Geom2d_Curve)
    curve_in_own_face(const Sheet& sheet, const SheetCorners& corners, BorderId border,
                      const BorderCurve& leading, double tolerance);

}  // namespace planish::brep
