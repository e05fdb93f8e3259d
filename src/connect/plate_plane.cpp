#include "plate_plane.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/geometry/plane.hpp>
#include <planish/geometry/region.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace planish::connect_detail {
namespace {

using Ring = std::vector<Vec3>;

// Corners of a polygon nearer than this share of its extent are one corner.
constexpr double kSameCorner = tolerance::kFileDigits;
// A polygon whose area is below this share of extent² is a line.
constexpr double kNoArea = tolerance::kComputed;

std::string text(const Vec3& p) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", p.x(), p.y(), p.z());
}

// Newell's method: twice the vector area, robust for corners that are nearly in one plane.
Vec3 vector_area(const Ring& ring) {
  Vec3 sum = Vec3::Zero();
  const Vec3 from = ring.front();
  for (std::size_t i = 0; i < ring.size(); ++i)
    sum += (ring[i] - from).cross(ring[(i + 1) % ring.size()] - from);
  return 0.5 * sum;
}

Vec3 middle(const Ring& ring) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& p : ring)
    sum += p;
  return sum / static_cast<double>(ring.size());
}

double extent_of(const Ring& ring) {
  Vec3 lo = ring.front(), hi = ring.front();
  for (const Vec3& p : ring) {
    lo = lo.cwiseMin(p);
    hi = hi.cwiseMax(p);
  }
  return (hi - lo).norm();
}

Result<void> check_corners(const Ring& ring, const std::string& pointer) {
  if (ring.size() < 3)
    return fail(ErrorCode::too_few_corners,
                fmt::format("a polygon needs at least 3 corners, this one has {}", ring.size()),
                pointer);
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (!ring[i].allFinite())
      return fail(ErrorCode::invalid_input, "a corner must be three finite numbers",
                  fmt::format("{}/{}", pointer, i));
  const double same = kSameCorner * extent_of(ring);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const std::size_t next = (i + 1) % ring.size();
    if ((ring[next] - ring[i]).norm() <= same)
      return fail(
          ErrorCode::repeated_corner,
          fmt::format("corners {} and {} are at the same place {}; a closed polygon does not "
                      "repeat a corner",
                      i, next, text(ring[i])),
          fmt::format("{}/{}", pointer, next));
  }
  return {};
}

Result<void> check_planar(const Ring& ring, const Frame& frame, const std::string& pointer,
                          double planarity) {
  std::size_t worst = 0;
  double most = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const double off = std::abs(frame.local(ring[i]).z());
    if (off > most) {
      most = off;
      worst = i;
    }
  }
  if (most <= planarity) return {};
  return fail(
      ErrorCode::not_planar,
      fmt::format("corner {} lies {:.4g} mm off the plane of the plate, {:.4g} mm are allowed: "
                  "a plate is flat",
                  worst, most, planarity),
      fmt::format("{}/{}", pointer, worst));
}

// A spike: two edges at one corner that run back over each other.
std::optional<std::size_t> spike(const std::vector<Vec2>& ring, double same) {
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 in = ring[i] - ring[(i + n - 1) % n], out = ring[(i + 1) % n] - ring[i];
    if (in.dot(out) < 0.0 && std::abs(cross(in, out)) <= same * std::max(in.norm(), out.norm()))
      return i;
  }
  return std::nullopt;
}

Result<void> check_simple(const std::vector<Vec2>& ring, const Frame& frame,
                          const std::string& pointer, double extent) {
  const auto crossings = self_crossings(ring);
  std::optional<Vec2> at;
  if (!crossings.empty()) at = crossings.front();
  if (const auto i = spike(ring, kSameCorner * extent)) at = ring[*i];
  // A corner that lies on another edge is touched, not crossed.
  for (std::size_t i = 0; !at && i < ring.size(); ++i)
    for (std::size_t j = i + 1; !at && j < ring.size(); ++j)
      if ((ring[i] - ring[j]).norm() <= kSameCorner * extent) at = ring[i];
  if (!at) return {};
  return fail(ErrorCode::self_crossing,
              fmt::format("the polygon crosses or touches itself at {}", text(frame.point(*at))),
              pointer);
}

std::vector<Vec2> flat(const Ring& ring, const Frame& frame) {
  std::vector<Vec2> corners;
  for (const Vec3& p : ring)
    corners.push_back(frame.local2(p));
  return corners;
}

// A place where the borders of two polygons cross, or come within `same`.
std::optional<Vec2> meeting(const std::vector<Vec2>& first, const std::vector<Vec2>& second,
                            double same) {
  const auto next = [](const std::vector<Vec2>& ring, std::size_t i) -> const Vec2& {
    return ring[(i + 1) % ring.size()];
  };
  for (std::size_t i = 0; i < first.size(); ++i)
    for (std::size_t j = 0; j < second.size(); ++j) {
      const Vec2 &a = first[i], &b = next(first, i), &c = second[j], &d = next(second, j);
      if (distance(a, Segment{c, d}) <= same) return a;
      if (distance(c, Segment{a, b}) <= same) return c;
      const double ca = cross(b - a, c - a), da = cross(b - a, d - a), ac = cross(d - c, a - c),
                   bc = cross(d - c, b - c);
      if (ca * da < 0.0 && ac * bc < 0.0) return Vec2(c + ca / (ca - da) * (d - c));
    }
  return std::nullopt;
}

bool apart(const Box2& a, const Box2& b, double by) {
  return ((a.lo - b.hi).array() > by).any() || ((b.lo - a.hi).array() > by).any();
}

// `boxes` are those of the holes so far.
Result<void> check_hole_apart(const PlacedPlate& placed, const std::vector<Box2>& boxes,
                              const std::vector<Vec2>& hole, const std::string& place) {
  const double same = kSameCorner * placed.extent;
  const Box2 box = box_of(hole);
  if (const auto at = meeting(hole, placed.outline, same))
    return fail(
        ErrorCode::self_crossing,
        fmt::format("the hole touches or crosses the plate's outline at {}: leave material between",
                    text(placed.frame.point(*at))),
        place);
  for (std::size_t h = 0; h < placed.holes.size(); ++h) {
    if (apart(box, boxes[h], same)) continue;
    const auto& other = placed.holes[h];
    const auto at = meeting(hole, other, same);
    if (!at && !inside({other}, hole.front()) && !inside({hole}, other.front())) continue;
    return fail(ErrorCode::self_crossing,
                fmt::format("the hole overlaps or touches hole {} at {}: make them one", h,
                            text(placed.frame.point(at.value_or(hole.front())))),
                place);
  }
  return {};
}

Result<void> add_holes(PlacedPlate& placed, const Plate& plate, const std::string& pointer,
                       double planarity) {
  std::vector<Box2> boxes;
  for (std::size_t h = 0; h < plate.holes.size(); ++h) {
    const std::string place = fmt::format("{}/holes/{}", pointer, h);
    const Ring& ring = plate.holes[h];
    if (auto sound = check_corners(ring, place); !sound) return sound;
    if (auto planar = check_planar(ring, placed.frame, place, planarity); !planar) return planar;
    std::vector<Vec2> hole = flat(ring, placed.frame);
    if (auto simple = check_simple(hole, placed.frame, place, placed.extent); !simple)
      return simple;
    for (std::size_t i = 0; i < hole.size(); ++i)
      if (!inside({placed.outline}, hole[i]))
        return fail(ErrorCode::invalid_input,
                    fmt::format("corner {} of the hole at {} lies outside the plate's outline", i,
                                text(ring[i])),
                    fmt::format("{}/{}", place, i));
    if (auto apart = check_hole_apart(placed, boxes, hole, place); !apart) return apart;
    boxes.push_back(box_of(hole));
    placed.turned.push_back(ring_area(hole) > 0.0);
    if (placed.turned.back()) std::reverse(hole.begin(), hole.end());
    placed.holes.push_back(std::move(hole));
  }
  return {};
}

// The number within a ring of `count` edges when it runs the other way; its own inverse.
int renumbered(int edge, int count) { return (2 * count - 2 - edge) % count; }

}  // namespace

int PlacedPlate::all_edges() const {
  int count = 0;
  for (int r = 0; r < ring_count(); ++r)
    count += static_cast<int>(ring(r).size());
  return count;
}

int PlacedPlate::edge_number(const EdgePlace& place) const {
  int before = 0;
  for (int r = 0; r < place.ring; ++r)
    before += static_cast<int>(ring(r).size());
  const bool other_way = place.ring > 0 && turned[place.ring - 1];
  const int count = static_cast<int>(ring(place.ring).size());
  return before + (other_way ? renumbered(place.corner, count) : place.corner);
}

EdgePlace PlacedPlate::place_of(int edge) const {
  int r = 0;
  while (edge >= static_cast<int>(ring(r).size()))
    edge -= static_cast<int>(ring(r++).size());
  const bool other_way = r > 0 && turned[r - 1];
  return {r, other_way ? renumbered(edge, static_cast<int>(ring(r).size())) : edge};
}

Result<PlacedPlate> placed(const Plate& plate, const std::string& pointer, double planarity) {
  const std::string place = pointer + "/outline";
  if (auto sound = check_corners(plate.outline, place); !sound)
    return tl::unexpected(sound.error());
  PlacedPlate result;
  result.extent = extent_of(plate.outline);
  const Vec3 area = vector_area(plate.outline);
  result.area = area.norm();
  if (result.area <= kNoArea * result.extent * result.extent)
    return fail(ErrorCode::self_crossing,
                "the outline encloses no area: its corners lie on one line, or it crosses itself",
                place);
  result.frame = frame_from_axes(middle(plate.outline), area / result.area,
                                 plate.outline[1] - plate.outline[0]);
  if (auto planar = check_planar(plate.outline, result.frame, place, planarity); !planar)
    return tl::unexpected(planar.error());
  result.outline = flat(plate.outline, result.frame);
  if (auto simple = check_simple(result.outline, result.frame, place, result.extent); !simple)
    return tl::unexpected(simple.error());
  if (auto holes = add_holes(result, plate, pointer, planarity); !holes)
    return tl::unexpected(holes.error());
  return result;
}

}  // namespace planish::connect_detail
