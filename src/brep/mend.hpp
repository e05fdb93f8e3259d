#pragma once

#include <TopoDS_Shape.hxx>

namespace planish::brep {

/// How closely the shapes of a file fit.
struct Fit {
  double precision = 1e-7;         ///< mm: what belongs together meets within this, says the file
  double largest_tolerance = 1.0;  ///< mm: how far mending may open up a tolerance
};

/// A shape as it is read, and what had to be done to it.
struct Mended {
  TopoDS_Shape shape;
  int faces = 0;       ///< how many were mended one by one
  bool whole = false;  ///< whether the shape was mended as a whole, as the kernel does by default
};

/// The shape fit to be recognised: a closed solid whose faces are readable stays as it is; of one
/// whose faces are not all readable these are mended, each by itself; what does not close then is
/// mended as a whole, which looks at all pairs of loops of each face. Mending adds parameter curves
/// and tolerances to the edges of `shape` itself.
Mended mended(const TopoDS_Shape& shape, const Fit& fit);

/// A copy with parameter curves on all of its faces, which the kernel needs to mesh or to measure
/// them; the shape itself where it has them.
TopoDS_Shape with_parameter_curves(const TopoDS_Shape& shape);

/// A copy whose faces the kernel can mesh: with parameter curves that follow each other round each
/// loop. Files have them a period apart, or those of a seam exchanged. The faces keep their order.
TopoDS_Shape meshable(const TopoDS_Shape& shape);

}  // namespace planish::brep
