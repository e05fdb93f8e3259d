#include "plate_plane.hpp"

#include "hole_shape.hpp"
#include "refusals.hpp"

#include <planish/base/id_vector.hpp>
#include <planish/base/tolerance.hpp>
#include <planish/geometry/plane.hpp>
#include <planish/geometry/region.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

// A plate in the axes of its own plane. The normal is Newell's: twice the vector area, robust for
// corners nearly in one plane, from which each must be off by less than the planarity. Polygons may
// not cross themselves, nor come within rounding of each other; boxes part most pairs of holes
// first. Rings run as the frame sees them, and edge numbers remain those of the file.

namespace planish::connect_detail {
namespace {

using Ring = std::vector<Vec3>;

// Corners of a polygon nearer than this share of its extent are one corner.
constexpr double kSameCorner = tolerance::kFileDigits;
// How far a hole that is no polygon may lie outside the polygon that stands for it, mm.
constexpr double kChord = 1e-2;
// A polygon whose area is below this share of extent² is a line.
constexpr double kNoArea = tolerance::kComputed;

/// A polygon of a plate, as refusals name it: the outline, or a hole by its index.
struct PlateRing {
  const Ring& ring;
  const std::string& plate;  ///< id
  std::string pointer;
  std::optional<std::size_t> hole = std::nullopt;

  std::string name() const {
    return hole ? "hole " + std::to_string(*hole + 1) : std::string("the outline");
  }
  /// What is wrong with it, at a corner.
  Facts at_corner(std::size_t i) const {
    return {{"plate", place::at(place::plate(plate), ring[i])},
            {"ring", name()},
            {"corner", i + 1},
            {"at", place::point(ring[i])},
            {"field", place::pointer(corner_pointer(i))}};
  }
  /// At a place in space.
  Facts at(const Vec3& p) const {
    return {{"plate", place::at(place::plate(plate), p)},
            {"ring", name()},
            {"at", place::point(p)},
            {"field", place::pointer(pointer)}};
  }
  std::string corner_pointer(std::size_t i) const { return pointer + "/" + std::to_string(i); }
};

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
  Eigen::AlignedBox3d box;
  for (const Vec3& p : ring)
    box.extend(p);
  return box.sizes().norm();
}

Result<void> check_corners(const PlateRing& polygon) {
  const Ring& ring = polygon.ring;
  if (ring.size() < 3)
    return fail(refuse::few_corners, {{"plate", place::plate(polygon.plate)},
                                      {"ring", polygon.name()},
                                      {"corners", ring.size()},
                                      {"field", place::pointer(polygon.pointer)}});
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (!ring[i].allFinite())
      return fail(refuse::corner_not_finite,
                  {{"plate", place::plate(polygon.plate)},
                   {"ring", polygon.name()},
                   {"corner", i + 1},
                   {"field", place::pointer(polygon.corner_pointer(i))}});
  const double same = kSameCorner * extent_of(ring);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const std::size_t next = (i + 1) % ring.size();
    if ((ring[next] - ring[i]).norm() <= same) {
      Facts facts = polygon.at_corner(i);
      facts.emplace_back("next", next + 1);
      facts.emplace_back("repeated", place::pointer(polygon.corner_pointer(next)));
      return fail(refuse::corner_repeated, facts, polygon.corner_pointer(next));
    }
  }
  return {};
}

Result<void> check_planar(const PlateRing& polygon, const Frame& frame, double planarity) {
  const Ring& ring = polygon.ring;
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
  Facts facts = polygon.at_corner(worst);
  facts.emplace_back("off", most, unit::mm);
  facts.emplace_back("allowed", planarity, unit::mm);
  return fail(refuse::corner_off_plane, facts);
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

Result<void> check_simple(const PlateRing& polygon, const std::vector<Vec2>& ring,
                          const Frame& frame, double extent) {
  const auto crossings = self_crossings(ring);
  std::optional<Vec2> at;
  if (!crossings.empty()) at = crossings.front();
  if (const auto i = spike(ring, kSameCorner * extent)) at = ring[*i];
  // A corner that lies on another edge is touched, not crossed.
  for (std::size_t i = 0; !at && i < ring.size(); ++i)
    for (std::size_t j = i + 1; !at && j < ring.size(); ++j)
      if ((ring[i] - ring[j]).norm() <= kSameCorner * extent) at = ring[i];
  if (!at) return {};
  return fail(refuse::ring_crosses_itself, polygon.at(frame.point(*at)));
}

std::vector<Vec2> flat(const Ring& ring, const Frame& frame) {
  return mapped(ring, [&](const Vec3& p) { return frame.local2(p); });
}

// A place where the borders of two polygons cross, or come within `same`.
std::optional<Vec2> meeting(const std::vector<Vec2>& first, const std::vector<Vec2>& second,
                            double same) {
  for (const auto& [a, b] : sides_of(first))
    for (const auto& [c, d] : sides_of(second)) {
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

// `boxes` are those of the holes so far; the hole's own border may lie `off` its polygon.
Result<void> check_hole_apart(const PlacedPlate& placed, const std::vector<Box2>& boxes,
                              const std::vector<Vec2>& hole, double off, const PlateRing& polygon) {
  const double same = kSameCorner * placed.extent + off;
  const Box2 box = box_of(hole);
  const auto facts_at = [&](const Vec2& at) {
    Facts facts = polygon.at(placed.frame.point(at));
    facts.emplace_back("hole", *polygon.hole + 1);
    return facts;
  };
  if (const auto at = meeting(hole, placed.outline, same))
    return fail(refuse::hole_meets_outline, facts_at(*at));
  for (std::size_t h = 0; h < placed.holes.size(); ++h) {
    const double near = same + (placed.shapes[h].empty() ? 0.0 : kChord);
    if (apart(box, boxes[h], near)) continue;
    const auto& other = placed.holes[h];
    const auto at = meeting(hole, other, near);
    if (!at && !inside({other}, hole.front()) && !inside({hole}, other.front())) continue;
    Facts facts = facts_at(at.value_or(hole.front()));
    facts.emplace_back("other", h + 1);
    return fail(refuse::holes_meet, facts);
  }
  return {};
}

/// The curves of a hole that is no polygon.
Result<Loop> loop_of(const HoleShape& shape, const PlateRing& given, const Frame& frame,
                     double planarity) {
  for (std::size_t i = 0; i < given.ring.size(); ++i)
    if (!given.ring[i].allFinite()) return fail(refuse::corner_not_finite, given.at_corner(i));
  if (const double size = smallest_size(shape); !(size > 0.0))
    return fail(refuse::bad_value, {{"name", "A size of " + given.name()},
                                    {"value", size, unit::mm},
                                    {"range", "a value above 0"},
                                    {"field", place::pointer(given.pointer)}});
  if (auto planar = check_planar(given, frame, planarity); !planar) return pass_on(planar);
  return hole_loop(shape, frame);
}

// `ring` is the hole as a polygon, which a shape is near.
Result<void> add_hole(PlacedPlate& placed, const PlateRing& polygon, Loop shape, double planarity,
                      std::vector<Box2>& boxes) {
  if (auto sound = check_corners(polygon); !sound) return sound;
  if (auto planar = check_planar(polygon, placed.frame, planarity); !planar) return planar;
  std::vector<Vec2> hole = flat(polygon.ring, placed.frame);
  if (auto simple = check_simple(polygon, hole, placed.frame, placed.extent); !simple)
    return simple;
  for (std::size_t i = 0; i < hole.size(); ++i)
    if (!inside({placed.outline}, hole[i])) {
      Facts facts = polygon.at_corner(i);
      facts.emplace_back("hole", *polygon.hole + 1);
      return fail(refuse::hole_outside, facts);
    }
  const double off = shape.empty() ? 0.0 : kChord;
  if (auto apart = check_hole_apart(placed, boxes, hole, off, polygon); !apart) return apart;
  boxes.push_back(box_of(hole));
  placed.turned.push_back(ring_area(hole) > 0.0);
  if (placed.turned.back()) std::ranges::reverse(hole);
  placed.holes.push_back(std::move(hole));
  placed.shapes.push_back(std::move(shape));
  return {};
}

Result<void> add_holes(PlacedPlate& placed, const Plate& plate, const std::string& pointer,
                       double planarity) {
  std::vector<Box2> boxes;
  for (std::size_t h = 0; h < plate.holes.size(); ++h) {
    const std::string place = pointer + "/holes/" + std::to_string(h);
    Ring ring = plate.holes[h];
    Loop shape;
    if (const auto given = plate.shapes.find(h); given != plate.shapes.end()) {
      const Ring points = given_points(given->second);
      auto loop = loop_of(given->second, {points, plate.id, place, h}, placed.frame, planarity);
      if (!loop) return pass_on(loop);
      shape = std::move(*loop);
      ring = mapped(sampled(shape, kChord), [&](const Vec2& p) { return placed.frame.point(p); });
    }
    if (auto added = add_hole(placed, {ring, plate.id, place, h}, std::move(shape), planarity,
                              boxes);
        !added)
      return added;
  }
  return {};
}

// The number within a ring of `count` edges when it runs the other way; its own inverse.
int renumbered(int edge, int count) { return (2 * count - 2 - edge) % count; }

}  // namespace

Eigen::AlignedBox3d PlacedPlate::box() const {
  Eigen::AlignedBox3d box;
  for (const Vec2& p : outline)
    box.extend(frame.point(p));
  return box;
}

Vec3 PlacedPlate::corner(const EdgePlace& edge, int further) const {
  const int n = static_cast<int>(ring(edge.ring).size());
  return frame.point(ring(edge.ring)[((edge.corner + further) % n + n) % n]);
}

int PlacedPlate::edges_of(int r) const {
  return is_polygon(r) ? static_cast<int>(ring(r).size()) : 0;
}

int PlacedPlate::all_edges() const {
  int count = 0;
  for (int r = 0; r < ring_count(); ++r)
    count += edges_of(r);
  return count;
}

int PlacedPlate::edge_number(const EdgePlace& place) const {
  if (!numbers.empty()) return numbers[place.ring][place.corner];
  int before = 0;
  for (int r = 0; r < place.ring; ++r)
    before += edges_of(r);
  const bool other_way = place.ring > 0 && turned[place.ring - 1];
  const int count = edges_of(place.ring);
  return before + (other_way ? renumbered(place.corner, count) : place.corner);
}

EdgePlace PlacedPlate::place_of(int edge) const {
  for (int r = 0; r < std::ssize(numbers); ++r)
    if (const auto known = std::ranges::find(numbers[r], edge); known != numbers[r].end())
      return {r, static_cast<int>(known - numbers[r].begin())};
  int r = 0;
  while (edge >= edges_of(r))
    edge -= edges_of(r++);
  const bool other_way = r > 0 && turned[r - 1];
  return {r, other_way ? renumbered(edge, edges_of(r)) : edge};
}

Result<PlacedPlate> placed(const Plate& plate, const std::string& pointer, double planarity) {
  const PlateRing outline{plate.outline, plate.id, pointer + "/outline"};
  if (auto sound = check_corners(outline); !sound) return pass_on(sound);
  PlacedPlate result;
  result.extent = extent_of(plate.outline);
  const Vec3 area = vector_area(plate.outline);
  result.area = area.norm();
  if (result.area <= kNoArea * result.extent * result.extent)
    return fail(refuse::no_area,
                {{"plate", place::plate(plate.id)}, {"field", place::pointer(outline.pointer)}});
  result.frame = frame_from_axes(middle(plate.outline), area / result.area,
                                 plate.outline[1] - plate.outline[0]);
  if (auto planar = check_planar(outline, result.frame, planarity); !planar) return pass_on(planar);
  result.outline = flat(plate.outline, result.frame);
  if (auto simple = check_simple(outline, result.outline, result.frame, result.extent); !simple)
    return pass_on(simple);
  if (auto holes = add_holes(result, plate, pointer, planarity); !holes) return pass_on(holes);
  return result;
}

}  // namespace planish::connect_detail
