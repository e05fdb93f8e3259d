// What takes area in a pattern: the images of faces, and of each sharp bend the band between the
// borders that it joins. With the reference skin outside the band is negative, since its faces
// reach over each other: then they may share its area. A band's sign is that of its ring against
// that of the face beside it, so it holds for patterns seen from either side.

#include "regions.hpp"

#include <planish/geometry/plane.hpp>
#include <planish/inspect/findings.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace planish::inspect_detail {
namespace {

void add_faces(const Sheet& sheet, const Layout& layout, double chord, Regions& regions) {
  for (const FaceId id : sheet.faces.ids()) {
    regions.polygons.push_back(polygon_of(layout.region(id), chord));
    regions.parts.push_back(sheet[id].part_of);
    regions.faces.emplace_back(id);
  }
}

/// A sharp bend has no face; its band lies between the borders that it joins.
void add_sharp_bends(const Sheet& sheet, const Layout& layout, Regions& regions) {
  for (const Joint& joint : sheet.joints) {
    if (!joint.sharp) continue;
    const Curve2& a = layout.image(joint.a);
    const Curve2& b = layout.image(joint.b);
    const std::vector<Vec2> strip{start_of(a), end_of(a), start_of(b), end_of(b)};
    // A face lies left of its borders, or right of them if the pattern shows the other side.
    const double turn = signed_area(layout.outline(joint.a.face));
    if ((ring_area(strip) < 0.0) == (turn < 0.0)) {
      regions.shared[std::minmax(joint.a.face, joint.b.face)] += std::abs(ring_area(strip));
    } else {
      regions.polygons.push_back({strip, {}});
      regions.parts.push_back(*joint.sharp);
      regions.faces.emplace_back(std::nullopt);
    }
  }
}

}  // namespace

double contact_clearance(const FlatPattern& pattern) {
  const double curves = 2.0 * FlattenOptions{}.curve_tolerance;
  return std::max(kContactShare * pattern.thickness, curves + 0.5 * pattern.closure);
}

Regions regions_of(const Sheet& sheet, const Layout& layout, double chord) {
  Regions regions;
  add_faces(sheet, layout, chord, regions);
  add_sharp_bends(sheet, layout, regions);
  return regions;
}

std::vector<Shared> shared_areas(const Regions& regions, double clearance) {
  std::vector<Shared> result;
  for (Overlap& overlap : overlaps(regions.polygons, clearance, clearance * clearance)) {
    const int first = overlap.first, second = overlap.second;
    // Shrinking both regions removed a rim as wide as the clearance from the shared area.
    double area = overlap.area;
    for (const auto& ring : overlap.outline)
      area += clearance *
              sum_of(sides_of(ring), [](const Segment& s) { return (s.b - s.a).norm(); });
    const auto allowed = regions.shared.find(
        std::minmax(regions.faces[first], regions.faces[second]));
    constexpr double kSameArea = 1e-6;  // left by shrinking and rounding
    if (allowed != regions.shared.end() && area <= allowed->second * (1.0 + kSameArea)) continue;
    const auto parts = std::minmax(regions.parts[first], regions.parts[second]);
    result.push_back({parts.first, parts.second, area, std::move(overlap)});
  }
  return result;
}

}  // namespace planish::inspect_detail
