// Distance of a point in space from a border on its surface: samples along the border, then golden
// section about the nearest. It can only miss a second place that is equally near.

#include <planish/geometry/minimum.hpp>
#include <planish/sheet/certificate.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

// How far a point is from a border's edge in space, as the certificate asks of a made sheet, whose
// borders are its own edges. On flanges the plane curve answers exactly; on bends a coarse search
// picks the sample about which golden section refines.

namespace planish {
namespace {

struct SpaceBorder {
  Face face;  // its surface only
  Curve2 curve;
  double depth = 0.0;

  Vec3 point(double t) const {
    const Vec2 uv = point_at(curve, t);
    return skin_point(face, uv) - depth * outward_normal(face, uv);
  }
};

double distance_to(const SpaceBorder& border, const Vec3& p) {
  const auto* plane = std::get_if<Frame>(&border.face.surface);
  if (!plane) {
    constexpr int kSamples = 64, kSteps = 45;
    const auto distance = [&](double t) { return (border.point(t) - p).norm(); };
    return distance(least_at(distance, 0.0, 1.0, kSamples, kSteps));
  }
  const Vec3 local = plane->local(p);
  return std::hypot(nearest(border.curve, local.head<2>()).distance, local.z() + border.depth);
}

}  // namespace

EdgeDistance border_distance(const Sheet& sheet) {
  std::map<int, std::vector<SpaceBorder>> edges;
  for (const Face& face : sheet.faces) {
    Face surface_only;
    surface_only.surface = face.surface;
    surface_only.sense = face.sense;
    for (const BorderLoop& loop : face.loops)
      for (const Border& border : loop)
        if (border.edge)
          edges[*border.edge].push_back({surface_only, border.curve, border.edge_depth});
  }
  return [edges = std::move(edges)](int edge, const Vec3& p) {
    double least = std::numeric_limits<double>::infinity();
    const auto found = edges.find(edge);
    if (found == edges.end()) return least;
    for (const SpaceBorder& border : found->second)
      least = std::min(least, distance_to(border, p));
    return least;
  };
}

}  // namespace planish
