#include <planish/base/tolerance.hpp>
#include <planish/connect/connect.hpp>

#include <cmath>
#include <numbers>

namespace planish {
namespace {

constexpr double kFullTurn = 2.0 * std::numbers::pi;
constexpr double kSeam = 0.01;  // mm between the ends, at the smaller end of cones
constexpr double kClosed = tolerance::kComputed;  // rad by which a full turn may fall short

/// Radius of the surface where the face is narrowest; 0 for surfaces without azimuths.
double narrowest_radius(const Face& face, const Box2& box) {
  const auto* surface = std::get_if<Developable>(&face.surface);
  if (surface == nullptr) return 0.0;
  if (const auto* cylinder = std::get_if<Cylinder>(surface)) return cylinder->radius;
  if (const auto* cone = std::get_if<Cone>(surface)) return box.lo.y() * std::sin(cone->half_angle);
  return 0.0;
}

}  // namespace

Sheet with_open_seam(const Sheet& sheet) {
  require_valid(sheet);
  Sheet open = sheet;
  for (Face& face : open.faces) {
    const Box2 box = parameter_box(face);
    const double radius = narrowest_radius(face, box);
    if (radius <= 0.0 || box.size().x() < kFullTurn - kClosed) continue;
    // Only sections without plates close: their borders are segments along and across the rulings.
    const double share = 1.0 - kSeam / (kFullTurn * radius), first = box.lo.x();
    for (Border& border : face.loops.front())
      if (auto* segment = std::get_if<Segment>(&border.curve)) {
        segment->a.x() = first + share * (segment->a.x() - first);
        segment->b.x() = first + share * (segment->b.x() - first);
        border.edge_length.reset();
      }
  }
  return open;
}

}  // namespace planish
