#include "joint_line.hpp"

#include <algorithm>

namespace planish::brep {

double off_ruling(const Face& face, const Curve2& border) {
  const Vec2 start = start_of(border);
  const Vec2 end = end_of(border);
  const auto* surface = std::get_if<Developable>(&face.surface);
  const double u = (start.x() + end.x()) / 2;
  constexpr int kSteps = 16;
  double off = 0.0;
  for (int i = 0; i <= kSteps; ++i) {
    const Vec2 p = point_at(border, static_cast<double>(i) / kSteps);
    off = std::max(off, surface
                            ? (point_on(*surface, p) - point_on(*surface, {u, p.y()})).norm()
                            : Eigen::ParametrizedLine<double, 2>::Through(start, end).distance(p));
  }
  return off;
}

Segment as_ruling(const Face& face, const Curve2& border) {
  Segment line{start_of(border), end_of(border)};
  if (std::holds_alternative<Developable>(face.surface))
    line.a.x() = line.b.x() = (line.a.x() + line.b.x()) / 2;
  return line;
}

}  // namespace planish::brep
