#include "profile_points.hpp"

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

// The profiles of a transition as polylines to drag. Arcs have a point at each quarter, so extents
// are exact. A spline is shown as the surface has it: by the border of the mesh nearest to the
// profile's plane.

namespace planish::job {
namespace {

constexpr int kPoints = 96;  // per full turn; a multiple of four, so that extents are exact

/// Appends `turns` quarters of an arc about `center` from the angle `start` (in quarters).
void append_arc(std::vector<Vec2>& points, const Vec2& center, double radius, int start,
                int quarters) {
  const int steps = kPoints / 4 * quarters;
  for (int i = 0; i <= steps; ++i) {
    const double angle = std::numbers::pi / 2 * (start + static_cast<double>(quarters * i) / steps);
    points.push_back(center + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
}

std::vector<Vec2> flat_points(const PolygonProfile& polygon) { return polygon.corners; }

std::vector<Vec2> flat_points(const EllipseProfile& ellipse) {
  std::vector<Vec2> points;
  for (int i = 0; i < kPoints; ++i) {
    const double angle = 2 * std::numbers::pi * i / kPoints;
    points.emplace_back(ellipse.rx * std::cos(angle), ellipse.ry * std::sin(angle));
  }
  return points;
}

std::vector<Vec2> flat_points(const RoundedRectangleProfile& rectangle) {
  const double x = rectangle.width / 2 - rectangle.radius,
               y = rectangle.height / 2 - rectangle.radius;
  std::vector<Vec2> points;
  append_arc(points, {x, -y}, rectangle.radius, 3, 1);
  append_arc(points, {x, y}, rectangle.radius, 0, 1);
  append_arc(points, {-x, y}, rectangle.radius, 1, 1);
  append_arc(points, {-x, -y}, rectangle.radius, 2, 1);
  return points;
}

std::vector<Vec2> flat_points(const ObroundProfile& obround) {
  const double r = obround.width / 2, x = obround.length / 2 - r;
  std::vector<Vec2> points;
  append_arc(points, {x, 0}, r, 3, 2);
  append_arc(points, {-x, 0}, r, 1, 2);
  return points;
}

std::vector<Vec2> flat_points(const SplineProfile& spline) { return spline.points; }

/// Triangle edges without a neighbour, by the corner at which they start.
std::map<int, int> border_sides(const Mesh& mesh) {
  std::map<std::pair<int, int>, int> sides;
  for (const auto& t : mesh.triangles)
    for (int i = 0; i < 3; ++i)
      sides[{t[i], t[(i + 1) % 3]}] = 1;
  std::map<int, int> border;
  for (const auto& [side, one] : sides)
    if (!sides.count({side.second, side.first})) border[side.first] = side.second;
  return border;
}

/// The border ring of the mesh nearest to the plane of `frame`.
std::vector<Vec3> border_near(const Mesh& mesh, const Frame& frame) {
  std::map<int, int> border = border_sides(mesh);
  std::vector<Vec3> best;
  double best_height = std::numeric_limits<double>::infinity();
  while (!border.empty()) {
    std::vector<Vec3> ring;
    double height = 0.0;
    for (auto side = border.begin(); side != border.end();) {
      ring.push_back(mesh.points[side->first]);
      height = std::max(height, std::abs(frame.local(ring.back()).z()));
      const int next = side->second;
      border.erase(side);
      side = border.find(next);
    }
    if (height < best_height) best = ring, best_height = height;
  }
  return best;
}

}  // namespace

std::vector<Vec3> profile_points(const PlacedProfile& profile, const Mesh& mesh) {
  if (std::holds_alternative<SplineProfile>(profile.profile) && !mesh.triangles.empty())
    return border_near(mesh, profile.frame);
  std::vector<Vec3> points;
  for (const Vec2& p :
       std::visit([](const auto& shape) { return flat_points(shape); }, profile.profile))
    points.push_back(profile.frame.point(p));
  return points;
}

}  // namespace planish::job
