#pragma once

#include <planish/geometry/frame.hpp>

#include <gp_Ax2.hxx>
#include <gp_Ax3.hxx>
#include <gp_Dir.hxx>
#include <gp_Pnt.hxx>
#include <gp_Pnt2d.hxx>
#include <gp_Vec.hxx>

namespace planish::brep {

// Points, directions and frames as kernel types.

inline gp_Pnt kernel_point(const Vec3& p) { return {p.x(), p.y(), p.z()}; }
inline gp_Pnt2d kernel_point(const Vec2& p) { return {p.x(), p.y()}; }
inline gp_Dir kernel_direction(const Vec3& d) { return {d.x(), d.y(), d.z()}; }
inline gp_Ax2 kernel_axes(const Vec3& origin, const Vec3& z, const Vec3& x) {
  return {kernel_point(origin), kernel_direction(z), kernel_direction(x)};
}
inline gp_Ax3 kernel_frame(const Frame& f) { return kernel_axes(f.origin, f.z, f.x); }

inline Vec3 vector_of(const gp_XYZ& p) { return {p.X(), p.Y(), p.Z()}; }
inline Vec3 vector_of(const gp_Pnt& p) { return vector_of(p.XYZ()); }
inline Vec3 vector_of(const gp_Vec& v) { return vector_of(v.XYZ()); }

}  // namespace planish::brep
