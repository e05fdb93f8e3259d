// Distance of a point in space from a border on its surface: samples along the border, then golden
// section about the nearest. It can only miss a second place that is equally near.

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

/// Coarse search, then golden section about the best sample.
double distance_on_bend(const SpaceBorder& border, const Vec3& p) {
  constexpr int kSamples = 64;
  constexpr int kRefinements = 45;
  constexpr double kGolden = 0.6180339887498949;
  const auto squared = [&](double t) { return (border.point(t) - p).squaredNorm(); };
  int best = 0;
  double least = squared(0.0);
  for (int i = 1; i <= kSamples; ++i) {
    const double d = squared(double(i) / kSamples);
    if (d >= least) continue;
    least = d;
    best = i;
  }
  double a = std::max(best - 1, 0) / double(kSamples);
  double b = std::min(best + 1, kSamples) / double(kSamples);
  for (int i = 0; i < kRefinements; ++i) {
    const double c = b - kGolden * (b - a), d = a + kGolden * (b - a);
    (squared(c) < squared(d) ? b : a) = squared(c) < squared(d) ? d : c;
  }
  return std::sqrt(std::min(least, squared((a + b) / 2)));
}

double distance_to(const SpaceBorder& border, const Vec3& p) {
  const auto* plane = std::get_if<Frame>(&border.face.surface);
  if (!plane) return distance_on_bend(border, p);
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
