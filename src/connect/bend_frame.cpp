#include "bend_frame.hpp"

#include "tolerances.hpp"

#include <planish/geometry/plane.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

// The axes in which a bend is looked for (math.md#bend-frame). Crossing planes have one frame for
// each combination of sides of their intersection line on which the plates have corners; parallel
// planes one for each direction of an edge and each way to look from it. In such a frame a plate is
// an outline in (x, y), y the distance from the line, and the problem is plane. Angles below a
// limit count as parallel, since their line is out of reach.

namespace planish::connect_detail {
namespace {

// Planes at a smaller angle are parallel: their intersection line is out of reach.
constexpr double kParallel = kNegligible;
// Edges whose directions differ by less are parallel.
constexpr double kSameDirection = tolerance::kComputed;
// A plate that crosses the intersection line by less than this share of its extent counts as not
// crossing it.
constexpr double kOnLine = tolerance::kComputed;

Angle between(const Vec3& a, const Vec3& b) { return Angle::radians(angle_between(a, b)); }

Vec3 nearest_on_line(const PlacedPlate& a, const PlacedPlate& b, const Vec3& d) {
  // The point p of both planes nearest to the middle m: p = m + s·n_a + t·n_b.
  const Vec3 m = 0.5 * (a.frame.origin + b.frame.origin);
  const Vec3 na = a.frame.z, nb = b.frame.z;
  const double c = na.dot(nb), det = d.squaredNorm();  // 1 − c², without its cancellation
  const double ra = na.dot(a.frame.origin - m), rb = nb.dot(b.frame.origin - m);
  return m + (ra - c * rb) / det * na + (rb - c * ra) / det * nb;
}

// On which sides of the line (along +e, −e) a plate has material: signs.
std::vector<double> signs_of(const PlacedPlate& plate, const Vec3& origin, const Vec3& e) {
  double low = 0.0, high = 0.0;
  for (int i = 0; i < plate.edge_count(); ++i) {
    const double y = (plate.corner(i) - origin).dot(e);
    low = std::min(low, y);
    high = std::max(high, y);
  }
  std::vector<double> signs;
  if (high > kOnLine * plate.extent) signs.push_back(1.0);
  if (-low > kOnLine * plate.extent) signs.push_back(-1.0);
  if (signs.size() == 2 && -low > high) std::swap(signs[0], signs[1]);
  return signs;
}

std::vector<BendFrame> crossing_frames(const PlacedPlate& a, const PlacedPlate& b) {
  const Vec3 raw = a.frame.z.cross(b.frame.z);
  const Vec3 d = raw.normalized();
  const Vec3 origin = nearest_on_line(a, b, raw);
  const Vec3 ea = a.frame.z.cross(d), eb = b.frame.z.cross(d);
  std::vector<BendFrame> frames;
  for (const double sa : signs_of(a, origin, ea))
    for (const double sb : signs_of(b, origin, eb)) {
      BendFrame frame{origin, d, {sa * ea, sb * eb}, Vec3::Zero(), {}};
      frame.beta = between(frame.e[0], frame.e[1]);
      frames.push_back(frame);
    }
  return frames;
}

// Every y is made positive: the origin lies below both plates.
BendFrame parallel_frame(const PlacedPlate& a, const PlacedPlate& b, const Vec3& d, const Vec3& e) {
  double low = 0.0;
  for (const PlacedPlate* plate : {&a, &b})
    for (int i = 0; i < plate->edge_count(); ++i)
      low = std::min(low, (plate->corner(i) - a.frame.origin).dot(e));
  const Vec3 rise = (b.frame.origin - a.frame.origin).dot(a.frame.z) * a.frame.z;
  return {a.frame.origin + low * e, d, {e, e}, rise, {}};
}

std::vector<BendFrame> parallel_frames(const PlacedPlate& a, const PlacedPlate& b) {
  std::vector<Vec3> directions;
  std::vector<BendFrame> frames;
  for (const PlacedPlate* plate : {&a, &b})
    for (int i = 0; i < plate->edge_count(); ++i) {
      const Vec3 edge = plate->corner((i + 1) % plate->edge_count()) - plate->corner(i);
      const Vec3 flat = edge - edge.dot(a.frame.z) * a.frame.z;
      const Vec3 outward = flat.cross(plate->frame.z).normalized();
      const Vec3 e = (outward - outward.dot(a.frame.z) * a.frame.z).normalized();
      const auto same = [&](const Vec3& other) { return (other - e).norm() < kSameDirection; };
      if (std::ranges::any_of(directions, same)) continue;
      directions.push_back(e);
      frames.push_back(parallel_frame(a, b, e.cross(a.frame.z).normalized(), e));
    }
  return frames;
}

}  // namespace

PlanePair plane_pair(const PlacedPlate& a, const PlacedPlate& b, double planarity) {
  // Corners of both plates may lie off their planes, which lean the more the narrower they are.
  const double off = 2.0 * planarity, lean = a.frame.z.cross(b.frame.z).norm();
  const double narrower = std::min(a.area / a.extent, b.area / b.extent);
  if (lean > kParallel && lean * narrower > off) return PlanePair::crossing;
  double rise = std::numeric_limits<double>::infinity();
  for (int i = 0; i < b.edge_count(); ++i)
    rise = std::min(rise, std::abs((b.corner(i) - a.frame.origin).dot(a.frame.z)));
  return rise <= off ? PlanePair::coplanar : PlanePair::parallel;
}

std::optional<NearlyCoplanar> nearly_coplanar(const PlacedPlate& a, const PlacedPlate& b,
                                              double thickness) {
  constexpr Angle kLittle = Angle::degrees(1.0);
  NearlyCoplanar near;
  const double lean = a.frame.z.cross(b.frame.z).norm();
  near.angle = Angle::radians(std::atan2(lean, std::abs(a.frame.z.dot(b.frame.z))));
  for (int i = 0; i < b.edge_count(); ++i)
    near.off = std::max(near.off, std::abs(a.frame.local(b.corner(i)).z()));
  for (int i = 0; i < a.edge_count(); ++i)
    near.off = std::max(near.off, std::abs(b.frame.local(a.corner(i)).z()));
  if (near.angle > kLittle || near.off > thickness) return std::nullopt;
  return near;
}

bool runs_between(const PlacedPlate& a, const PlacedPlate& b) {
  const double least = -kNegligible * std::max(a.extent, b.extent);
  return std::ranges::any_of(bend_frames(a, b, PlanePair::crossing), [&](const BendFrame& frame) {
    return frame.beta > Angle::degrees(90) && box_of(side_outline(a, frame, 0)).lo.y() >= least &&
           box_of(side_outline(b, frame, 1)).lo.y() >= least;
  });
}

std::vector<BendFrame> bend_frames(const PlacedPlate& a, const PlacedPlate& b, PlanePair kind) {
  if (kind == PlanePair::crossing) return crossing_frames(a, b);
  if (kind == PlanePair::parallel) return parallel_frames(a, b);
  return {};
}

std::vector<Vec2> side_outline(const PlacedPlate& plate, const BendFrame& frame, int side) {
  return side_ring(plate, 0, frame, side);
}

std::vector<Vec2> side_ring(const PlacedPlate& plate, int ring, const BendFrame& frame, int side) {
  return mapped(plate.ring(ring),
                [&](const Vec2& p) { return frame.local(side, plate.frame.point(p)); });
}

std::vector<Chain> side_chains(const PlacedPlate& plate, const BendFrame& frame, int side) {
  std::vector<Chain> chains;
  for (int ring = 0; ring < plate.ring_count(); ++ring) {
    if (!plate.is_polygon(ring)) continue;
    for (Chain& chain : viable_chains(side_ring(plate, ring, frame, side))) {
      // The material lies outside a hole.
      if (ring > 0)
        chain.kind = chain.kind == EdgeKind::facing ? EdgeKind::averted : EdgeKind::facing;
      for (int& edge : chain.edges)
        edge = plate.edge_number({ring, edge});
      chains.push_back(std::move(chain));
    }
  }
  return chains;
}

}  // namespace planish::connect_detail
