#include "same_surface.hpp"

#include <planish/base/tolerance.hpp>

#include <cmath>

namespace planish::brep {
namespace {

/// Largest differences between two faces of one surface.
struct Agreement {
  double length = 0.0;  ///< mm
  double angle = 0.0;   ///< radians
};

Agreement agreement_of(const SolidFace& f, const SolidFace& g, double size) {
  constexpr double kRounded = 1e-4;  // mm: dimensions are rounded
  constexpr double kFitted = 10.0;   // times the deviation of fits, which locate an axis less
                                     // accurately
  constexpr double kAngle = 1e-3;
  return {tolerance::kFileDigits * size + kRounded + kFitted * (f.fitted + g.fitted), kAngle};
}

bool same(const Cylinder& a, const Cylinder& b, const Agreement& within) {
  if (1.0 - std::abs(a.frame.z.dot(b.frame.z)) > within.angle * within.angle) return false;
  const Vec3 d = b.frame.origin - a.frame.origin;
  return (d - d.dot(a.frame.z) * a.frame.z).norm() <= within.length &&
         std::abs(a.radius - b.radius) <= within.length;
}

bool same(const Cone& a, const Cone& b, const Agreement& within) {
  return (a.frame.origin - b.frame.origin).norm() <= within.length / std::sin(a.half_angle) &&
         std::abs(a.half_angle - b.half_angle) <= within.angle &&
         a.frame.z.dot(b.frame.z) > 1.0 - within.angle * within.angle;
}

bool same(const Ruled&, const Ruled&, const Agreement&) { return false; }

}  // namespace

bool same_surface(const SolidFace& f, const SolidFace& g, double size) {
  const auto* a = std::get_if<Developable>(&f.surface);
  const auto* b = std::get_if<Developable>(&g.surface);
  if (!a && !b) return true;
  if (!a || !b || a->index() != b->index() || f.sense != g.sense) return false;
  return std::visit(
      [&](const auto& first) {
        return same(first, std::get<std::decay_t<decltype(first)>>(*b), agreement_of(f, g, size));
      },
      *a);
}

}  // namespace planish::brep
