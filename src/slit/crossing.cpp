#include "crossing.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/geometry/plane.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

// Whether strips go through each other, and planes that lead them apart (math.md#strip-conditions).
// Two strips cross if an edge of one pierces the inside of a quad of the other, by more than a
// margin, so that touching does not count. A plane stands at the neighbour's near border,
// perpendicular to the neighbour, beside each near ridge end of the strip; ends farther away than
// the strip is wide are free.

namespace planish::slit_detail {
namespace {

/// A quad with its corners in turn.
struct Quad {
  const Frame* frame = nullptr;
  std::array<Vec2, 4> flat;
  std::array<Vec3, 4> corners;
  Eigen::AlignedBox3d box;
};

std::vector<Quad> quads_of(const FoldedStrip& strip) {
  std::vector<Quad> quads;
  for (std::size_t i = 0; i < strip.quads.size(); ++i) {
    const SlitRidge &from = strip.ridges[i], &to = strip.ridges[i + 1];
    Quad quad{&strip.quads[i],
              {from.flat[0], to.flat[0], to.flat[1], from.flat[1]},
              {from.folded[0], to.folded[0], to.folded[1], from.folded[1]},
              {}};
    for (const Vec3& corner : quad.corners)
      quad.box.extend(corner);
    quads.push_back(quad);
  }
  return quads;
}

/// Inside the quad (counter-clockwise when flat) by more than the margin.
bool holds(const Quad& quad, const Vec2& p, double margin) {
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec2 side = quad.flat[(i + 1) % 4] - quad.flat[i], to = p - quad.flat[i];
    if (planish::cross(side, to) <= margin * side.norm()) return false;
  }
  return true;
}

/// How far inside a quad, and how far on both sides of it, an edge must reach to go through it.
struct Margins {
  double inside = 0.0, above = 0.0;
};

bool pierces(const Vec3& from, const Vec3& to, const Quad& quad, const Margins& margins) {
  const Vec3 a = quad.frame->local(from), b = quad.frame->local(to);
  if (std::min(a.z(), b.z()) >= -margins.above || std::max(a.z(), b.z()) <= margins.above)
    return false;
  const Vec3 through = a + a.z() / (a.z() - b.z()) * (b - a);
  return holds(quad, through.head<2>(), margins.inside);
}

bool edges_pierce(const Quad& a, const Quad& b, const Margins& margins) {
  for (std::size_t i = 0; i < 4; ++i)
    if (pierces(a.corners[i], a.corners[(i + 1) % 4], b, margins)) return true;
  return false;
}

double extent_of(const FoldedStrip& strip) {
  return (strip.ridges.back().flat[0] - strip.ridges.front().flat[1]).norm();
}

Vec3 nearest_on(const Vec3& a, const Vec3& b, const Vec3& p) {
  const Vec3 along = b - a;
  return a + std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0) * along;
}

}  // namespace

bool cross(const FoldedStrip& a, const FoldedStrip& b, double within) {
  const double touching = tolerance::kComputed * (extent_of(a) + extent_of(b));
  const Margins margins{std::max(within, touching), touching};
  const std::vector<Quad> first = quads_of(a), second = quads_of(b);
  for (const Quad& p : first)
    for (const Quad& q : second)
      if (p.box.intersects(q.box) && (edges_pierce(p, q, margins) || edges_pierce(q, p, margins)))
        return true;
  return false;
}

std::vector<HalfSpace> planes_beside(const FoldedStrip& strip, const FoldedStrip& neighbour,
                                     StripEdge where_neighbour_is) {
  const std::size_t own = where_neighbour_is == StripEdge::left ? 0 : 1, theirs = 1 - own;
  const double sense = own == 0 ? 1.0 : -1.0;
  double width = 0.0;
  for (const SlitRidge& ridge : strip.ridges)
    width = std::max(width, ridge.flat[1].y() - ridge.flat[0].y());
  std::vector<HalfSpace> planes;
  for (std::size_t ridge = 1; ridge < strip.ridges.size(); ++ridge) {
    const Vec3& p = strip.ridges[ridge].folded[own];
    double least = std::numeric_limits<double>::infinity();
    HalfSpace plane{static_cast<int>(ridge), static_cast<int>(own), Vec3::Zero(), 0.0};
    double height = 0.0;
    for (std::size_t quad = 0; quad < neighbour.quads.size(); ++quad) {
      const Vec3 foot = nearest_on(neighbour.ridges[quad].folded[theirs],
                                   neighbour.ridges[quad + 1].folded[theirs], p);
      if ((p - foot).norm() >= least) continue;
      least = (p - foot).norm();
      const Vec2 way = (neighbour.ridges[quad + 1].flat[theirs] -
                        neighbour.ridges[quad].flat[theirs])
                           .normalized();
      plane.normal = sense *
                     (way.x() * neighbour.quads[quad].y - way.y() * neighbour.quads[quad].x);
      plane.offset = plane.normal.dot(foot);
      height = std::abs(neighbour.quads[quad].z.dot(p - foot));
    }
    if (height < width && plane.normal.dot(p) < plane.offset) planes.push_back(plane);
  }
  return planes;
}

std::vector<HalfSpace> planes_before_mirror(int quads, double sign) {
  std::vector<HalfSpace> planes;
  for (int ridge = 1; ridge < quads; ++ridge)
    for (int side = 0; side < 2; ++side)
      planes.push_back({ridge, side, sign * Vec3::UnitX(), 0.0});
  return planes;
}

std::vector<HalfSpace> planes_above(int quads, double height) {
  std::vector<HalfSpace> planes;
  for (int ridge = 1; ridge <= quads; ++ridge)
    for (int side = 0; side < 2; ++side)
      planes.push_back({ridge, side, Vec3::UnitY(), height, true});
  return planes;
}

double depth_below(const FoldedStrip& strip, double height) {
  double depth = 0.0;
  for (const SlitRidge& ridge : strip.ridges)
    for (const Vec3& end : ridge.folded)
      depth = std::max(depth, height - end.y());
  return depth;
}

double depth_behind_mirror(const FoldedStrip& strip, double sign) {
  double depth = 0.0;
  for (const SlitRidge& ridge : strip.ridges)
    for (const Vec3& end : ridge.folded)
      depth = std::max(depth, -sign * end.x());
  return depth;
}

}  // namespace planish::slit_detail
