#pragma once

#include <planish/base/result.hpp>
#include <planish/sheet/sheet.hpp>

#include <TopoDS_Solid.hxx>

namespace planish::brep {

struct ThickenOptions {
  double fit_tolerance = 5e-7;    ///< mm: curves and surfaces without a kernel primitive
  double shape_tolerance = 1e-6;  ///< mm: borders this near a ruling or a circle count as one
};

/// The solid between the two skins of a sheet: every face of the reference skin, the same face
/// `thickness` below, and a wall along every free border. Planes, cylinders and cones are the
/// kernel's own; joints share their edges, so nothing is sewn. Sharp joints are mitred. The result
/// has been checked: valid, closed, of positive volume. May throw the kernel's exceptions: call it
/// inside `guarded`.
/// Errors: `invalid_input` (thickness not positive, joints that do not fit), `unsupported_shape`
/// (an inside radius of zero or less; a curved border at a sharp joint; a mitre that becomes too
/// long), `internal` (the kernel finds the result invalid).
Result<TopoDS_Solid> thicken(const Sheet& sheet, const ThickenOptions& options = {});

}  // namespace planish::brep
