#pragma once

#include "solid_model.hpp"

#include <planish/geometry/mesh.hpp>
#include <planish/geometry/region.hpp>

namespace planish::brep {

/// A coarse outline of a face in its own parameters, u scaled to millimetres: enough to find
/// opposite faces. Empty for doubly curved faces.
struct Outline {
  std::vector<std::vector<Vec3>> rings;  ///< points in space, by loop
  std::vector<std::vector<Vec2>> flat;   ///< the same in (u·scale, v)
  double u_scale = 1.0;                  ///< |∂x/∂u| at the middle of the face
  double u_middle = 0.0;
  double area = 0.0;
  Box2 box;                         ///< of `flat`
  int outer = 0;                    ///< the loop with the largest area
  Box3 space;                       ///< box in space
  Vec3 inner_point = Vec3::Zero();  ///< a border point, and the outward normal there
  Vec3 inner_normal = Vec3::UnitZ();
};

/// A box and what is at most `by` away along the axes.
inline Box3 enlarged(const Box3& box, double by) {
  return {box.min() - Vec3::Constant(by), box.max() + Vec3::Constant(by)};
}

/// Whether faces lie on surfaces of one kind. Offsets keep it: only such faces can be opposite.
bool same_kind(const SolidFace& a, const SolidFace& b);

std::vector<Outline> outlines_of(const SolidModel& model);

/// How a face B lies opposite a face A, seen from A through the material.
struct Opposite {
  double depth = 0.0;    ///< mean distance of B below A along A's inward normal, mm
  double spread = 0.0;   ///< largest − smallest depth over B's border
  double overlap = 0.0;  ///< area of A that B covers, mm²
};

/// Empty unless B faces away from A, lies below it and covers part of it.
std::optional<Opposite> opposite(const SolidModel& model, const std::vector<Outline>& outlines,
                                 int a, int b);

/// Depth of a point below a face, against its outward normal, mm. Planes and developables.
double depth_below(const SolidFace& face, const Outline& outline, const Vec3& point);

/// Outward unit normal of a plane or developable face at the point of its surface nearest to
/// `point`.
Vec3 outward_normal_at(const SolidFace& face, const Vec3& point);

/// Index of a face's outer loop: the one with the largest area.
int outer_loop(const Outline& outline);

}  // namespace planish::brep
