#pragma once

#include <planish/geometry/frame.hpp>

#include <TopoDS_Face.hxx>

namespace planish::brep {

/// ⅓∫(x − centre)·n dA over a face of any surface, mm³, n its outward normal. By Green's theorem in
/// the surface's parameters: along the borders the integral across the patch, span by span, by
/// Gauss rules, until borders agree within `error`. The kernel's own measures are off by several
/// per cent on surfaces of many spans (BRepGProp_Vinert) or do not always terminate
/// (BRepGProp_VinertGK).
double patch_volume(const TopoDS_Face& face, const Vec3& centre, double error);

/// The face's area, mm², in the same way.
double patch_area(const TopoDS_Face& face, double error);

}  // namespace planish::brep
