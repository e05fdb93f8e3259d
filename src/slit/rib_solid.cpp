#include "rib_solid.hpp"

#include <planish/geometry/region.hpp>

#include <algorithm>
#include <utility>

namespace planish::slit_detail {

Mesh closed_mesh(const MouldRib& rib, const Frame& base) {
  Mesh mesh;
  const int count = static_cast<int>(rib.facets.size());
  mesh.points = {rib.facets.front()[0], rib.facets.front()[3]};
  for (const auto& facet : rib.facets)
    mesh.points.insert(mesh.points.end(), {facet[1], facet[2]});
  const int below = static_cast<int>(mesh.points.size());
  for (int i = 0; i < below; ++i)
    mesh.points.push_back(base.point(base.local2(mesh.points[i])));

  const Vec3 top = (rib.facets.front()[1] - rib.facets.front()[0])
                       .cross(rib.facets.front()[3] - rib.facets.front()[0]);
  const bool as_listed = top.dot(base.z) > 0.0;
  const auto add = [&](int a, int b, int c, int d) {
    if (!as_listed) std::swap(b, d);
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  };
  for (int i = 0; i < count; ++i) {
    const int left = 2 * i, right = left + 1;
    add(left, left + 2, right + 2, right);
    add(below + left, below + right, below + right + 2, below + left + 2);
    add(left, below + left, below + left + 2, left + 2);
    add(right, right + 2, below + right + 2, below + right);
  }
  add(0, 1, below + 1, below);
  add(2 * count, below + 2 * count, below + 2 * count + 1, 2 * count + 1);
  return mesh;
}

std::vector<Vec2> footprint_of(const MouldRib& rib, const Frame& base) {
  std::vector<Vec2> ring{base.local2(rib.facets.front()[0])};
  for (const auto& facet : rib.facets)
    ring.push_back(base.local2(facet[1]));
  for (auto facet = rib.facets.rbegin(); facet != rib.facets.rend(); ++facet)
    ring.push_back(base.local2((*facet)[2]));
  ring.push_back(base.local2(rib.facets.front()[3]));
  if (ring_area(ring) < 0.0) std::ranges::reverse(ring);
  return ring;
}

}  // namespace planish::slit_detail
