#include "surface_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace planish::transition_detail {
namespace {

/// Facets of a strip, so that an arc of its widest radius leaves its chords by no more than
/// `chord`.
int facets_of(const Strip& strip, double chord) {
  if (strip.plane()) return 1;
  const double length = std::max(strip.border_length(0, 0.0, 1.0),
                                 strip.border_length(1, 0.0, 1.0));
  const double turn = strip.turn(0.0, 1.0), radius = length / turn;
  constexpr int kMost = 4096;
  const double widest = 2.0 * std::acos(std::max(0.0, 1.0 - chord / radius));
  return std::clamp(static_cast<int>(std::ceil(turn / widest)), 1, kMost);
}

class Mesher {
 public:
  Mesh run(const Ring& ring, double chord) {
    std::array<int, 2> first{}, last{};
    for (int i = 0; i < ring.count(); ++i) {
      const Strip& strip = ring.strip(i);
      const int facets = facets_of(strip, chord);
      if (i == 0) first = last = points(strip.ruling(0.0));
      for (int k = 1; k <= facets; ++k) {
        const bool closes = i + 1 == ring.count() && k == facets;
        const auto ruling = strip.ruling(double(k) / facets);
        const std::array<int, 2> next = closes ? first
                                               : std::array{
                                                     strip.stands(0) ? last[0] : point(ruling[0]),
                                                     strip.stands(1) ? last[1] : point(ruling[1])};
        add(last[0], next[0], next[1]);
        add(last[0], next[1], last[1]);
        last = next;
      }
    }
    return std::move(mesh_);
  }

 private:
  int point(const Vec3& p) {
    mesh_.points.push_back(p);
    return static_cast<int>(mesh_.points.size()) - 1;
  }
  std::array<int, 2> points(const std::array<Vec3, 2>& ruling) {
    return {point(ruling[0]), point(ruling[1])};
  }
  void add(int a, int b, int c) {
    if (a != b && b != c && c != a) mesh_.triangles.push_back({a, b, c});
  }

  Mesh mesh_;
};

}  // namespace

Mesh surface_mesh(const Ring& ring, double chord) { return Mesher().run(ring, chord); }

}  // namespace planish::transition_detail
