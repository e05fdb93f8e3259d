#include "dihedral.hpp"

#include "outline.hpp"

#include <cmath>

namespace planish::brep {

std::optional<double> dihedral(const SolidModel& model, int index) {
  const SolidEdge& edge = model.edges[index];
  if (edge.uses != 2 || edge.faces[0] == edge.faces[1]) return {};
  const SolidFace& f = model.faces[edge.faces[0]];
  const SolidFace& g = model.faces[edge.faces[1]];
  if (std::holds_alternative<DoublyCurved>(f.surface) ||
      std::holds_alternative<DoublyCurved>(g.surface))
    return {};
  const double t = (edge.curve.t0 + edge.curve.t1) / 2;
  const Vec3 point = edge.curve.point(t);
  const Vec3 n_f = outward_normal_at(f, point);
  const Vec3 n_g = outward_normal_at(g, point);
  // With f on the left of its run x, the direction into f is n × x.
  const Vec3 x = edge.forward[0] ? edge.curve.tangent(t) : Vec3(-edge.curve.tangent(t));
  const double angle = angle_between(n_f, n_g);
  return n_g.dot(n_f.cross(x)) > 0 ? -angle : angle;
}

bool smooth_edge(const SolidModel& model, int index) {
  // Two planes are one flange only if they are parallel: no real bend is smaller than this.
  constexpr double kSamePlane = 0.002;  // 0.1°
  const auto angle = dihedral(model, index);
  if (!angle) return false;
  const SolidEdge& edge = model.edges[index];
  const auto flat = [&](int f) { return std::holds_alternative<Frame>(model.faces[f].surface); };
  return std::abs(*angle) <
         (flat(edge.faces[0]) && flat(edge.faces[1]) ? kSamePlane : kSmoothAngle);
}

}  // namespace planish::brep
