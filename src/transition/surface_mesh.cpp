#include "surface_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>

// A mesh of the surface without a seam, facets between rulings. A patch has as many as an arc of
// its widest radius needs to keep within the chord. Points are shared where a side stands still,
// about a corner, and at the end of the ring, so each side is a closed chain and the mesh has two
// borders.

namespace planish::transition_detail {
namespace {

/// Number of facets of a patch, such that an arc of its widest radius deviates from its chords by
/// at most `chord`.
int facets_of(const RuledPatch& patch, double chord) {
  if (patch.plane()) return 1;
  const double length = std::max(patch.border_length(0, 0.0, 1.0),
                                 patch.border_length(1, 0.0, 1.0));
  const double turn = patch.turn(0.0, 1.0), radius = length / turn;
  constexpr int kMost = 4096;
  const double widest = 2.0 * std::acos(std::max(0.0, 1.0 - chord / radius));
  return std::clamp(static_cast<int>(std::ceil(turn / widest)), 1, kMost);
}

/// Indices of both ends of a ruling in a mesh.
using Ends = Eigen::Vector2i;

int add_point(Mesh& mesh, const Vec3& p) {
  mesh.points.push_back(p);
  return static_cast<int>(mesh.points.size()) - 1;
}

/// The facets between two rulings.
void add_facets(Mesh& mesh, const Ends& a, const Ends& b) {
  for (const std::array<int, 3>& facet : {std::array{a[0], b[0], b[1]}, {a[0], b[1], a[1]}})
    if (facet[0] != facet[1] && facet[1] != facet[2] && facet[2] != facet[0])
      mesh.triangles.push_back(facet);
}

/// The last patch that moves along a side: at its end the side is complete.
int last_moving(const Ring& ring, int side) {
  int i = ring.count() - 1;
  while (i > 0 && ring.patch(i).stands(side))
    --i;
  return i;
}

}  // namespace

Mesh surface_mesh(const Ring& ring, double chord) {
  Mesh mesh;
  Ends first;
  for (int side = 0; side < 2; ++side)
    first[side] = add_point(mesh, ring.patch(0).ruling(0.0)[side]);
  const Ends closing(last_moving(ring, 0), last_moving(ring, 1));
  Ends last = first;
  for (int i = 0; i < ring.count(); ++i) {
    const RuledPatch& patch = ring.patch(i);
    const int facets = facets_of(patch, chord);
    for (int k = 1; k <= facets; ++k) {
      const std::array<Vec3, 2> ruling = patch.ruling(double(k) / facets);
      Ends next = last;  // an end that stands still keeps its point
      for (int side = 0; side < 2; ++side)
        if (!patch.stands(side))
          next[side] = i == closing[side] && k == facets ? first[side]
                                                         : add_point(mesh, ruling[side]);
      add_facets(mesh, last, next);
      last = next;
    }
  }
  return mesh;
}

}  // namespace planish::transition_detail
