#include "enclosure.hpp"
#include "meetings.hpp"
#include "triangle_tree.hpp"

#include <planish/base/assert.hpp>
#include <planish/collision/self_intersections.hpp>

#include <algorithm>
#include <optional>

// How deep a closed surface runs through itself (math.md#self-intersection). Pairs of faces, then
// of triangles, that are near each other propose points below both; a point that the surface
// encloses twice is in shared material, and the widest ball about it, stuck on all sides, is the
// depth there. So the triangles only propose, and a wrong proposal costs time, not truth. Of each
// pair of faces the deepest place is kept.

namespace planish {

using namespace collision_detail;

namespace {

/// Where to start from below a meeting, as a share of the depth: far less than what counts, so that
/// a corner of a shallow place is met, and beyond the rounding of surfaces that touch.
constexpr double kAside = 0.125;
/// So many places of one pair of faces are measured, to find the deepest.
constexpr int kMeasured = 8;
/// So many pairs of faces are more than anyone reads; the search ends with them.
constexpr std::size_t kEnough = 500;

struct FaceTriangles {
  TriangleTree tree;
  Box3 box;
  bool plane = true;
};

bool one_plane(const Mesh& mesh, const std::vector<int>& triangles, double within) {
  const Triangle first = triangle_of(mesh, triangles.front());
  return std::ranges::all_of(triangles, [&](int t) {
    const Triangle other = triangle_of(mesh, t);
    return first.normal.dot(other.normal) > 0.0 &&
           std::ranges::all_of(other.corners, [&](const Vec3& p) {
             return std::abs(first.normal.dot(p - first.corners[0])) <= within;
           });
  });
}

Box3 box_of(const Mesh& mesh, int triangle) {
  Box3 box;
  for (const int corner : mesh.triangles[triangle])
    box.extend(mesh.points[corner]);
  return box;
}

bool within_any(const std::vector<Box3>& places, const Box3& box) {
  return places.empty() ||
         std::ranges::any_of(places, [&](const Box3& place) { return place.intersects(box); });
}

class Search {
 public:
  Search(const MeshOfFaces& surface, double depth, const std::vector<Box3>& places)
      : mesh_(surface.mesh), depth_(depth) {
    std::vector<std::vector<int>> triangles;
    for (int t = 0; t < std::ssize(surface.face); ++t) {
      if (!within_any(places, box_of(mesh_, t))) continue;
      const auto face = static_cast<std::size_t>(surface.face[t]);
      if (face >= triangles.size()) triangles.resize(face + 1);
      triangles[face].push_back(t);
    }
    for (std::size_t face = 0; face < triangles.size(); ++face)
      if (!triangles[face].empty()) add(static_cast<int>(face), std::move(triangles[face]));
  }

  std::vector<SelfIntersection> all() {
    std::vector<SelfIntersection> found;
    const auto keep = [&](std::optional<SelfIntersection> one) {
      if (one) found.push_back(*one);
    };
    for (std::size_t i = 0; i < faces_.size(); ++i)
      if (!faces_[i].plane && found.size() < kEnough) keep(within(i));
    for (const auto& [i, j] : near_boxes(boxes_, depth_))
      if (found.size() < kEnough) keep(between(i, j));
    return found;
  }

 private:
  void add(int number, std::vector<int> triangles) {
    Box3 box;
    for (const int t : triangles)
      box.extend(box_of(mesh_, t));
    const bool plane = one_plane(mesh_, triangles, depth_);
    faces_.push_back({TriangleTree(mesh_, std::move(triangles)), box, plane});
    boxes_.push_back(box);
    numbers_.push_back(number);
  }

  std::optional<SelfIntersection> within(std::size_t face) {
    begin_pair(face, face);
    faces_[face].tree.visit_pairs(depth_, [&](int a, int b) { try_pair(a, b); });
    return best_;
  }

  std::optional<SelfIntersection> between(std::size_t one, std::size_t other) {
    begin_pair(one, other);
    faces_[one].tree.visit_pairs(faces_[other].tree, depth_, [&](int a, int b) { try_pair(a, b); });
    return best_;
  }

  void begin_pair(std::size_t one, std::size_t other) {
    pair_ = {std::min(numbers_[one], numbers_[other]), std::max(numbers_[one], numbers_[other])};
    measured_ = 0;
    best_.reset();
  }

  void try_pair(int a, int b) {
    if (measured_ >= kMeasured) return;
    const Triangle one = triangle_of(mesh_, a), other = triangle_of(mesh_, b);
    // Triangles of one spline surface that have a corner in common may be folded over each other.
    if (pair_[0] == pair_[1] && shared_corners(one, other) > 0) return;
    for (const Vec3& p : points_below_both(one, other, kAside * depth_, depth_))
      measure(p);
  }

  void measure(const Vec3& p) {
    if (!enclosure_) enclosure_.emplace(mesh_);
    if (enclosure_->times_enclosed(p) < 2) return;
    const Ball ball = enclosure_->widest_ball(p);
    if (2.0 * ball.radius < depth_) return;
    ++measured_;
    if (!best_ || 2.0 * ball.radius > best_->depth)
      best_ = SelfIntersection{pair_, 2.0 * ball.radius, ball.centre};
  }

  const Mesh& mesh_;
  double depth_;
  std::vector<FaceTriangles> faces_;
  std::vector<Box3> boxes_;
  std::vector<int> numbers_;            ///< of the faces, as given
  std::optional<Enclosure> enclosure_;  ///< made when first asked for: most solids need none
  std::array<int, 2> pair_{};
  int measured_ = 0;
  std::optional<SelfIntersection> best_;
};

}  // namespace

std::vector<SelfIntersection> find_self_intersections(const MeshOfFaces& surface, double depth,
                                                      const std::vector<Box3>& places) {
  PLANISH_ASSERT(depth > 0.0);
  PLANISH_ASSERT(surface.face.size() == surface.mesh.triangles.size());
  return Search(surface, depth, places).all();
}

}  // namespace planish
