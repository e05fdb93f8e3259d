#include "enclosure.hpp"

#include <planish/base/tolerance.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

// How often a surface encloses a point, and the room about it (math.md#self-intersection). Rays
// along three axes count where they leave less where they enter, and the least of the counts is
// taken, so that a gap that one of them meets encloses nothing twice; a ray that passes an edge
// does not count. A ball grows by moving away from all that it nearly touches, along the shortest
// vector of their directions' hull (Gilbert), and never leaves the ball before it.

namespace planish::collision_detail {
namespace {

/// A ray that passes a triangle's edge this near, of the surface's extent, does not count.
constexpr double kOnEdge = tolerance::kRounding;
/// Rays start this far aside, of the surface's extent, in no simple direction: parts often have
/// edges and corners in line with each other.
constexpr double kAside = tolerance::kComputed;

std::vector<int> all_of(const Mesh& mesh) {
  std::vector<int> numbers(mesh.triangles.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

struct RayMeeting {
  bool on_edge = false;
  int leaves = 0;  ///< 1 where the ray leaves, −1 where it enters, 0 where it misses
};

/// The ray from p along an axis and a triangle.
RayMeeting ray_meets(const Triangle& t, const Vec3& p, int axis, double on_edge) {
  const int x = (axis + 1) % 3, y = (axis + 2) % 3;
  std::array<double, 3> side;  // of each edge the ray passes; in the plane across the axis
  double least = HUGE_VAL, most = -HUGE_VAL;
  for (int i = 0; i < 3; ++i) {
    const Vec3 &from = t.corners[i], &to = t.corners[(i + 1) % 3];
    const double dx = to[x] - from[x], dy = to[y] - from[y];
    const double length = std::hypot(dx, dy);
    side[i] = length > 0.0 ? (dx * (p[y] - from[y]) - dy * (p[x] - from[x])) / length : 0.0;
    least = std::min(least, side[i]);
    most = std::max(most, side[i]);
  }
  if (least < -on_edge && most > on_edge) return {};
  // The height of the triangle's plane above p, along the axis.
  if (std::abs(t.normal[axis]) <= tolerance::kComputed) return {true, 0};
  const double ahead = t.normal.dot(t.corners[0] - p) / t.normal[axis];
  if (ahead < 0.0) return {};
  if (least <= on_edge && most >= -on_edge) return {true, 0};
  return {false, t.normal[axis] > 0.0 ? 1 : -1};
}

Vec3 nearest_on_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double square = along.squaredNorm();
  if (!(square > 0.0)) return a;
  return a + std::clamp(along.dot(p - a) / square, 0.0, 1.0) * along;
}

Vec3 nearest_on_triangle(const Vec3& p, const Triangle& t) {
  const Vec3 foot = p - t.normal.dot(p - t.corners[0]) * t.normal;
  bool inside = !t.normal.isZero();
  Vec3 nearest = t.corners[0];
  for (int i = 0; i < 3; ++i) {
    const Vec3 &from = t.corners[i], &to = t.corners[(i + 1) % 3];
    if (t.normal.cross(to - from).dot(foot - from) < 0.0) inside = false;
    const Vec3 on_edge = nearest_on_segment(p, from, to);
    if ((on_edge - p).squaredNorm() < (nearest - p).squaredNorm()) nearest = on_edge;
  }
  return inside ? foot : nearest;
}

/// The shortest vector of the convex hull of unit vectors: where to go so that one moves away from
/// all that they come from, as fast as possible; about zero where one is surrounded.
/// (Gilbert's iteration.)
Vec3 away_from_all(const std::vector<Vec3>& directions) {
  constexpr int kSteps = 60;
  Vec3 shortest = directions.front();
  for (int i = 0; i < kSteps; ++i) {
    const Vec3& worst = *std::ranges::min_element(directions, {},
                                                  [&](const Vec3& d) { return d.dot(shortest); });
    const Vec3 to = worst - shortest;
    const double square = to.squaredNorm();
    if (!(square > 0.0)) break;
    shortest += std::clamp(-shortest.dot(to) / square, 0.0, 1.0) * to;
  }
  return shortest;
}

}  // namespace

Enclosure::Enclosure(const Mesh& surface) : tree_(surface, all_of(surface)) {
  for (int t = 0; t < std::ssize(surface.triangles); ++t) {
    triangles_.push_back(triangle_of(surface, t));
    for (const Vec3& corner : triangles_.back().corners)
      box_.extend(corner);
  }
}

int Enclosure::times_enclosed(const Vec3& p) const {
  const double extent = box_.sizes().maxCoeff();
  const Vec3 start = p + kAside * extent * Vec3(0.5257, 0.3819, 0.7071);
  std::optional<int> least;
  for (int axis = 0; axis < 3; ++axis) {
    Box3 ray(start, start);
    ray.max()[axis] = box_.max()[axis];
    if (ray.isEmpty()) return 0;
    int count = 0;
    bool counts = true;
    tree_.visit(ray, [&](int t) {
      const RayMeeting meeting = ray_meets(triangles_[t], start, axis, kOnEdge * extent);
      count += meeting.leaves;
      counts = counts && !meeting.on_edge;
    });
    if (counts) least = std::min(least.value_or(count), count);
  }
  return least.value_or(0);
}

std::vector<Vec3> Enclosure::nearest_points(const Vec3& p, double radius) const {
  std::vector<Vec3> points;
  const Vec3 reach = Vec3::Constant(radius);
  tree_.visit(Box3(p - reach, p + reach), [&](int t) {
    const Vec3 nearest = nearest_on_triangle(p, triangles_[t]);
    if ((nearest - p).norm() <= radius) points.push_back(nearest);
  });
  return points;
}

Ball Enclosure::clear_ball(const Vec3& p, double most) const {
  double radius = most;
  for (const Vec3& q : nearest_points(p, most))
    radius = std::min(radius, (q - p).norm());
  return {p, radius};
}

Ball Enclosure::nearest_ball(const Vec3& p) const {
  const double extent = box_.sizes().maxCoeff();
  double most = tolerance::kWrittenDigits * extent;
  Ball ball = clear_ball(p, most);
  while (ball.radius == most && most < extent)
    ball = clear_ball(p, most *= 2.0);
  return ball;
}

Vec3 Enclosure::away_from_nearest(const Ball& ball, double touching) const {
  std::vector<Vec3> away = nearest_points(ball.centre, touching * ball.radius);
  for (Vec3& q : away)
    q = (ball.centre - q).normalized();
  return away.empty() ? Vec3(Vec3::Zero()) : away_from_all(away);
}

Ball Enclosure::widest_ball(const Vec3& p) const {
  constexpr double kLongestStep = 0.9, kShortestStep = 1e-3, kGain = 1e-4;  // of the radius
  constexpr double kSurrounded = 0.02;
  constexpr int kSteps = 200;
  // What the ball touches, or soon will, of its radius: less and less as it gets stuck.
  constexpr double kFirstTouch = 0.05, kLastTouch = 0.002, kFiner = 0.2;
  double touch = kFirstTouch, step = kLongestStep;
  Ball ball = nearest_ball(p);
  for (int i = 0; i < kSteps; ++i) {
    const Vec3 direction = away_from_nearest(ball, 1.0 + touch);
    if (step <= kShortestStep || direction.norm() < kSurrounded) {
      if (touch < kLastTouch) break;
      touch *= kFiner;
      step = touch;
      continue;
    }
    const double moved = step * ball.radius;  // what was clear before limits what can be clear now
    const Ball next = clear_ball(ball.centre + moved * direction.normalized(),
                                 2.0 * (ball.radius + moved));
    if (next.radius > (1.0 + kGain * step) * ball.radius) {
      ball = next;
      step = std::min(kLongestStep, 2.0 * step);
    } else {
      step *= 0.5;
    }
  }
  return ball;
}

}  // namespace planish::collision_detail
